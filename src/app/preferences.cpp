#include "app/preferences.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <utility>

#include "io/atomic_file.h"
#include "io/file_error.h"
#include "io/read_file.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kMostBytes = 1 << 20;
constexpr std::array kScales{0.5, 0.75, 0.9, 1.0, 1.1, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0};
static_assert(kScales.front() == kLeastTextScale && kScales.back() == kMostTextScale);

constexpr const char* kTheme = "theme";
constexpr const char* kScale = "scale";
constexpr const char* kHidesPanels = "hides_panels";
constexpr const char* kMouse = "mouse";
constexpr const char* kDark = "dark";
constexpr const char* kLight = "light";

// Returns the variable's value if it is an absolute path. A relative one is invalid and ignored.
std::string folder_in(const char* variable) {
    const char* const value = std::getenv(variable);
    return value && value[0] == '/' ? value : "";
}

// Reads one field if it is there. Returns whether the value can be used.
template <typename Read>
bool read_field(const Json& file, const char* name, Read read) {
    const auto field = file.find(name);
    return field == file.end() || read(*field);
}

bool read_theme(const Json& value, Theme& theme) {
    if (value != kDark && value != kLight) return false;
    theme = value == kLight ? Theme::light : Theme::dark;
    return true;
}

bool read_scale(const Json& value, double& scale) {
    if (!value.is_number()) return false;
    const double number = value.get<double>();
    if (!(number >= kLeastTextScale && number <= kMostTextScale)) return false;
    scale = number;
    return true;
}

bool read_flag(const Json& value, bool& flag) {
    if (value.is_boolean()) flag = value.get<bool>();
    return value.is_boolean();
}

bool read_mouse(const Json& value, MousePreset& mouse) {
    if (!value.is_string()) return false;
    const auto preset = mouse_preset_named(value.get<std::string>());
    if (preset) mouse = *preset;
    return preset.has_value();
}

// Returns the names of the fields whose values cannot be used.
std::string read_fields(const Json& file, Preferences& p) {
    std::string bad;
    const auto check = [&bad](const char* name, bool is_right) {
        if (!is_right) bad += (bad.empty() ? "" : ", ") + std::string(name);
    };
    using Value = const Json&;
    check(kTheme, read_field(file, kTheme, [&](Value v) { return read_theme(v, p.theme); }));
    check(kScale, read_field(file, kScale, [&](Value v) { return read_scale(v, p.scale); }));
    check(kHidesPanels,
          read_field(file, kHidesPanels, [&](Value v) { return read_flag(v, p.hides_panels); }));
    check(kMouse, read_field(file, kMouse, [&](Value v) { return read_mouse(v, p.mouse); }));
    return bad;
}

void write_changes(Json& file, const Preferences& before, const Preferences& now) {
    if (now.theme != before.theme) file[kTheme] = now.theme == Theme::light ? kLight : kDark;
    if (now.scale != before.scale) file[kScale] = now.scale;
    if (now.hides_panels != before.hides_panels) file[kHidesPanels] = now.hides_panels;
    if (now.mouse != before.mouse) file[kMouse] = name(now.mouse);
}

// The object in the file; nothing if there is none in it. Throws FileError.
std::optional<Json> read_object(const std::string& path) {
    Json file = Json::parse(read_whole_file(path, {}, kMostBytes), nullptr, false);
    if (!file.is_object()) return std::nullopt;
    return file;
}

bool is_there(const std::string& path) {
    std::error_code ignored;
    return fs::exists(path, ignored);
}

}  // namespace

double larger_scale(double scale) {
    const auto* const next = std::upper_bound(kScales.begin(), kScales.end(), scale);
    return next == kScales.end() ? scale : *next;
}

double smaller_scale(double scale) {
    const auto* const at = std::lower_bound(kScales.begin(), kScales.end(), scale);
    return at == kScales.begin() ? scale : *std::prev(at);
}

std::string preferences_path() {
    std::string folder = folder_in("XDG_CONFIG_HOME");
    if (folder.empty()) {
        const std::string home = folder_in("HOME");
        if (home.empty()) return {};
        folder = home + "/.config";
    }
    return folder + "/pectin/preferences.json";
}

PreferencesFile::Loaded PreferencesFile::load() {
    Loaded loaded;
    if (path_.empty() || !is_there(path_)) return loaded;
    try {
        if (const std::optional<Json> file = read_object(path_)) {
            const std::string bad = read_fields(*file, loaded.preferences);
            if (!bad.empty()) {
                loaded.notice =
                    "The preferences in " + path_ +
                    " have values that cannot be used, and their defaults count: " + bad + ".";
            }
        } else {
            is_unreadable_ = true;
            loaded.notice = "The preferences in " + path_ +
                            " cannot be read, so the defaults are used. The file is kept.";
        }
    } catch (const FileError& error) {
        is_unreadable_ = true;
        loaded.notice = std::string("The preferences cannot be read, so the defaults are used: ") +
                        error.what() + ".";
    }
    last_ = loaded.preferences;
    return loaded;
}

void PreferencesFile::save(const Preferences& preferences) {
    if (path_.empty() || preferences == last_) return;
    const Preferences before = std::exchange(last_, preferences);
    std::error_code error;
    const fs::path folder = fs::path(path_).parent_path();
    fs::create_directories(folder, error);
    if (error) throw FileError(folder.string(), "the folder cannot be made: " + error.message());
    Json file = Json::object();
    if (is_unreadable_) {
        keep_unreadable_file();
        is_unreadable_ = false;
    } else if (is_there(path_)) {
        // Another window may have written the file since, so it is read again.
        if (std::optional<Json> present = read_object(path_)) file = std::move(*present);
    }
    write_changes(file, before, preferences);
    write_file_atomically(path_, file.dump(2) + "\n");
}

void PreferencesFile::keep_unreadable_file() const {
    if (!is_there(path_)) return;
    std::error_code error;
    fs::rename(path_, path_ + ".unreadable", error);
    if (error) throw FileError(path_, "cannot be renamed: " + error.message());
}

}  // namespace pectin
