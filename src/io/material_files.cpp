#include "io/material_files.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <iterator>
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
#include "io/material_names.h"
#include "io/obj_statements.h"
#include "io/open_file.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return lower;
}

// True also for a dangling symbolic link, because writing would follow it.
bool path_exists(const fs::path& path) {
    std::error_code error;
    return fs::symlink_status(path, error).type() != fs::file_type::not_found && !error;
}

bool is_picture(FileAccess& access, const OpenFile& file, const std::string& path,
                const Progress& progress) {
    constexpr std::size_t kTail = 32;
    const std::size_t tail_begin = file.bytes - std::min(file.bytes, kTail);
    const std::string head = access.read(file, path, 0, kSignatureBytes, progress);
    const std::string tail = access.read(file, path, tail_begin, kTail, progress);
    return recognise_file(head, file.bytes).is_image() || is_tga(head, tail, file.bytes);
}

// Whether the error means that there is no file. A name that is too long cannot belong to a file.
bool is_missing(int error) { return error == ENOENT || error == ENOTDIR || error == ENAMETOOLONG; }

class MaterialCopier {
  public:
    MaterialCopier(fs::path from, fs::path to, const Progress& progress,
                   const MaterialLimits& limits)
        : from_(std::move(from)), to_(std::move(to)), progress_(progress), limits_(limits) {}

    void find_libraries(std::span<const std::string> statements);
    void find_textures();
    MaterialCopy copy();

  private:
    using Reasons = std::map<std::string, std::string>;  // keyed by name

    std::vector<std::string> library_names(std::string_view statement);
    void find_once(const std::string& name, const fs::path& subfolder, std::set<fs::path>& found);
    void find(const std::string& name, std::span<const fs::path> subfolders,
              std::set<fs::path>& found);
    bool may_look_up();
    int error_of(const fs::path& path);
    std::optional<std::string> read_library(const fs::path& library);
    bool find_textures_of(const fs::path& library);
    void copy_one(const fs::path& path, const Progress& progress);
    void copy_bytes(const OpenFile& file, const fs::path& path, const Progress& progress);
    std::optional<OpenFile> open(const fs::path& path, std::uint64_t max_bytes,
                                 const Progress& progress);
    void refuse(const fs::path& path, std::string why) {
        refused_.insert_or_assign(path.generic_string(), std::move(why));
    }
    void fail(const fs::path& path, const FileError& error) {
        failed_.insert_or_assign(path.generic_string(), error.message());
    }

    fs::path from_, to_;
    const Progress& progress_;
    const MaterialLimits& limits_;
    FileAccess access_;
    std::map<fs::path, int> errors_;                    // cached results of error_of()
    std::set<std::pair<fs::path, std::string>> names_;  // subfolder and name of those looked up
    std::set<fs::path> libraries_, textures_;           // exist in from_
    std::set<std::string> not_found_;                   // names of files not found
    Reasons refused_, failed_;
    MaterialCopy result_;
};

// The errno of asking the system about a path in from_; 0 if something exists there.
int MaterialCopier::error_of(const fs::path& path) {
    const auto known = errors_.find(path);
    if (known != errors_.end()) return known->second;
    int error = ETIMEDOUT;
    try {
        error = access_.ask((from_ / path).string(), progress_).error;
    } catch (const FileError&) {
        // The system did not answer. open() will report it.
    }
    errors_.emplace(path, error);
    return error;
}

