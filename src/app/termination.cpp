#include "app/termination.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <climits>
#include <exception>
#include <semaphore>
#include <string_view>
#include <system_error>
#include <utility>

#include "io/temporary_files.h"

namespace pectin {
namespace {

struct TerminationSignal {
    int number;
    const char* name;
};
constexpr std::array kTerminationSignals{TerminationSignal{SIGINT, "SIGINT"},
                                         TerminationSignal{SIGTERM, "SIGTERM"},
                                         TerminationSignal{SIGHUP, "SIGHUP"}};

const char* name_of(int signal) {
    for (const TerminationSignal& candidate : kTerminationSignals) {
        if (candidate.number == signal) return candidate.name;
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

// Writes the line unless the reader has stopped reading. If nobody can read it, the exit status
// still tells what happened.
void write_if_possible(std::string_view line) {
    constexpr int kLongestWait = 100;  // milliseconds
    // A pipe that is ready takes up to PIPE_BUF bytes at once.
    const std::string_view part = line.substr(0, PIPE_BUF);
    pollfd errors{.fd = STDERR_FILENO, .events = POLLOUT, .revents = 0};
    if (::poll(&errors, 1, kLongestWait) <= 0) return;
    if (::write(STDERR_FILENO, part.data(), part.size()) < 0) errno = 0;
}

// Removes the temporary files on another thread, because a file system that does not answer must
// not keep the program from ending. That thread holds the list's lock until the program ends, so
// that no file is added.
void remove_files_if_possible() {
    constexpr std::chrono::milliseconds kLongestWait{500};
    static std::binary_semaphore are_removed{0};
    const auto remove = [] {
        const auto no_new_temporary_files = remove_temporary_files();
        are_removed.release();
        while (true) ::pause();
    };
    std::thread(remove).detach();
    (void)are_removed.try_acquire_for(kLongestWait);
}

}  // namespace

TerminationWatch::TerminationWatch() {
    ignore(SIGPIPE);
    ignore(SIGXFSZ);
    ::sigemptyset(&signals_);
    for (const TerminationSignal& signal : kTerminationSignals) {
        if (!is_ignored(signal.number)) ::sigaddset(&signals_, signal.number);
    }
    ::sigaddset(&signals_, SIGUSR1);  // the destructor wakes the watching thread with it
    ::pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
    try {
        thread_ = std::thread([this] { watch(); });
    } catch (const std::system_error&) {
        // No thread can be created. The signals then end the program in the usual way.
        ::pthread_sigmask(SIG_UNBLOCK, &signals_, nullptr);
    }
}

TerminationWatch::~TerminationWatch() {
    if (!thread_.joinable()) return;
    is_stopping_ = true;
    ::pthread_kill(thread_.native_handle(), SIGUSR1);
    thread_.join();
}

void TerminationWatch::set_exit_message(std::function<std::string(const char*)> message) {
    const std::lock_guard lock(mutex_);
    message_ = std::move(message);
}

// The signals are awaited by an ordinary thread, because a signal handler may do almost nothing.
void TerminationWatch::watch() {
    while (!is_stopping_) {
        int signal = 0;
        if (::sigwait(&signals_, &signal) == 0 && signal != SIGUSR1) end_program(signal);
    }
}

std::string TerminationWatch::exit_message(const char* signal) {
    const std::lock_guard lock(mutex_);
    return message_ ? message_(signal) + "\n" : "";
}

// The other threads continue until the end. This function waits for none of them, and no destructor
// runs.
void TerminationWatch::end_program(int signal) {
    std::unique_lock<std::mutex> no_new_temporary_files;
    try {
        remove_files_if_possible();
    } catch (const std::exception&) {  // no thread can be created
        no_new_temporary_files = remove_temporary_files();
    }
    try {
        write_if_possible(exit_message(name_of(signal)));
    } catch (const std::exception&) {  // there is not enough memory for the message
        write_if_possible("pectin: ended by a signal\n");
    }
    ::_exit(128 + signal);
}

}  // namespace pectin
