// Decides which names of material files may be read and written. A model may come from an untrusted
// source.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace pectin {

// The path, relative to the model's folder, of the file that `name` means in `subfolder`. None if
// it leads out of the model's folder or cannot be the name of a file.
std::optional<std::filesystem::path> path_inside(const std::filesystem::path& subfolder,
                                                 std::string_view name);

// Whether any part of the path begins with a dot.
bool is_hidden(const std::filesystem::path& path);

inline constexpr const char* kLeadsOut = "leads out of the model's folder";
inline constexpr const char* kIsHidden = "is hidden";

// Why the path must not be read or written in the folder: kLeadsOut or kIsHidden; null if it may
// be. Follows symbolic links and throws FileError if this fails.
const char* reason_against(const std::filesystem::path& folder, const std::filesystem::path& path);

// Whether the name has the extension of a material library or a picture. The content alone does not
// decide, because other programs go by the extension, and a script can begin like a picture.
bool is_library_name(const std::filesystem::path& path);
bool is_picture_name(const std::filesystem::path& path);

}  // namespace pectin
