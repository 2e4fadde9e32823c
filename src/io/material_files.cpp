#include "io/material_files.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>

#include "io/atomic_file.h"
#include "io/file_descriptor.h"
#include "io/file_error.h"
#include "io/obj_statements.h"
#include "io/read_file.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;

// Real ones have kilobytes; what is larger is no library, whatever it is called.
constexpr std::size_t kMostLibraryBytes = std::size_t{64} << 20;

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return lower;
}

bool names_texture(std::string_view keyword) {
    const std::string word = lower_case(keyword);
    return word.starts_with("map_") || word == "bump" || word == "disp" || word == "decal" ||
           word == "refl" || word == "norm";
}

// Cuts the options off the front of a texture statement's arguments; what is left is the name.
void skip_texture_options(std::string_view& arguments) {
    struct Option {
        std::string_view name;
        int least, most;  // values; beyond the least only numbers that are not the last word
    };
    constexpr std::array kOptions = {
        Option{"-blendu", 1, 1},  Option{"-blendv", 1, 1},    Option{"-boost", 1, 1},
        Option{"-bm", 1, 1},      Option{"-cc", 1, 1},        Option{"-clamp", 1, 1},
        Option{"-imfchan", 1, 1}, Option{"-mm", 2, 2},        Option{"-texres", 1, 1},
        Option{"-type", 1, 1},    Option{"-o", 1, 3},         Option{"-s", 1, 3},
        Option{"-t", 1, 3},       Option{"-colorspace", 1, 1}};
    std::string_view rest = arguments;
    std::string why_not;
    while (const auto token = take_token(rest)) {
        const auto option = std::find_if(kOptions.begin(), kOptions.end(),
                                         [&](const Option& o) { return o.name == *token; });
        if (option == kOptions.end()) return;
        for (int i = 0; i < option->most; ++i) {
            std::string_view behind = rest;
            const auto value = take_token(behind);
            if (!value) break;
            const bool may_be_value = !behind.empty() && parse_number<double>(*value, why_not);
            if (i >= option->least && !may_be_value) break;
            rest = behind;
        }
        arguments = rest;
    }
}

// The path below a folder that `name` means there; none where it leads elsewhere. A path that ends
// at a zero byte for the system would not be the one looked at here.
std::optional<fs::path> path_inside(const fs::path& subfolder, std::string_view name) {
    const fs::path path = (subfolder / name).lexically_normal();
    if (name.find('\0') != name.npos || path.is_absolute() || path.empty()) return std::nullopt;
    if (*path.begin() == ".." || *path.begin() == "." || !path.has_filename()) return std::nullopt;
    return path;
}

// Whether the path, links followed, lies in the folder.
bool leads_inside(const fs::path& folder, const fs::path& path) {
    std::error_code error;
    const fs::path root = fs::canonical(folder, error);
    if (error) return false;
    const fs::path target = fs::weakly_canonical(folder / path, error);
    if (error) return false;
    return std::mismatch(root.begin(), root.end(), target.begin(), target.end()).first ==
           root.end();
}

bool is_readable_file(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error) && ::access(path.c_str(), R_OK) == 0;
}

// Also a symbolic link that leads nowhere: writing would follow it.
bool is_anything(const fs::path& path) {
    std::error_code error;
    return fs::symlink_status(path, error).type() != fs::file_type::not_found && !error;
}

class MaterialCopier {
  public:
    MaterialCopier(fs::path from, fs::path to) : from_(std::move(from)), to_(std::move(to)) {}

    void find_libraries(std::string_view statement);
    void find_textures();
    MaterialCopy copy(const Progress& progress);

  private:
    std::vector<std::string> library_names(std::string_view statement) const;
    void find_textures_of(const fs::path& library);
    void find_texture(const fs::path& library, std::string_view name);
    void copy_file(const fs::path& path, const Progress& progress) const;

    fs::path from_, to_;
    std::set<fs::path> libraries_;          // found in from_
    std::set<fs::path> found_;              // those and their textures
    std::set<std::string> lost_, outside_;  // by name
};

// One file, also with blanks in its name, or several, where a name ends at .mtl and a blank.
std::vector<std::string> MaterialCopier::library_names(std::string_view statement) const {
    constexpr std::string_view kExtension = ".mtl";
    const auto whole = path_inside({}, statement);
    if (whole && is_readable_file(from_ / *whole)) return {std::string(statement)};
    std::vector<std::string> names;
    const std::string lower = lower_case(statement);
    std::size_t begin = 0;
    while (begin < statement.size()) {
        std::size_t end = begin;
        do {
            const std::size_t extension = lower.find(kExtension, end);
            end = extension == lower.npos ? lower.size() : extension + kExtension.size();
        } while (end < statement.size() && !is_blank(statement[end]));
        names.emplace_back(statement.substr(begin, end - begin));
        begin = end;
        while (begin < statement.size() && is_blank(statement[begin])) ++begin;
    }
    return names;
}

