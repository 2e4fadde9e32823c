#include "window/desktop.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace pectin {

using namespace std::chrono_literals;

namespace {

// Between two steps of the hand, so that frames are drawn while it moves, as with a person. No test
// depends on it.
constexpr std::chrono::milliseconds kMoment = 50ms;

std::vector<std::string> with_environment(const Environment& changes) {
    std::vector<std::string> all;
    for (char** variable = environ; *variable; ++variable) {
        const std::string text = *variable, name = text.substr(0, text.find('='));
        bool is_changed = false;
        for (const auto& change : changes) is_changed = is_changed || change.first == name;
        if (!is_changed) all.push_back(text);
    }
    for (const auto& [name, value] : changes) {
        if (!value.empty()) all.push_back(name + "=" + value);
    }
    return all;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
    std::vector<char*> all;
    for (std::string& word : words) all.push_back(word.data());
    all.push_back(nullptr);
    return all;
}

bool is_installed(const std::string& program) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (::access((folder + "/" + program).c_str(), X_OK) == 0) return true;
    }
    return false;
}

}  // namespace

Process::Process(const std::vector<std::string>& words, const Environment& environment,
                 const std::string& errors) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errors.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0600);
    std::vector<std::string> arguments = words, variables = with_environment(environment);
    const int error = posix_spawnp(&id_, words.front().c_str(), &actions, nullptr,
                                   pointers(arguments).data(), pointers(variables).data());
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw std::runtime_error("cannot run " + words.front());
}

Process::~Process() {
    if (status_) return;
    ::kill(id_, SIGTERM);
    if (wait(5s)) return;
    ::kill(id_, SIGKILL);
    wait(5s);
}

std::optional<int> Process::wait(std::chrono::milliseconds most) {
    eventually(
        [this] {
            int status = 0;
            if (!status_ && ::waitpid(id_, &status, WNOHANG) == id_) {
                status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
            }
            return status_.has_value();
        },
        most);
    return status_;
}

void Process::pause() const {
    ::kill(id_, SIGSTOP);
    int status = 0;
    ::waitpid(id_, &status, WUNTRACED);
}
void Process::resume() const { ::kill(id_, SIGCONT); }

bool eventually(const std::function<bool()>& condition, std::chrono::milliseconds most) {
    const auto end = std::chrono::steady_clock::now() + most;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(20ms);
    }
    return true;
}

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
                                                 // no repeated keys where xdotool is held up
                                                 "-r"},
                        Environment{});
        // Mesa's own rasteriser, wherever the test runs. What drivers leak cannot be told by name:
        // they are unloaded before the leaks are looked for.
        environment_ = {{"DISPLAY", display},
                        {"WAYLAND_DISPLAY", ""},
                        {"LIBGL_ALWAYS_SOFTWARE", "1"},
                        {"ASAN_OPTIONS", "detect_leaks=0"}};
        const auto has_ended = [this] { return server_->wait(0ms).has_value(); };
        const bool answers =
            eventually([&] { return has_ended() || xdotool({"getdisplaygeometry"}) == 0; });
        if (answers && !has_ended()) return;  // else another's display
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
                                         PECTIN_SOURCE_DIR "/tests/window/drop_file.py", path};
    const int status = Process(words, environment_).wait().value_or(-1);
    std::this_thread::sleep_for(kMoment);
    return status == 0;
}

void Desktop::move(int x, int y) const {
    xdotool({"mousemove", std::to_string(x), std::to_string(y)});
}
void Desktop::press(int button) const { xdotool({"mousedown", std::to_string(button)}); }
void Desktop::release(int button) const { xdotool({"mouseup", std::to_string(button)}); }
void Desktop::key(const std::string& name) const { xdotool({"key", name}); }
void Desktop::hold(const std::string& name) const { xdotool({"keydown", name}); }
void Desktop::let_go(const std::string& name) const { xdotool({"keyup", name}); }
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