// The statement names one file, whose name may contain blanks, or several files. In a list, a name
// ends after ".mtl" and a blank.
std::vector<std::string> MaterialCopier::library_names(std::string_view statement) {
    constexpr std::string_view kExtension = ".mtl";
    const auto whole = path_inside({}, statement);
    if (whole && !is_hidden(*whole) && error_of(*whole) == 0) return {std::string(statement)};
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

void MaterialCopier::find_libraries(std::span<const std::string> statements) {
    const std::set<std::string_view> once(statements.begin(), statements.end());
    for (const std::string_view statement : once) {
        if (!may_look_up()) return;
        for (const std::string& name : library_names(statement)) find_once(name, {}, libraries_);
    }
}

// Whether another name may be looked up. If not, reports that there are too many.
bool MaterialCopier::may_look_up() {
    progress_.advance(0.0);
    if (names_.size() < limits_.names) return true;
    refuse("all names after the first " + std::to_string(limits_.names), "are too many");
    return false;
}

// Looks the name up, unless this was done before or there are too many names. A texture that is not
// in the folder of its library may be in the folder of the model.
void MaterialCopier::find_once(const std::string& name, const fs::path& subfolder,
                               std::set<fs::path>& found) {
    if (names_.contains({subfolder, name}) || !may_look_up()) return;
    names_.emplace(subfolder, name);
    const std::array<fs::path, 2> subfolders{subfolder, fs::path()};
    find(name, std::span(subfolders).first(subfolder.empty() ? 1 : 2), found);
}

// Adds the file that the name means to `found`, or records why there is none.
void MaterialCopier::find(const std::string& name, std::span<const fs::path> subfolders,
                          std::set<fs::path>& found) {
    std::string with_slashes = name;
    std::replace(with_slashes.begin(), with_slashes.end(), '\\', '/');
    std::optional<fs::path> inside;
    for (const std::string& spelling : {name, with_slashes}) {
        for (const fs::path& subfolder : subfolders) {
            const auto path = path_inside(subfolder, spelling);
            // A name with backslashes such as .\\a.png has only one part. It is judged once it is
            // split.
            const bool is_split = spelling == with_slashes;
            if (!path || (!is_split && is_hidden(*path))) continue;
            if (is_hidden(*path)) return refuse(*path, kIsHidden);
            if (!is_missing(error_of(*path))) {
                found.insert(*path);
                return;
            }
            if (is_split && !inside) inside = path;
        }
    }
    if (inside) {
        not_found_.insert(inside->generic_string());
    } else {
        refuse(with_slashes, kLeadsOut);
    }
}

void MaterialCopier::find_textures() {
    std::erase_if(libraries_,
                  [this](const fs::path& library) { return !find_textures_of(library); });
}

// Opens the file if it is a regular one and not too large. If not, records why it is not copied.
std::optional<OpenFile> MaterialCopier::open(const fs::path& path, std::uint64_t max_bytes,
                                             const Progress& progress) {
    const std::string source = (from_ / path).string();
    try {
        FileAnswer answer = access_.ask(source, progress);
        const bool is_readable = answer.error == 0;
        try {
            OpenFile file = opened(source, std::move(answer));
            if (file.bytes <= max_bytes) return file;
            refuse(path, "is larger than " + std::to_string(max_bytes >> 20) + " MB");
        } catch (const FileError& error) {
            if (!is_readable) throw;
            refuse(path, error.message());
        }
    } catch (const FileError& error) {
        fail(path, error);
    }
    return std::nullopt;
}

// The text of the library. If it must not be copied, returns nothing and records the reason.
std::optional<std::string> MaterialCopier::read_library(const fs::path& library) try {
    const char* why = reason_against(from_, library);
    if (!why && !is_library_name(library)) why = "does not end in .mtl";
    if (why) {
        refuse(library, why);
        return std::nullopt;
    }
    const std::optional<OpenFile> file = open(library, limits_.library_bytes, progress_);
    if (!file) return std::nullopt;
    const std::string text =
        access_.read(*file, (from_ / library).string(), 0, file->bytes, progress_.part(0.0, 0.0));
    if (may_be_material_library(text)) return text;
    refuse(library, "is no material library");
    return std::nullopt;
} catch (const FileError& error) {
    fail(library, error);
    return std::nullopt;
}

// Returns whether the file is a library.
bool MaterialCopier::find_textures_of(const fs::path& library) {
    const std::optional<std::string> text = read_library(library);
    if (!text) return false;
    for (const Material& material : parse_materials(*text, progress_.part(0.0, 0.0))) {
        for (const std::string& name : material.textures) {
            find_once(name, library.parent_path(), textures_);
        }
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
    std::copy_if(not_found_.begin(), not_found_.end(), std::back_inserter(result_.missing),
                 [this](const std::string& name) { return !path_exists(to_ / name); });
    for (auto& [name, why] : refused_) result_.refused.push_back({name, why});
    for (auto& [name, why] : failed_) result_.failed.push_back({name, why});
    return std::move(result_);
}

void MaterialCopier::copy_one(const fs::path& path, const Progress& progress) try {
    const bool is_library = libraries_.contains(path);
    const char* why = reason_against(from_, path);
    if (!why) why = reason_against(to_, path);
    if (!why && !is_library && !is_picture_name(path)) why = "is not named as a picture";
    if (why) return refuse(path, why);
    if (path_exists(to_ / path)) return;
    const std::optional<OpenFile> file =
        open(path, is_library ? limits_.library_bytes : limits_.texture_bytes, progress);
    if (!file) return;
    if (!is_library &&
        !is_picture(access_, *file, (from_ / path).string(), progress.part(0.0, 0.0))) {
        return refuse(path, "is no picture");
    }
    copy_bytes(*file, path, progress);
    result_.copied.push_back(path.generic_string());
} catch (const FileError& error) {
    fail(path, error);
}

// Copies in pieces, because textures can be large.
void MaterialCopier::copy_bytes(const OpenFile& file, const fs::path& path,
                                const Progress& progress) {
    const std::string source = (from_ / path).string(), target = (to_ / path).string();
    std::error_code error;
    const fs::path folder = (to_ / path).parent_path();
    fs::create_directories(folder, error);
    if (error) {
        throw FileError(folder.string(), "the folder cannot be made: " + error.message());
    }
    AtomicFile out(target);
    constexpr std::size_t kPiece = std::size_t{1} << 20;
    std::size_t done = 0;
    while (true) {
        const std::string piece = access_.read(file, source, done, kPiece, progress.part(0.0, 0.0));
        if (piece.empty()) break;
        out.write(piece);
        done += piece.size();
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
        // If the folder is on a drive that no longer answers, every further call would wait for it.
        FileAccess().ask(source.string(), progress);
    } catch (const FileError& error) {
        MaterialCopy result;
        result.failed.push_back({source.string(), error.message()});
        return result;
    }
    std::error_code error;
    if (!fs::is_directory(target, error) || fs::equivalent(source, target, error)) return {};
    MaterialCopier copier(source, target, progress, limits);
    copier.find_libraries(material_libraries);
    copier.find_textures();
    return copier.copy();
}

}  // namespace pectin
