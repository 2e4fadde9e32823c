// Choosing a file to open or to save, on std::filesystem; file_panel draws it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pectin {

struct FileEntry {
    std::string name;
    bool is_folder = false;
    std::uintmax_t bytes = 0;  // of a file
    bool operator==(const FileEntry&) const = default;
};

// What a folder holds of interest: folders first, each sorted without regard to case; hidden ones
// left out; of files only those that end in one of `extensions` (".obj"), in any case.
// Throws FileError where it cannot be read.
std::vector<FileEntry> list_folder(const std::string& folder,
                                   std::span<const std::string> extensions);

class FileBrowser {
  public:
    enum class Purpose { open, save, save_picture };

    // Starts in the folder of `path`, or in the working folder where it is empty, with its name.
    FileBrowser(Purpose purpose, const std::string& path);

    Purpose purpose() const { return purpose_; }
    const char* title() const;
    const char* verb() const;  // of the button
    // The extensions of the files that are listed (".obj"). The first is added when saving.
    std::span<const std::string> extensions() const { return extensions_; }

    const std::string& folder() const { return folder_; }
    const std::vector<FileEntry>& entries() const { return entries_; }
    // Why the folder is not shown; empty where it is.
    const std::string& complaint() const { return complaint_; }
    // The path's folders from the root, each with its own path.
    struct Step {
        std::string name, path;
    };
    std::vector<Step> steps() const;

    // Goes there; where it cannot be read, stays and complains.
    void enter(const std::string& folder);
    void enter_parent();

    // What stands in the name's field.
    std::string name{};
    // Whether typing is to go there; set at the start and in each folder entered.
    bool takes_typing = true;

    // The file that the name means, absolute: a name with a folder counts from this one, and ~ is
    // the home folder. When saving, the first extension is added where all are missing. Empty where
    // there is no name. Where the name is that of a folder, goes there and answers empty.
    std::string choose();
    static bool exists(const std::string& path);

  private:
    Purpose purpose_;
    std::vector<std::string> extensions_;
    std::string folder_;
    std::vector<FileEntry> entries_;
    std::string complaint_;
};

}  // namespace pectin
