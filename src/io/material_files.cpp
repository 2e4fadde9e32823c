#include "io/material_files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "io/atomic_file.h"
#include "io/file_error.h"
#include "io/file_kind.h"
#include "io/material_library.h"
#include "io/obj_statements.h"
#include "io/open_file.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLeadsOut = "leads out of the model's folder";
constexpr const char* kIsHidden = "is hidden";

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return lower;
}

// The path below a folder that `name` means there; none where it leads elsewhere. A path that ends
// at a zero byte for the system would not be the one that is examined here.
std::optional<fs::path> path_inside(const fs::path& subfolder, std::string_view name) {
    const fs::path path = (subfolder / name).lexically_normal();
    if (name.find('\0') != name.npos || path.is_absolute() || path.empty()) return std::nullopt;
    if (*path.begin() == ".." || *path.begin() == "." || !path.has_filename()) return std::nullopt;
    return path;
}

bool is_hidden(const fs::path& path) {
    return std::any_of(path.begin(), path.end(),
                       [](const fs::path& part) { return part.string().starts_with('.'); });
}

// Why a path, links followed, is none that may be read or written below the folder; null if it is.
const char* reason_against(const fs::path& folder, const fs::path& path) {
    std::error_code error;
    const fs::path root = fs::canonical(folder, error);
    if (error) return kLeadsOut;
    const fs::path target = fs::weakly_canonical(folder / path, error);
    if (error) return kLeadsOut;
    const auto [in_root, in_target] =
        std::mismatch(root.begin(), root.end(), target.begin(), target.end());
    if (in_root != root.end()) return kLeadsOut;
    return std::any_of(in_target, target.end(),
                       [](const fs::path& part) { return part.string().starts_with('.'); })
               ? kIsHidden
               : nullptr;
}

// Also a symbolic link that leads nowhere: writing would follow it.
bool path_exists(const fs::path& path) {
    std::error_code error;
    return fs::symlink_status(path, error).type() != fs::file_type::not_found && !error;
}

bool is_picture(const OpenFile& file, const std::string& path) {
    constexpr std::size_t kTail = 32;
    std::string head(kSignatureBytes, '\0');
    head.resize(read_bytes(file, path, head.data(), head.size()));
    std::string tail(kTail, '\0');
    const std::size_t tail_begin = file.bytes - std::min(file.bytes, kTail);
    ::lseek(file.descriptor.get(), static_cast<off_t>(tail_begin), SEEK_SET);
    tail.resize(read_bytes(file, path, tail.data(), tail.size()));
    ::lseek(file.descriptor.get(), 0, SEEK_SET);
    return recognise_file(head, file.bytes).is_image() || is_tga(head, tail, file.bytes);
}

class MaterialCopier {
  public:
    MaterialCopier(fs::path from, fs::path to, const Progress& progress,
                   const MaterialLimits& limits)
        : from_(std::move(from)), to_(std::move(to)), progress_(progress), limits_(limits) {}

    void find_libraries(std::string_view statement);
    void find_textures();
    MaterialCopy copy();

  private:
    std::vector<std::string> library_names(std::string_view statement) const;
    void find(std::string_view name, std::span<const fs::path> subfolders,
              std::set<fs::path>& found);
    bool is_there(const fs::path& path) const;
    bool find_textures_of(const fs::path& library);
    void copy_one(const fs::path& path, const Progress& progress);
    void copy_bytes(const OpenFile& file, const fs::path& path, const Progress& progress) const;
    std::optional<OpenFile> open(const fs::path& path, std::uint64_t most_bytes);
    void refuse(const fs::path& path, std::string why) {
        refused_.insert_or_assign(path.generic_string(), std::move(why));
    }
    void fail(const fs::path& path, const std::string& why) {
        result_.failed.push_back({path.generic_string(), why});
    }

    fs::path from_, to_;
    const Progress& progress_;
    const MaterialLimits& limits_;
    std::set<fs::path> libraries_, textures_;     // found in from_
    std::set<std::string> lost_;                  // by name
    std::map<std::string, std::string> refused_;  // why, by name
    MaterialCopy result_;
};

// Whether there is anything: what it is decides later what becomes of it.
bool MaterialCopier::is_there(const fs::path& path) const {
    return ask_patiently((from_ / path).string(), progress_).error == 0;
}

// One file, also with blanks in its name, or several, where a name ends at .mtl and a blank.
std::vector<std::string> MaterialCopier::library_names(std::string_view statement) const {
    constexpr std::string_view kExtension = ".mtl";
    const auto whole = path_inside({}, statement);
    if (whole && !is_hidden(*whole) && is_there(*whole)) return {std::string(statement)};
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
    const fs::path beside_the_model;
    for (const std::string& name : library_names(statement)) {
        find(name, std::span(&beside_the_model, 1), libraries_);
    }
}

// Adds the file that the name means to `found`, or says why it does not.
void MaterialCopier::find(std::string_view name, std::span<const fs::path> subfolders,
                          std::set<fs::path>& found) {
    std::string with_slashes(name);
    std::replace(with_slashes.begin(), with_slashes.end(), '\\', '/');
    std::optional<fs::path> inside;
    for (const std::string& spelling : {std::string(name), with_slashes}) {
        for (const fs::path& subfolder : subfolders) {
            const auto path = path_inside(subfolder, spelling);
            // With backslashes a name such as .\\a.png is only one part, which is not hidden.
            const bool is_split = spelling == with_slashes;
            if (!path || (!is_split && is_hidden(*path))) continue;
            if (is_hidden(*path)) return refuse(*path, kIsHidden);
            if (is_there(*path)) {
                found.insert(*path);
                return;
            }
            if (is_split && !inside) inside = path;
        }
    }
    if (inside) {
        lost_.insert(inside->generic_string());
    } else {
        refuse(with_slashes, kLeadsOut);
    }
}

