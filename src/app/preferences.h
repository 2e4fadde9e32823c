// What the user prefers of the window, and the file that keeps it from one session to the next.
#pragma once

#include <string>

#include "app/mouse_preset.h"

namespace pectin {

enum class Theme { dark, light };

struct Preferences {
    Theme theme = Theme::dark;
    double scale = 1.0;  // of text and controls, on top of that of the screen
    bool hides_panels = false;
    MousePreset mouse = MousePreset::blender;  // which buttons move the view
    bool operator==(const Preferences&) const = default;
};

inline constexpr double kLeastTextScale = 0.5, kMostTextScale = 3.0;
// The next scale that menus and keys offer; the same one at the end of the range.
double larger_scale(double scale);
double smaller_scale(double scale);

// Returns $XDG_CONFIG_HOME/pectin/preferences.json, or the same in ~/.config. The result is empty
// if the environment names neither folder.
std::string preferences_path();

// A JSON object with a field for each preference. Fields that this version does not know, and those
// whose values it cannot use, stay in the file.
class PreferencesFile {
  public:
    // path: of the file, which need not exist; if empty, nothing is read or written.
    explicit PreferencesFile(std::string path) : path_(std::move(path)) {}

    struct Loaded {
        Preferences preferences{};  // with defaults for what cannot be read
        std::string notice{};       // what is wrong with the file, for the user; often empty
    };
    Loaded load();

    // Writes what differs from the preferences that were loaded or saved last; does nothing if
    // nothing does. A file that could not be read is kept with ".unreadable" after its name.
    // Throws FileError; the file is then unchanged, and the next call does nothing unless the
    // preferences have changed again.
    void save(const Preferences& preferences);

  private:
    void keep_unreadable_file() const;

    std::string path_;
    Preferences last_;  // in the file
    bool is_unreadable_ = false;
};

}  // namespace pectin
