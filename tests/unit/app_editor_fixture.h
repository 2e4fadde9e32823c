// An Editor with simulated mouse and keyboard input.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <utility>

#include "app/editor.h"
#include "command/script.h"
#include "support/editor_tools.h"
#include "support/scratch_folder.h"

namespace pectin {

namespace fs = std::filesystem;
inline constexpr IVec2 kSize{1280, 800};
inline constexpr Vec2 kMiddle{640, 400}, kBeside{20, 780};

// An Editor that is set up by prepare(Editor&) when it is made, since it cannot be moved later.
class PreparedEditor : public Editor {
  public:
    template <typename Prepare>
    PreparedEditor(std::optional<Recorder> recorder, std::chrono::milliseconds max_blocking_time,
                   Prepare prepare)
        : Editor(std::move(recorder), max_blocking_time) {
        prepare(static_cast<Editor&>(*this));
    }
};

class EditorTest : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_.path(name); }
    void write(const std::string& name, const std::string& text) const {
        folder_.write(name, text);
    }
    std::string read(const std::string& name) const { return folder_.read(name); }
    // The editor shows a sphere of the given resolution.
    PreparedEditor editor(std::optional<Recorder> recorder = {}, int resolution = 3) const {
        return prepared_editor(std::move(recorder), resolution, [](Editor&) {});
    }
    // The same, and prepare(Editor&) sets it up further.
    template <typename Prepare>
    PreparedEditor prepared_editor(std::optional<Recorder> recorder, int resolution,
                                   Prepare prepare) const {
        // No work on files continues in the background.
        return PreparedEditor(std::move(recorder), std::chrono::hours(1), [&](Editor& made) {
            made.handle(event::Resize{kSize});
            made.document().new_shape(command::Shape::Kind::sphere, resolution);
            prepare(made);
        });
    }
    static void drag(Editor& editor, const Vec2& from, const Vec2& to, Modifiers modifiers = {}) {
        press(editor, from, modifiers);
        for (int i = 1; i <= 4; ++i) move(editor, from + i / 4.0 * (to - from), modifiers);
        editor.handle(event::Release{MouseButton::left, to, modifiers});
        editor.advance();
    }
    static void press(Editor& editor, const Vec2& at, Modifiers modifiers = {}) {
        editor.handle(event::MouseMove{at, modifiers});
        editor.advance();
        editor.handle(event::Press{MouseButton::left, at, modifiers});
        editor.advance();
    }
    static void move(Editor& editor, const Vec2& at, Modifiers modifiers = {}) {
        editor.handle(event::MouseMove{at, modifiers});
        editor.advance();
    }
    static void key(Editor& editor, Key key, Modifiers modifiers = {}) {
        editor.handle(event::KeyDown{key, modifiers});
        editor.handle(event::KeyUp{key});
        editor.advance();
    }

    // Returns the mesh that replaying a record gives.
    Session replayed(const std::string& name) const {
        Session session;
        std::istringstream text(read(name));
        ScriptReader reader(text);
        while (const auto line = reader.next()) {
            const Done done = session.execute(std::get<Command>(line->command));
            EXPECT_TRUE(done) << done.refusal().reason;
        }
        return session;
    }
    // Returns the last command of a record.
    Command last_of(const std::string& name) const {
        std::istringstream text(read(name));
        ScriptReader reader(text);
        Command last;
        while (const auto line = reader.next()) last = std::get<Command>(line->command);
        return last;
    }

  private:
    ScratchFolder folder_;
};

}  // namespace pectin
