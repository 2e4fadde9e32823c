#include "app/termination.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <exception>
#include <string_view>
#include <system_error>
#include <utility>

#include "io/temporary_files.h"

namespace pectin {
namespace {

struct Ending {
    int signal;
    const char* name;
};
constexpr std::array kEndings{Ending{SIGINT, "SIGINT"}, Ending{SIGTERM, "SIGTERM"},
                              Ending{SIGHUP, "SIGHUP"}};

const char* name_of(int signal) {
    for (const Ending& ending : kEndings) {
        if (ending.signal == signal) return ending.name;
    }
    return "a signal";
}

bool is_ignored(int signal) {
    struct sigaction action {};
    return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

void ignore(int signal) {
    struct sigaction action {};
    action.sa_handler = SIG_IGN;
    ::sigaction(signal, &action, nullptr);
}

// Without waiting for a reader who does not read: if nobody can read the line, the exit status
// still tells what happened.
void write_if_possible(std::string_view line) {
    constexpr int kLongestWait = 100;  // milliseconds
    // A pipe that is ready takes as much at once.
    const std::string_view part = line.substr(0, PIPE_BUF);
    pollfd errors{.fd = STDERR_FILENO, .events = POLLOUT, .revents = 0};
    if (::poll(&errors, 1, kLongestWait) <= 0) return;
    if (::write(STDERR_FILENO, part.data(), part.size()) < 0) errno = 0;
}

}  // namespace

TerminationWatch::TerminationWatch() {
    ignore(SIGPIPE);
    ignore(SIGXFSZ);
    ::sigemptyset(&signals_);
    for (const Ending& ending : kEndings) {
        if (!is_ignored(ending.signal)) ::sigaddset(&signals_, ending.signal);
    }
    ::sigaddset(&signals_, SIGUSR1);  // wakes the watching thread in the end
    ::pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
    try {
        thread_ = std::thread([this] { watch(); });
    } catch (const std::system_error&) {
        // No thread can be created: the signals end the program as they end any other.
        ::pthread_sigmask(SIG_UNBLOCK, &signals_, nullptr);
    }
}

TerminationWatch::~TerminationWatch() {
    if (!thread_.joinable()) return;
    is_over_ = true;
    ::pthread_kill(thread_.native_handle(), SIGUSR1);
    thread_.join();
}

void TerminationWatch::set_farewell(std::function<std::string(const char*)> farewell) {
    const std::lock_guard lock(mutex_);
    farewell_ = std::move(farewell);
}

// An ordinary thread waits for the signals, since a handler could do next to nothing.
void TerminationWatch::watch() {
    while (!is_over_) {
        int signal = 0;
        if (::sigwait(&signals_, &signal) == 0 && signal != SIGUSR1) end_program(signal);
    }
}

std::string TerminationWatch::farewell(const char* signal) {
    const std::lock_guard lock(mutex_);
    return farewell_ ? farewell_(signal) + "\n" : "";
}

// The other threads go on until the end: nothing here waits for them, and no destructor runs.
void TerminationWatch::end_program(int signal) {
    const auto no_more_files = remove_temporary_files();
    try {
        write_if_possible(farewell(name_of(signal)));
    } catch (const std::exception&) {  // no memory for it
        write_if_possible("pectin: ended by a signal\n");
    }
    ::_exit(128 + signal);
}

}  // namespace pectin
