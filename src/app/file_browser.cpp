#include "app/file_browser.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>

#include "app/words.h"
#include "io/file_error.h"
#include "io/model_format.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

bool precedes(const FileEntry& a, const FileEntry& b) {
    if (a.is_folder != b.is_folder) return a.is_folder;
    const std::string a_lower = lower(a.name), b_lower = lower(b.name);
    return a_lower != b_lower ? a_lower < b_lower : a.name < b.name;
}

std::string home() {
    const char* const folder = std::getenv("HOME");
    return folder ? folder : "/";
}

std::string absolute_path(const fs::path& path) {
    std::error_code error;
    const fs::path whole = fs::absolute(path, error);
    return error ? path.string() : whole.lexically_normal().string();
}

bool has_one_of(const std::string& path, std::span<const std::string> extensions) {
    return std::any_of(extensions.begin(), extensions.end(), [&path](const std::string& extension) {
        return has_extension(path, extension);
    });
}

std::vector<std::string> extensions_for(FileBrowser::Purpose purpose) {
    switch (purpose) {
        case FileBrowser::Purpose::open:
            return readable_extensions();
        case FileBrowser::Purpose::save:
            return writable_extensions();
        case FileBrowser::Purpose::save_picture:
            break;
    }
    return {".png"};
}

}  // namespace

std::vector<FileEntry> list_folder(const std::string& folder,
                                   std::span<const std::string> extensions) {
    std::error_code error;
    fs::directory_iterator at(folder, error);
    if (error) throw FileError(folder, "cannot be shown: " + error.message());
    std::vector<FileEntry> entries;
    for (const fs::directory_iterator end; at != end && !error; at.increment(error)) {
        std::error_code ignored;
        FileEntry entry{.name = at->path().filename().string(),
                        .is_folder = at->is_directory(ignored)};
        if (entry.name.starts_with('.')) continue;
        if (!entry.is_folder) {
            if (!at->is_regular_file(ignored) || !has_one_of(entry.name, extensions)) continue;
            entry.bytes = at->file_size(ignored);
            if (ignored) entry.bytes = 0;
        }
        entries.push_back(std::move(entry));
    }
    std::sort(entries.begin(), entries.end(), precedes);
    return entries;
}

FileBrowser::FileBrowser(Purpose purpose, const std::string& path)
    : purpose_(purpose), extensions_(extensions_for(purpose)) {
    if (purpose != Purpose::open) name = fs::path(path).filename().string();
    const std::string folder = fs::path(path).parent_path().string();
    open_folder(folder.empty() ? "." : folder);
    if (!error_.empty()) open_folder(home());
    if (!error_.empty()) open_folder("/");
}

const char* FileBrowser::title() const {
    switch (purpose_) {
        case Purpose::open:
            return "Open a model";
        case Purpose::save:
            return "Save the model";
        case Purpose::save_picture:
            return "Save a picture";
    }
    return "";
}

const char* FileBrowser::accept_label() const {
    return purpose_ == Purpose::open ? "Open" : "Save";
}

std::vector<FileBrowser::Breadcrumb> FileBrowser::breadcrumbs() const {
    std::vector<Breadcrumb> breadcrumbs;
    fs::path whole;
    for (const fs::path& part : fs::path(folder_)) {
        if (part.empty()) continue;
        whole /= part;
        breadcrumbs.push_back({part.string(), whole.string()});
    }
    return breadcrumbs;
}

void FileBrowser::open_folder(const std::string& folder) {
    std::string whole = absolute_path(folder);
    if (whole.size() > 1 && whole.ends_with('/')) whole.pop_back();
    try {
        entries_ = list_folder(whole, extensions_);
        folder_ = whole;
        error_.clear();
        wants_focus = true;
    } catch (const FileError& error) {
        error_ = words_of(error);
    }
}

void FileBrowser::open_parent_folder() { open_folder(fs::path(folder_).parent_path().string()); }

std::string FileBrowser::choose() {
    if (name.empty()) return {};
    fs::path path = name;
    if (name == "~" || name.starts_with("~/")) path = home() + name.substr(1);
    std::string whole = absolute_path(fs::path(folder_) / path);
    std::error_code ignored;
    if (fs::is_directory(whole, ignored)) {
        open_folder(whole);
        if (error_.empty()) name.clear();
        return {};
    }
    if (purpose_ != Purpose::open && !has_one_of(whole, extensions_)) whole += extensions_.front();
    return whole;
}

bool FileBrowser::exists(const std::string& path) {
    std::error_code ignored;
    return fs::exists(path, ignored);
}

}  // namespace pectin
