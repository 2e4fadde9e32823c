// The settings that say when the mesh is refined and decimated.
#pragma once

#include <optional>

#include "app/editor.h"

namespace pectin {

class RefinePanel {
  public:
    // A setting changes at once, or, with a slider, when it is released. The object is only
    // readapted by the button for it.
    void draw(Editor& editor);

  private:
    struct Row;
    // Returns the new setting if the user has changed it.
    std::optional<Setting> draw_row(const Row& row, std::optional<float>& edited) const;
    void draw_angles(Editor& editor);
    void draw_length(Editor& editor);
    static void draw_readapt(Editor& editor);

    // Values of sliders that are being dragged.
    std::optional<float> theta_max_, theta_min_, l_max_;
};

}  // namespace pectin
