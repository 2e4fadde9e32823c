// The section Brush: how far drags reach and how they act, symmetry and pins.
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

    NumberField fields_;
};

}  // namespace pectin