void MaterialCopier::find_textures() {
    std::erase_if(libraries_,
                  [this](const fs::path& library) { return !find_textures_of(library); });
}

// The file, if it is a regular one of at most so many bytes; else says why it is not copied.
std::optional<OpenFile> MaterialCopier::open(const fs::path& path, std::uint64_t most_bytes) {
    const std::string source = (from_ / path).string();
    try {
        OpenAnswer answer = ask_patiently(source, progress_);
        const bool is_readable = answer.error == 0;
        try {
            OpenFile file = opened(source, std::move(answer));
            if (file.bytes <= most_bytes) return file;
            refuse(path, "is larger than " + std::to_string(most_bytes >> 20) + " MB");
        } catch (const FileError& error) {
            if (!is_readable) throw;
            refuse(path, error.message());
        }
    } catch (const FileError& error) {
        fail(path, error.message());
    }
    return std::nullopt;
}

// Whether it is a library.
bool MaterialCopier::find_textures_of(const fs::path& library) {
    if (const char* why = reason_against(from_, library)) {
        refuse(library, why);
        return false;
    }
    const std::optional<OpenFile> file = open(library, limits_.library_bytes);
    if (!file) return false;
    std::string text(file->bytes, '\0');
    text.resize(read_bytes(*file, (from_ / library).string(), text.data(), text.size()));
    if (!may_be_material_library(text)) {
        refuse(library, "is no material library");
        return false;
    }
    const fs::path subfolders[] = {library.parent_path(), fs::path()};
    for (const Material& material : parse_materials(text, progress_.part(0.0, 0.0))) {
        for (const std::string& name : material.textures) find(name, subfolders, textures_);
    }
    return true;
}

MaterialCopy MaterialCopier::copy() {
    std::set<fs::path> files = libraries_;
    files.insert(textures_.begin(), textures_.end());
    double done = 0.0;
    const double step = 1.0 / static_cast<double>(std::max(files.size(), std::size_t{1}));
    for (const fs::path& path : files) {
        const Progress part = progress_.part(done, std::min(done + step, 1.0));
        part.advance(0.0);
        copy_one(path, part);
        done = std::min(done + step, 1.0);
    }
    std::copy_if(lost_.begin(), lost_.end(), std::back_inserter(result_.missing),
                 [this](const std::string& name) { return !path_exists(to_ / name); });
    for (auto& [name, why] : refused_) result_.refused.push_back({name, why});
    return std::move(result_);
}

void MaterialCopier::copy_one(const fs::path& path, const Progress& progress) {
    const char* why = reason_against(from_, path);
    if (!why) why = reason_against(to_, path);
    if (why) return refuse(path, why);
    if (path_exists(to_ / path)) return;
    const bool is_library = libraries_.contains(path);
    const std::optional<OpenFile> file =
        open(path, is_library ? limits_.library_bytes : limits_.texture_bytes);
    if (!file) return;
    try {
        if (!is_library && !is_picture(*file, (from_ / path).string())) {
            return refuse(path, "is no picture");
        }
        copy_bytes(*file, path, progress);
        result_.copied.push_back(path.generic_string());
    } catch (const FileError& error) {
        fail(path, error.message());
    }
}

// In pieces: textures can be large.
void MaterialCopier::copy_bytes(const OpenFile& file, const fs::path& path,
                                const Progress& progress) const {
    const std::string source = (from_ / path).string(), target = (to_ / path).string();
    std::error_code error;
    const fs::path folder = (to_ / path).parent_path();
    fs::create_directories(folder, error);
    if (error) {
        throw FileError(folder.string(), "the folder cannot be made: " + error.message());
    }
    AtomicFile out(target);
    std::string piece(std::size_t{1} << 20, '\0');
    while (const std::size_t got = read_bytes(file, source, piece.data(), piece.size())) {
        out.write(std::string_view(piece).substr(0, got));
        progress.advance(0.0);
    }
    out.commit_new();
}

}  // namespace

MaterialCopy copy_material_files(std::span<const std::string> material_libraries,
                                 const std::string& from, const std::string& to,
                                 const Progress& progress, const MaterialLimits& limits) {
    const fs::path source = from.empty() ? "." : from, target = to.empty() ? "." : to;
    if (material_libraries.empty()) return {};
    try {
        // The folder may have been on a drive that is gone, which would hold up all that follows.
        if (ask_patiently(source.string(), progress).error != 0) return {};
    } catch (const FileError& error) {
        MaterialCopy result;
        result.failed.push_back({source.string(), error.message()});
        return result;
    }
    std::error_code error;
    if (!fs::is_directory(target, error) || fs::equivalent(source, target, error)) return {};
    MaterialCopier copier(source, target, progress, limits);
    for (const std::string& statement : material_libraries) copier.find_libraries(statement);
    copier.find_textures();
    return copier.copy();
}

}  // namespace pectin
