// Tests the whole window offscreen with random input: mouse, keys, controls, text, files and sizes.
// Nothing crashes, every state of an object has the same bytes whenever it is reached, and in the
// end undo gives back the first object byte for byte. PECTIN_TEST_SEED chooses the first input.
#include <gtest/gtest.h>
#include <malloc.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "io/obj_writer.h"
#include "support/offscreen.h"
#include "support/offscreen_window.h"
#include "support/random_mesh.h"
#include "support/scratch_folder.h"
#include "support/test_run.h"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#include <sanitizer/allocator_interface.h>
#define PECTIN_COUNTS_BYTES
#endif
#endif

namespace pectin {
namespace {

using test::OffscreenWindow;
using test::Random;

// Random drags must not make objects that take minutes.
constexpr std::uint64_t kBudget = 12'000;
constexpr std::uint64_t kMaxFaces = 30'000;

std::size_t bytes_in_use() {
#ifdef PECTIN_COUNTS_BYTES
    return __sanitizer_get_current_allocated_bytes();
#else
    return mallinfo2().uordblks;
#endif
}

// A user without any plan.
class RandomUser {
  public:
    RandomUser(OffscreenWindow& window, Random& random, const ScratchFolder& folder)
        : window_(window), random_(random), folder_(folder) {}

    // One input, sometimes followed by a frame as if the user waited.
    void act() {
        const bool is_bored = window_.editor().has_dialog() && random_.chance(0.15);
        const int kind = is_bored ? 95 : random_.integer(0, 99);
        if (kind < 24) {
            move();
        } else if (kind < 36) {
            press_or_release();
        } else if (kind < 50) {
            drag();
        } else if (kind < 58) {
            click_on_text();
        } else if (kind < 64) {
            scroll();
        } else if (kind < 78) {
            shortcut();
        } else if (kind < 86) {
            any_key();
        } else if (kind < 92) {
            type();
        } else if (kind < 96) {
            key(Key::escape);
        } else {
            rare();
        }
        if (random_.chance(0.1)) window_.frame();
    }

    // Ends whatever goes on, so that commands can be executed.
    void let_go() {
        for (const MouseButton button :
             {MouseButton::left, MouseButton::middle, MouseButton::right}) {
            give(event::Release{button, at_, {}});
        }
        for (const int held : held_keys_) give(event::KeyUp{Key{held}});
        held_keys_.clear();
        for (int i = 0; i < 12; ++i) key(Key::escape);
    }

  private:
    void give(const InputEvent& input) { window_.give(input); }

    Modifiers modifiers() {
        const bool has_any = random_.chance(0.25);
        const bool shift = random_.chance(0.5), control = random_.chance(0.5);
        return {.shift = has_any && shift,
                .control = has_any && control,
                .alt = has_any && random_.chance(0.3)};
    }
    void move() {
        const Vec2 size(window_.size());
        if (random_.chance(0.5)) {  // near the last place
            at_ += Vec2{random_.uniform(-40, 40), random_.uniform(-40, 40)};
        } else if (random_.chance(0.5)) {  // at the object
            at_ = size * Vec2{random_.uniform(0.35, 0.65), random_.uniform(0.3, 0.7)};
        } else {
            at_ = size * Vec2{random_.uniform(-0.05, 1.05), random_.uniform(-0.05, 1.05)};
        }
        give(event::MouseMove{at_, modifiers()});
    }
    void press_or_release() {
        const int which = random_.integer(0, 9);
        const MouseButton button = which < 7   ? MouseButton::left
                                   : which < 9 ? MouseButton::middle
                                               : MouseButton::right;
        if (random_.chance(0.5)) {
            give(event::Press{button, at_, modifiers()});
        } else {
            give(event::Release{button, at_, modifiers()});
        }
    }
    void drag() {
        const Vec2 size(window_.size());
        const Vec2 from = size * Vec2{random_.uniform(0.4, 0.6), random_.uniform(0.35, 0.65)};
        at_ = from + Vec2{random_.uniform(-120, 120), random_.uniform(-120, 120)};
        window_.drag(from, at_, modifiers());
    }
    void click_on_text() {
        const auto texts = window_.texts();
        if (texts.empty()) return;
        at_ =
            texts[static_cast<std::size_t>(random_.integer(0, static_cast<int>(texts.size()) - 1))]
                .centre();
        window_.click(at_, modifiers());
    }
    void scroll() {
        give(event::Scroll{
            random_.chance(0.1) ? random_.uniform(-200, 200) : random_.uniform(-3, 3), at_});
    }
    void shortcut() {
        const auto actions = all_actions();
        const ActionInfo& info = actions[static_cast<std::size_t>(
            random_.integer(0, static_cast<int>(kActionCount) - 1))];
        // A new object ends the history of the one before.
        const bool is_new = info.menu == Menu::new_object || info.menu == Menu::examples;
        if (is_new && random_.chance(0.8)) return;
        const Shortcut& shortcut = info.shortcuts[static_cast<std::size_t>(random_.integer(0, 1))];
        if (!shortcut.exists()) return window_.editor().perform(info.action);
        if (shortcut.character != 0) {
            return give(event::Character{static_cast<unsigned char>(shortcut.character)});
        }
        key(shortcut.key, shortcut.modifiers);
    }
    void key(Key which, Modifiers held = {}) {
        give(event::KeyDown{which, held});
        give(event::KeyUp{which});
    }
    // A key that may stay down for a while, or that was never pressed.
    void any_key() {
        const int which =
            random_.chance(0.6) ? random_.integer('A', 'Z') : random_.integer(256, 282);
        if (random_.chance(0.6)) {
            give(event::KeyDown{Key{which}, modifiers(), random_.chance(0.2)});
            held_keys_.insert(which);
        } else {
            give(event::KeyUp{Key{which}});
            held_keys_.erase(which);
        }
    }
    // No slash is among the letters, so a file is always in the folder of the browser.
    void type() {
        static constexpr std::string_view kLetters = "ab7 .-0[]wxp";
        for (int i = random_.integer(1, 5); i > 0; --i) {
            const auto which = random_.integer(0, static_cast<int>(kLetters.size()) - 1);
            give(event::Character{
                static_cast<unsigned char>(kLetters[static_cast<std::size_t>(which)])});
        }
    }
    void rare() {
        switch (random_.integer(0, 7)) {
            case 0:
                return window_.resize({random_.integer(1, 1600), random_.integer(1, 1000)});
            case 1:
                return window_.resize({random_.integer(700, 1300), random_.integer(500, 800)});
            case 2:
                return give(event::Focus{random_.chance(0.5)});
            case 3:
                return give(event::Leave{});
            case 4:
                return give(event::Drop{{folder_.path(random_.chance(0.5) ? "a.obj" : "bad.obj")}});
            case 5:
                return key(Key::enter);
            case 6:
                if (random_.chance(0.1)) give(event::Close{});
                return;
            default:
                return give(event::Resize{{0, 0}});
        }
    }

