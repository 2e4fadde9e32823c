#include "app/termination.h"

#include <unistd.h>

#include <array>
#include <cerrno>
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

// The other threads go on until the end: nothing here waits for them, and no destructor runs.
void TerminationWatch::end_program(int signal) {
    remove_temporary_files();
    std::string line;
    {
        const std::lock_guard lock(mutex_);
        if (farewell_) line = farewell_(name_of(signal)) + "\n";
    }
    // If nobody can read the line, the exit status still tells what happened.
    if (::write(STDERR_FILENO, line.data(), line.size()) < 0) errno = 0;
    ::_exit(128 + signal);
}

}  // namespace pectin
