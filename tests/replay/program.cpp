#include "replay/program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>

#include "support/paths.h"

namespace pectin {

std::string write_script(const ScratchFolder& folder, const std::string& name,
                         const std::vector<std::string>& lines) {
    std::string text = "{\"pectin\": 1}\n";
    for (const std::string& line : lines) text += line + "\n";
    folder.write(name, text);
    return folder.path(name);
}

Outcome run_program(const std::vector<std::string>& arguments, const std::string& standard_input) {
    const ScratchFolder streams;
    streams.write("in", standard_input);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    const auto redirect = [&](int descriptor, const char* name, int flags) {
        posix_spawn_file_actions_addopen(&actions, descriptor, streams.path(name).c_str(), flags,
                                         0600);
    };
    redirect(STDIN_FILENO, "in", O_RDONLY);
    redirect(STDOUT_FILENO, "out", O_WRONLY | O_CREAT);
    redirect(STDERR_FILENO, "err", O_WRONLY | O_CREAT);

    std::vector<std::string> words{test::program_path()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);

    pid_t child = -1;
    const int error =
        posix_spawn(&child, words.front().c_str(), &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw std::runtime_error("cannot run " + test::program_path());
    int status = 0;
    if (waitpid(child, &status, 0) != child) throw std::runtime_error("cannot wait for pectin");
    return {.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
            .out = streams.read("out"),
            .err = streams.read("err")};
}

}  // namespace pectin
