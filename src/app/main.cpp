#include <fcntl.h>

#include <exception>
#include <iostream>
#include <new>
#include <string>

#include "app/command_line.h"
#include "app/replay.h"
#include "app/termination.h"
#include "app/window.h"

namespace {

enum ExitStatus { kDone = 0, kFailed = 1, kBadUsage = 2 };

// Opens /dev/null for each standard file that was closed when the program started. A file that is
// opened gets the lowest free number. Without this, messages could be written into a model.
void open_missing_standard_files() {
    for (int number = 0; number <= 2; ++number) {
        if (::fcntl(number, F_GETFD) < 0 && ::open("/dev/null", O_RDWR) != number) return;
    }
}

bool replay(const std::string& script, pectin::TerminationWatch& termination) {
    pectin::ReplayStatus status;
    termination.set_exit_message(
        [&status](const char* signal) { return status.exit_message(signal); });
    const bool is_done = pectin::replay(script, std::cerr, status);
    termination.set_exit_message({});  // before the status is destroyed
    return is_done;
}

int run(const pectin::CommandLine& command_line, pectin::TerminationWatch& termination) {
    switch (command_line.action) {
        case pectin::CommandLine::Action::window:
            pectin::run_window({.model = command_line.model, .record = command_line.record},
                               termination);
            return kDone;
        case pectin::CommandLine::Action::replay:
            return replay(command_line.script, termination) ? kDone : kFailed;
        case pectin::CommandLine::Action::show:
            std::cout << command_line.text << std::flush;
            return std::cout ? kDone : kFailed;
        case pectin::CommandLine::Action::refuse:
            std::cerr << command_line.text;
            return kBadUsage;
    }
    return kFailed;
}

}  // namespace

int main(int argc, char** argv) {
    open_missing_standard_files();
    try {
        pectin::TerminationWatch termination;
        return run(pectin::read_command_line(argc, argv), termination);
    } catch (const std::bad_alloc&) {
        std::cerr << "pectin: there is not enough memory\n";
        return kFailed;
    } catch (const std::exception& error) {
        std::cerr << "pectin: " << error.what() << '\n';
        return kFailed;
    }
}