void MaterialCopier::find_libraries(std::string_view statement) {
    for (std::string name : library_names(statement)) {
        if (!path_inside({}, name)) {
            outside_.insert(name);
            continue;
        }
        if (!is_readable_file(from_ / name)) std::replace(name.begin(), name.end(), '\\', '/');
        const auto path = path_inside({}, name);
        if (path && is_readable_file(from_ / *path)) {
            libraries_.insert(*path);
        } else {
            (path ? lost_ : outside_).insert(name);
        }
    }
}

void MaterialCopier::find_textures() {
    found_ = libraries_;
    for (const fs::path& library : libraries_) find_textures_of(library);
}

void MaterialCopier::find_textures_of(const fs::path& library) {
    std::error_code error;
    if (!leads_inside(from_, library)) return;
    if (fs::file_size(from_ / library, error) > kMostLibraryBytes) return;
    const std::string text = read_whole_file((from_ / library).string());
    ObjStatements statements(text);
    while (statements.next()) {
        if (!names_texture(statements.keyword())) continue;
        std::string_view name = statements.arguments();
        skip_texture_options(name);
        name.remove_prefix(std::min(name.find_first_not_of(" \t"), name.size()));
        if (!name.empty()) find_texture(library, name);
    }
}

void MaterialCopier::find_texture(const fs::path& library, std::string_view name) {
    std::string with_slashes(name);
    std::replace(with_slashes.begin(), with_slashes.end(), '\\', '/');
    std::optional<fs::path> inside;
    for (const std::string& spelling : {std::string(name), with_slashes}) {
        for (const fs::path& subfolder : {library.parent_path(), fs::path()}) {
            const auto path = path_inside(subfolder, spelling);
            if (path && is_readable_file(from_ / *path)) {
                found_.insert(*path);
                return;
            }
            if (path && spelling == with_slashes && !inside) inside = path;
        }
    }
    if (inside) {
        lost_.insert(inside->generic_string());
    } else {
        outside_.insert(with_slashes);
    }
}

MaterialCopy MaterialCopier::copy(const Progress& progress) {
    MaterialCopy result;
    double done = 0.0;
    const double step = 1.0 / static_cast<double>(std::max(found_.size(), std::size_t{1}));
    for (const fs::path& path : found_) {
        const Progress part = progress.part(done, std::min(done + step, 1.0));
        part.advance(0.0);
        if (!leads_inside(from_, path) || !leads_inside(to_, path)) {
            outside_.insert(path.generic_string());
        } else if (!is_anything(to_ / path)) {
            try {
                copy_file(path, part);
                result.copied.push_back(path.generic_string());
            } catch (const FileError& error) {
                result.failed.push_back(error.what());
            }
        }
        done = std::min(done + step, 1.0);
    }
    std::copy_if(lost_.begin(), lost_.end(), std::back_inserter(result.missing),
                 [this](const std::string& name) { return !is_readable_file(to_ / name); });
    result.outside.assign(outside_.begin(), outside_.end());
    return result;
}

// In pieces: textures can be large.
void MaterialCopier::copy_file(const fs::path& path, const Progress& progress) const {
    const std::string source = (from_ / path).string(), target = (to_ / path).string();
    const auto fail = [](const std::string& at, const std::string& what, const std::string& why) {
        throw FileError(at, what + ": " + why);
    };
    std::error_code error;
    const fs::path folder = (to_ / path).parent_path();
    fs::create_directories(folder, error);
    if (error) fail(folder.string(), "the folder cannot be made", error.message());

    const FileDescriptor in(source.c_str(), O_RDONLY);
    if (!in.is_open()) fail(source, "cannot be read", std::generic_category().message(errno));
    AtomicFile out(target);
    std::string piece(std::size_t{1} << 20, '\0');
    while (true) {
        const ssize_t got = ::read(in.get(), piece.data(), piece.size());
        if (got == 0) break;
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail(source, "cannot be read", std::generic_category().message(errno));
        out.write(std::string_view(piece).substr(0, static_cast<std::size_t>(got)));
        progress.advance(0.0);
    }
    out.commit();
}

}  // namespace

MaterialCopy copy_material_files(std::span<const std::string> material_libraries,
                                 const std::string& from, const std::string& to,
                                 const Progress& progress) {
    const fs::path source = from.empty() ? "." : from, target = to.empty() ? "." : to;
    std::error_code error;
    if (!fs::is_directory(target, error) || fs::equivalent(source, target, error)) return {};
    MaterialCopier copier(source, target);
    for (const std::string& statement : material_libraries) copier.find_libraries(statement);
    copier.find_textures();
    return copier.copy(progress);
}

}  // namespace pectin