    OffscreenWindow& window_;
    Random& random_;
    const ScratchFolder& folder_;
    Vec2 at_{640, 360};
    std::set<int> held_keys_;
};

class WindowSoak : public testing::Test {
  protected:
    void SetUp() override {
        folder_.write("a.obj",
                      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
        folder_.write("bad.obj", "v 0 0 zero\n");
        folder_.write("folder/b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        before_ = std::filesystem::current_path();
        std::filesystem::current_path(folder_.path());
        try {
            host_ = make_offscreen_host();
        } catch (const ContextError&) {
            // Then nothing is drawn.
        }
    }
    void TearDown() override { std::filesystem::current_path(before_); }

    // One window until this many inputs or until it is closed. Returns the number of inputs.
    int use_window(const OffscreenWindow::Options& options, std::chrono::milliseconds max_edit_time,
                   int inputs, Random& random) {
        OffscreenWindow window(options);
        window.editor().workspace().set_max_edit_time(max_edit_time);
        std::optional<test::WindowPainter> painter;
        if (host_) painter.emplace(host_->gl(), window);
        RandomUser user(window, random, folder_);
        states_.clear();
        limit(window.editor());
        int done = 0;
        while (done < inputs && !window.editor().document().wants_to_end()) {
            SCOPED_TRACE("input " + std::to_string(done));
            user.act();
            ++done;
            keep_in_folder(window.editor());
            limit(window.editor());
            expect_known_state(window.editor());
            dialogs_ += window.editor().has_dialog() ? 1 : 0;
            if (painter && done % 40 == 0) painter->draw();
            if (HasFailure()) return done;
        }
        finish(window, user);
        return done;
    }

    std::size_t states_seen_ = 0, steps_undone_ = 0, dialogs_ = 0;

  private:
    static bool is_at_rest(const Editor& editor) {
        return !editor.is_working() && !editor.session().is_dragging();
    }
    // Files are written to the scratch folder only.
    void keep_in_folder(Editor& editor) const {
        FileBrowser* const browser = editor.document().browser();
        if (browser && !browser->folder().starts_with(folder_.path())) {
            browser->open_folder(folder_.path());
        }
    }
    // Keeps the object small and all of its history.
    static void limit(Editor& editor) {
        if (!is_at_rest(editor)) return;
        const Session& session = editor.session();
        if (session.history().limit()) editor.execute(command::History{Setting::off()});
        if (session.adapt_settings().budget > kBudget) {
            editor.execute(command::Adapt{.budget = kBudget});
        }
        if (session.mesh().face_count() > kMaxFaces) {
            editor.execute(command::Shape{command::Shape::Kind::sphere, 3});
        }
    }
    // The object of a state is the same whenever that state is reached.
    void expect_known_state(const Editor& editor) {
        if (!is_at_rest(editor)) return;
        const History& history = editor.session().history();
        if (history.state_id() == last_state_) return;
        last_state_ = history.state_id();
        const std::string bytes = format_obj(editor.session().mesh());
        if (history.step_number() == 0) first_ = bytes;
        const auto [known, is_new] = states_.insert({last_state_, std::hash<std::string>{}(bytes)});
        states_seen_ += is_new ? 1 : 0;
        EXPECT_EQ(known->second, std::hash<std::string>{}(bytes)) << "state " << last_state_;
    }
    void finish(OffscreenWindow& window, RandomUser& user) {
        Editor& editor = window.editor();
        while (editor.is_working()) window.frame();
        if (!editor.document().wants_to_end()) user.let_go();
        while (editor.is_working()) window.frame();
        expect_known_state(editor);
        ASSERT_FALSE(editor.session().is_dragging());
        Session& session = editor.workspace().session();
        ASSERT_EQ(session.mesh().validate(), std::vector<std::string>{});
        while (session.undo_count() > 0) {
            ASSERT_TRUE(session.execute(command::Undo{}));
            ++steps_undone_;
            expect_known_state(editor);
        }
        EXPECT_EQ(session.history().lost_undo_count(), 0u);
        EXPECT_TRUE(format_obj(session.mesh()) == first_) << "the first object";
        expect_steady_history(session);
        if (!editor.document().wants_to_end()) expect_rest(window);
    }
    // Once arrays have the size that they need, redoing and undoing all steps takes no further
    // memory, and gives back the first object each time. What is lost in each round would show in
    // all of them. One may grow, since a thread that has not worked before takes memory of its own.
    void expect_steady_history(Session& session) const {
        constexpr int kRounds = 6;
        std::size_t before = 0;
        int grown = 0;  // rounds, apart from the first two
        for (int round = 0; round < kRounds; ++round) {
            while (session.execute(command::Redo{})) continue;
            while (session.execute(command::Undo{})) continue;
            session.take_dirty();  // as a picture does
            const std::size_t now = bytes_in_use();
            if (round > 1 && now > before) ++grown;
            before = now;
        }
        EXPECT_LE(grown, 1);
        EXPECT_TRUE(format_obj(session.mesh()) == first_) << "the first object, again";
    }
    // A window without input takes no further memory.
    static void expect_rest(OffscreenWindow& window) {
        constexpr int kFrames = 200;
        for (int i = 0; i < kFrames; ++i) window.frame();
        const std::size_t before = bytes_in_use();
        for (int i = 0; i < kFrames; ++i) window.frame();
        EXPECT_LE(bytes_in_use(), before);
    }

    ScratchFolder folder_;
    std::filesystem::path before_;
    std::unique_ptr<OffscreenHost> host_;
    std::uint64_t last_state_ = ~std::uint64_t{0};
    std::map<std::uint64_t, std::size_t> states_;  // hashes of the objects
    std::string first_;                            // the present object without steps
};

TEST_F(WindowSoak, RandomInputNeitherCrashesNorLosesTheFirstObject) {
    const int wanted = test::is_long() ? 10'000 : 1'500;
    constexpr int kPerWindow = 250;
    const char* const first = std::getenv("PECTIN_TEST_SEED");
    std::uint64_t seed = first ? std::strtoull(first, nullptr, 10) : 21'000;
    int done = 0, windows = 0;
    for (; done < wanted; ++seed, ++windows) {
        Random random(seed);
        std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
        std::fflush(stdout);  // a crash would not print the trace
        SCOPED_TRACE("seed " + std::to_string(seed));
        const bool uses_background = seed % 2 == 1;
        const std::chrono::milliseconds longest =
            uses_background ? std::chrono::milliseconds(0) : std::chrono::hours(1);
        const IVec2 size{random.integer(640, 1280), random.integer(480, 800)};
        const OffscreenWindow::Options options{.size = size,
                                               .scale = random.chance(0.2) ? 2.0f : 1.0f,
                                               .max_blocking_time = longest,
                                               .resolution = 3};
        done += use_window(options, longest, std::min(kPerWindow, wanted - done), random);
        if (HasFailure()) return;
    }
    std::printf(
        "%d inputs in %d windows: %zu states of objects, %zu steps undone at the end, %zu "
        "inputs in dialogs\n",
        done, windows, states_seen_, steps_undone_, dialogs_);
    EXPECT_GT(states_seen_, static_cast<std::size_t>(wanted / 50));
    EXPECT_GT(steps_undone_, static_cast<std::size_t>(wanted / 100));
    EXPECT_GT(dialogs_, static_cast<std::size_t>(wanted / 20));
}

}  // namespace
}  // namespace pectin
