#include "replay/program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace pectin {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
    // The path has a blank, so that every test also tests paths with blanks.
    std::string name = (fs::temp_directory_path() / "pectin replay XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no folder for a test: " + name);
    folder_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

void ScratchFolder::write(const std::string& name, const std::string& contents) const {
    fs::create_directories(fs::path(path(name)).parent_path());
    std::ofstream(path(name), std::ios::binary) << contents;
}

std::string ScratchFolder::write_script(const std::string& name,
                                        const std::vector<std::string>& lines) const {
    std::string text = "{\"pectin\": 1}\n";
    for (const std::string& line : lines) text += line + "\n";
    write(name, text);
    return path(name);
}

std::string ScratchFolder::read(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    if (!file) throw std::runtime_error("cannot read " + path(name));
    return {std::istreambuf_iterator<char>(file), {}};
}

bool ScratchFolder::holds(const std::string& name) const { return fs::exists(path(name)); }

std::set<std::string> ScratchFolder::files() const {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
        if (!entry.is_directory())
            names.insert(entry.path().lexically_relative(folder_).generic_string());
    return names;
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

    std::vector<std::string> words{PECTIN_BINARY};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);

    pid_t child = -1;
    const int error = posix_spawn(&child, PECTIN_BINARY, &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw std::runtime_error(std::string("cannot run ") + PECTIN_BINARY);
    int status = 0;
    if (waitpid(child, &status, 0) != child) throw std::runtime_error("cannot wait for pectin");
    return {.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
            .out = streams.read("out"),
            .err = streams.read("err")};
}

}  // namespace pectin
