// Ends the program when the user or the system sends a signal.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include <pthread.h>
#include <signal.h>

namespace pectin {

// On SIGINT, SIGTERM and SIGHUP the program removes the temporary files that it is writing, prints
// one line that says what was done, and exits with status 128 + the signal's number. This takes
// less than a second, whatever the program is doing. Temporary files on a file system that does not
// answer are left there. A signal that is ignored when the program starts, as with nohup, stays
// ignored.
//
// Writing to a closed pipe, or beyond the limit of a file's size, does not end the program. The
// write returns an error instead.
class TerminationWatch {
  public:
    // Precondition: no other thread exists, since threads inherit the set of blocked signals.
    TerminationWatch();
    ~TerminationWatch();
    TerminationWatch(const TerminationWatch&) = delete;
    TerminationWatch& operator=(const TerminationWatch&) = delete;

    // message: returns the line to print, given the signal's name. It is called on another thread.
    void set_exit_message(std::function<std::string(const char* signal)> message);

  private:
    void watch();
    [[noreturn]] void end_program(int signal);
    std::string exit_message(const char* signal);

    sigset_t signals_;
    std::mutex mutex_;
    std::function<std::string(const char*)> message_;
    std::atomic<bool> is_stopping_ = false;
    std::thread thread_;
};

}  // namespace pectin
