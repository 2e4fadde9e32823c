// Which names of material files may be read and written: a model can come from anybody.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace pectin {

// The path below the model's folder that `name`, found in a file of `subfolder`, means there; none
// where it leads out of the folder or is no name of a file.
std::optional<std::filesystem::path> path_inside(const std::filesystem::path& subfolder,
                                                 std::string_view name);

// Whether a part of the path begins with a dot.
bool is_hidden(const std::filesystem::path& path);

inline constexpr const char* kLeadsOut = "leads out of the model's folder";
inline constexpr const char* kIsHidden = "is hidden";

// Why the path must not be read or written below the folder, symbolic links followed: kLeadsOut or
// kIsHidden; null if it may be. Throws FileError where links or folders cannot be followed.
const char* reason_against(const std::filesystem::path& folder, const std::filesystem::path& path);

// Whether the name ends as names of material libraries or of pictures do. Other programs go by the
// ends of names, and a text that begins as some kinds of picture do can be a script all the same.
bool is_library_name(const std::filesystem::path& path);
bool is_picture_name(const std::filesystem::path& path);

}  // namespace pectin
