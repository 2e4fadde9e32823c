// The section Brush: how far drags reach, how they fall off and act, symmetry and pins.
#pragma once

#include "app/editor.h"
#include "app/ui/number_field.h"

namespace pectin {

class BrushPanel {
  public:
    // In the mode of the cage, what matters to the brush alone is disabled.
    void draw(Editor& editor);

  private:
    void draw_radius(Editor& editor);
    void draw_points(Editor& editor);
    void draw_strength(Editor& editor);

    NumberField fields_;
};

}  // namespace pectin
