#include <exception>
#include <iostream>
#include <new>

#include "app/command_line.h"
#include "app/replay.h"
#include "app/window.h"

namespace {

enum ExitStatus { kDone = 0, kFailed = 1, kBadUsage = 2 };

int run(const pectin::CommandLine& command_line) {
    switch (command_line.action) {
        case pectin::CommandLine::Action::window:
            pectin::run_window({.model = command_line.model, .record = command_line.record});
            return kDone;
        case pectin::CommandLine::Action::replay:
            return pectin::replay(command_line.script, std::cerr) ? kDone : kFailed;
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
    try {
        return run(pectin::read_command_line(argc, argv));
    } catch (const std::bad_alloc&) {
        std::cerr << "pectin: there is not enough memory\n";
        return kFailed;
    } catch (const std::exception& error) {
        std::cerr << "pectin: " << error.what() << '\n';
        return kFailed;
    }
}
