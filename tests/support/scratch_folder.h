// A folder for the files of a test.
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace pectin {

// Makes an empty folder in the system's folder for temporary files; the destructor removes it. Its
// path has a blank, so that the tests also test paths with blanks.
class ScratchFolder {
  public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    // The path of a file in the folder; that of the folder itself if the name is empty.
    std::string path(const std::string& name = "") const;
    // Makes missing subfolders.
    void write(const std::string& name, const std::string& contents) const;
    // Throws std::runtime_error if the file cannot be read.
    std::string read(const std::string& name) const;
    bool holds(const std::string& name) const;
    // All files, also those in subfolders. Their paths are relative to `subfolder`.
    std::set<std::string> files(const std::string& subfolder = "") const;

  private:
    std::filesystem::path folder_;
};

}  // namespace pectin
