#include "support/process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace pectin {

using namespace std::chrono_literals;

namespace {

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

}  // namespace

Process::Process(const std::vector<std::string>& words, const Environment& environment,
                 const std::string& errors, const std::string& input) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    // Opened for writing, too, so that opening a pipe without a writer does not block.
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, input.c_str(),
                                     input == "/dev/null" ? O_RDONLY : O_RDWR, 0);
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
void Process::signal(int number) const { ::kill(id_, number); }

std::chrono::milliseconds Process::cpu_time() const {
    std::ifstream file("/proc/" + std::to_string(id_) + "/stat");
    std::string text;
    std::getline(file, text);
    // The fields after the name, which ends with the last parenthesis: utime and stime are the 12th
    // and the 13th of them, in clock ticks.
    std::istringstream fields(text.substr(text.rfind(')') + 1));
    std::string field;
    for (int i = 0; i < 11; ++i) fields >> field;
    long user = 0, system = 0;
    if (!(fields >> user >> system)) throw std::runtime_error("cannot read the time of a process");
    return std::chrono::milliseconds(1000 * (user + system) / ::sysconf(_SC_CLK_TCK));
}

bool eventually(const std::function<bool()>& condition, std::chrono::milliseconds most) {
    const auto end = std::chrono::steady_clock::now() + most;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(20ms);
    }
    return true;
}

}  // namespace pectin
