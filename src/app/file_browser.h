// The state of a dialog that chooses a file to open or to save. file_panel.h draws it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pectin {

struct FileEntry {
    std::string name;
    bool is_folder = false;
    std::uintmax_t bytes = 0;  // size of a file
    bool operator==(const FileEntry&) const = default;
};

// Lists a folder: folders first, then the files whose names end in one of `extensions` (such as
// ".obj"), each sorted without regard to case. Case is also ignored in the extensions. Hidden
// entries are left out. Throws FileError if the folder cannot be read.
std::vector<FileEntry> list_folder(const std::string& folder,
                                   std::span<const std::string> extensions);

class FileBrowser {
  public:
    enum class Purpose { open, save, save_picture };

    // Begins in the folder of `path` with the file's name, or in the working folder if `path` is
    // empty.
    FileBrowser(Purpose purpose, const std::string& path);

    Purpose purpose() const { return purpose_; }
    const char* title() const;
    const char* accept_label() const;  // label of the button that accepts the file
    // The extensions of the files that are listed (such as ".obj"). The first is added when saving.
    std::span<const std::string> extensions() const { return extensions_; }

    const std::string& folder() const { return folder_; }
    const std::vector<FileEntry>& entries() const { return entries_; }
    // Why the last folder could not be opened; empty if it was.
    const std::string& error() const { return error_; }
    // The folders from the root to this folder.
    struct Breadcrumb {
        std::string name, path;
    };
    std::vector<Breadcrumb> breadcrumbs() const;

    // Opens a folder. If it cannot be read, sets error() and stays in this one.
    void open_folder(const std::string& folder);
    void open_parent_folder();

    // The text of the name field.
    std::string name{};
    // Whether the name field should get the keyboard focus. Set at the start and by open_folder().
    bool wants_focus = true;

    // Returns the absolute path of the file that the name means; empty if there is none. A relative
    // name belongs to this folder, and ~ means the home folder. When saving, the first extension is
    // added if the name has none of them. If the name is that of a folder, that folder is opened
    // and the result is empty.
    std::string choose();
    static bool exists(const std::string& path);

  private:
    Purpose purpose_;
    std::vector<std::string> extensions_;
    std::string folder_;
    std::vector<FileEntry> entries_;
    std::string error_;
};

}  // namespace pectin
