// How the program ends when the user or the system asks it to by a signal.
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

// On SIGINT, SIGTERM and SIGHUP the program removes the temporary files it is writing, says in one
// line what was done, and ends with status 128 + the signal's number, within a moment and whatever
// it is busy with. A signal that is ignored when the program starts, as nohup does, stays ignored.
//
// Writing to a closed pipe, or beyond the limit of a file's size, becomes an error of that write;
// it ends nothing.
class TerminationWatch {
  public:
    // Precondition: no other thread exists, since threads inherit which signals they do not take.
    TerminationWatch();
    ~TerminationWatch();
    TerminationWatch(const TerminationWatch&) = delete;
    TerminationWatch& operator=(const TerminationWatch&) = delete;

    // farewell: gives the line to say, from the signal's name. Called on another thread.
    void set_farewell(std::function<std::string(const char* signal)> farewell);

  private:
    void watch();
    [[noreturn]] void end_program(int signal);
    std::string farewell(const char* signal);

    sigset_t signals_;
    std::mutex mutex_;
    std::function<std::string(const char*)> farewell_;
    std::atomic<bool> is_over_ = false;
    std::thread thread_;
};

}  // namespace pectin
