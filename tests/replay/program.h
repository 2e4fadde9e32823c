// Runs the built program in a folder of its own.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace pectin {

// An empty folder that is gone with this.
class ScratchFolder {
  public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    void write(const std::string& name, const std::string& contents) const;
    // A script of these commands behind its first line; returns its path.
    std::string write_script(const std::string& name, const std::vector<std::string>& lines) const;
    std::string read(const std::string& name) const;
    bool holds(const std::string& name) const;
    std::set<std::string> files() const;  // relative, of all folders in it

  private:
    std::filesystem::path folder_;
};

struct Outcome {
    int exit_status = -1;  // -1 where a signal ended it
    std::string out, err;
};

Outcome run_program(const std::vector<std::string>& arguments,
                    const std::string& standard_input = "");

}  // namespace pectin
