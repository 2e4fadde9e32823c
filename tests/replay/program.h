// Runs the program in its own folder.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace pectin {

// An empty folder, removed by the destructor.
class ScratchFolder {
  public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    void write(const std::string& name, const std::string& contents) const;
    // Writes a script with the first line and these commands, and returns its path.
    std::string write_script(const std::string& name, const std::vector<std::string>& lines) const;
    std::string read(const std::string& name) const;
    bool holds(const std::string& name) const;
    std::set<std::string> files() const;  // paths relative to the folder, also in subfolders

  private:
    std::filesystem::path folder_;
};

struct Outcome {
    int exit_status = -1;  // -1 if a signal ended it
    std::string out, err;
};

Outcome run_program(const std::vector<std::string>& arguments,
                    const std::string& standard_input = "");

}  // namespace pectin
