#include "window/desktop.h"

#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <sstream>
#include <thread>

#include "support/paths.h"
#include "support/scratch_folder.h"

namespace pectin {

using namespace std::chrono_literals;

namespace {

// Time between two steps of a drag, so that frames are drawn while the mouse moves, as with a user.
// No test depends on it.
constexpr std::chrono::milliseconds kMoment = 50ms;

bool is_installed(const std::string& program) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (::access((folder + "/" + program).c_str(), X_OK) == 0) return true;
    }
    return false;
}

}  // namespace

std::string missing_for_windows() {
    for (const char* program : {"Xvfb", "xdotool"}) {
        if (!is_installed(program)) return std::string(program) + " is not installed";
    }
    if (Process({"/usr/bin/python3", "-c", "import Xlib"}, {}).wait() != 0) {
        return "python3-xlib is not installed";
    }
    return {};
}

Desktop::Desktop() {
    constexpr int kFirst = 100, kNumbers = 800, kTries = 20;
    for (int i = 0; i < kTries; ++i) {
        const std::string display = ":" + std::to_string(kFirst + (::getpid() + i) % kNumbers);
        server_.emplace(std::vector<std::string>{"Xvfb", display, "-screen", "0", "1280x800x24",
                                                 "-nolisten", "tcp", "-noreset",
                                                 // no repeated keys when xdotool is delayed
                                                 "-r"},
                        Environment{});
        // The tests always use Mesa's own rasteriser. Leaks of other drivers cannot be suppressed
        // by name, because drivers are unloaded before the leak check.
        environment_ = {{"DISPLAY", display},
                        {"WAYLAND_DISPLAY", ""},
                        {"LIBGL_ALWAYS_SOFTWARE", "1"},
                        {"ASAN_OPTIONS", "detect_leaks=0"}};
        const auto has_ended = [this] { return server_->wait(0ms).has_value(); };
        const bool answers =
            eventually([&] { return has_ended() || xdotool({"getdisplaygeometry"}) == 0; });
        if (answers && !has_ended()) return;  // otherwise the display belongs to another process
    }
    environment_.clear();
}

int Desktop::xdotool(const std::vector<std::string>& words) const {
    std::vector<std::string> all{"xdotool"};
    all.insert(all.end(), words.begin(), words.end());
    const int status = Process(all, environment_).wait().value_or(-1);
    std::this_thread::sleep_for(kMoment);
    return status;
}

bool Desktop::drop(const std::string& path) const {
    const std::vector<std::string> words{"/usr/bin/python3",
                                         test::source_path("tests/window/drop_file.py"), path};
    const int status = Process(words, environment_).wait().value_or(-1);
    std::this_thread::sleep_for(kMoment);
    return status == 0;
}

std::string Desktop::screen_digest(int left, int top, int right, int bottom) const {
    const ScratchFolder folder;
    std::vector<std::string> words{"/usr/bin/python3",
                                   test::source_path("tests/window/screen_digest.py"),
                                   folder.path("digest")};
    for (const int number : {left, top, right, bottom}) words.push_back(std::to_string(number));
    if (Process(words, environment_).wait() != 0) return "";
    return folder.read("digest");
}

void Desktop::move(int x, int y) const {
    xdotool({"mousemove", std::to_string(x), std::to_string(y)});
}
void Desktop::press(int button) const { xdotool({"mousedown", std::to_string(button)}); }
void Desktop::release(int button) const { xdotool({"mouseup", std::to_string(button)}); }
void Desktop::key(const std::string& name) const { xdotool({"key", name}); }
void Desktop::hold(const std::string& name) const { xdotool({"keydown", name}); }
void Desktop::release_key(const std::string& name) const { xdotool({"keyup", name}); }
void Desktop::type(const std::string& text) const { xdotool({"type", "--delay", "30", text}); }

void Desktop::drag(int from_x, int from_y, int to_x, int to_y) const {
    constexpr int kSteps = 5;
    move(from_x, from_y);
    press();
    for (int i = 1; i <= kSteps; ++i) {
        move(from_x + i * (to_x - from_x) / kSteps, from_y + i * (to_y - from_y) / kSteps);
    }
    release();
}

bool Desktop::shows_window() const {
    return eventually([this] {
        return xdotool({"search", "--onlyvisible", "--class", "pectin"}) == 0;
    });
}

}  // namespace pectin
