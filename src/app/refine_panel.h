// The part of the settings that says when the mesh is refined and decimated.
#pragma once

#include <optional>

#include "app/editor.h"

namespace pectin {

class RefinePanel {
  public:
    // A changed setting re-adapts the object at once; a slider does so when it is released.
    void draw(Editor& editor);

  private:
    struct Row;
    // What the row was set to, if it was.
    std::optional<Setting> draw_row(const Row& row, std::optional<float>& edited) const;
    void draw_angles(Editor& editor);
    void draw_length(Editor& editor);

    // While a slider is held.
    std::optional<float> theta_max_, theta_min_, l_max_;
};

}  // namespace pectin
