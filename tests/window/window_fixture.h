// The real window on a virtual display, with simulated mouse and keyboard input.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/ui/interface.h"
#include "replay/program.h"
#include "support/paths.h"
#include "window/desktop.h"

namespace pectin {

inline constexpr int kMiddleX = 640, kMiddleY = 400;

class WindowTest : public testing::Test {
  protected:
    void SetUp() override {
        if (const std::string missing = missing_for_windows(); !missing.empty()) {
            GTEST_SKIP() << "the window cannot be tested here: " << missing;
        }
        desktop_ = std::make_unique<Desktop>();
        ASSERT_TRUE(desktop_->is_running()) << "Xvfb does not start";
    }
    void TearDown() override {
        const bool has_words = folder_.holds("err") && !folder_.read("err").empty();
        if (HasFailure() && has_words) std::cerr << "pectin said: " << folder_.read("err");
    }

    void open_window(const std::vector<std::string>& arguments = {}) {
        std::filesystem::remove(path("record.jsonl"));
        open_window_beside_record(arguments);
    }
    void open_window_beside_record(std::vector<std::string> arguments = {}) {
        arguments.insert(arguments.begin(),
                         {test::program_path(), "--record", path("record.jsonl")});
        Environment environment = desktop_->environment();
        environment.emplace_back("XDG_STATE_HOME", path("state"));
        environment.emplace_back("XDG_CONFIG_HOME", path("config"));
        start(arguments, environment);
    }
    void start(const std::vector<std::string>& words, const Environment& environment) {
        program_ = std::make_unique<Process>(words, environment, path("err"));
        ASSERT_TRUE(desktop_->shows_window());
        ASSERT_TRUE(eventually([&] { return recorded("\"shape\"") + recorded("\"open\"") > 0; }));
        desktop_->move(kMiddleX, kMiddleY);
    }
    // Saves with the file browser, typing the path.
    void save_as(const std::string& name) {
        desktop_->key("ctrl+shift+s");
        desktop_->type(path(name));
        desktop_->key("Return");
        ASSERT_TRUE(eventually([&] { return folder_.holds(name); })) << record();
        ASSERT_TRUE(records(name));
    }
    // Where a control of the panels is in a new window, as the panels lay it out here.
    static Vec2 place_of(const std::string& name) {
        constexpr IVec2 kWindow{1280, 800};
        Editor editor;
        editor.handle(event::Resize{kWindow});
        editor.begin("");
        Interface interface(1.0f);
        interface.set_size(kWindow, kWindow);
        for (int i = 0; i < 3; ++i) interface.lay_out(editor, {});
        const Control* const control = interface.controls().find(name);
        EXPECT_TRUE(control) << name;
        return control ? 0.5 * (control->min + control->max) : Vec2{0.0};
    }
    void click(const Vec2& at) const {
        desktop_->move(static_cast<int>(at.x), static_cast<int>(at.y));
        desktop_->press();
        desktop_->release();
    }
    void double_click(const Vec2& at) const {
        click(at);
        desktop_->press();
        desktop_->release();
    }
    void quit() {
        desktop_->key("ctrl+q");
        ASSERT_EQ(program_->wait(), 0);
    }
    // Waits until the program has handled all input so far.
    void wait_until_handled() {
        desktop_->move(kMiddleX, kMiddleY);
        const std::size_t before = recorded("\"brush\"");
        desktop_->key("bracketleft");
        ASSERT_TRUE(records("\"brush\"", before + 1)) << record();
    }
    // Replays the record with another path for its last save, and returns the file it writes there.
    std::string replayed() const {
        std::string script = record();
        const std::size_t line = script.rfind("{\"cmd\": \"save\"");
        const std::size_t begin = script.find("\"path\": ", line), end = script.find('}', begin);
        script.replace(begin, end - begin, "\"path\": \"replayed.obj\"");
        folder_.write("replay.jsonl", script);
        const Outcome outcome = run_program({"replay", path("replay.jsonl")});
        EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
        return folder_.read("replayed.obj");
    }

    std::string path(const std::string& name) const { return folder_.path(name); }
    std::string record() const { return folder_.read("record.jsonl"); }
    std::size_t recorded(const std::string& what) const {
        const std::string text = folder_.holds("record.jsonl") ? record() : "";
        std::size_t count = 0;
        for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; ++at) ++count;
        return count;
    }
    // The last line of the record with this command; empty if there is none.
    std::string last(const std::string& command) const {
        const std::string text = folder_.holds("record.jsonl") ? record() : "";
        const std::size_t begin = text.rfind("{\"cmd\": \"" + command + "\"");
        if (begin == text.npos) return "";
        return text.substr(begin, text.find('\n', begin) - begin);
    }
    bool records(const std::string& what, std::size_t times = 1) const {
        return eventually([&] { return recorded(what) >= times; });
    }
    Process& program() { return *program_; }
    const Desktop& desktop() const { return *desktop_; }
    const ScratchFolder& folder() const { return folder_; }
    // Number of files that are kept for recovery.
    std::size_t recovery_files() const {
        const std::set<std::string> files = folder_.files();
        return static_cast<std::size_t>(std::count_if(
            files.begin(), files.end(),
            [](const std::string& name) { return name.starts_with("state/pectin/"); }));
    }

  private:
    ScratchFolder folder_;
    std::unique_ptr<Desktop> desktop_;
    std::unique_ptr<Process> program_;
};

}  // namespace pectin
