// The section Cage: the box of control points around the object.
#pragma once

#include <optional>

#include "app/editor.h"
#include "app/ui/number_field.h"

namespace pectin {

class CagePanel {
  public:
    void draw(Editor& editor);

  private:
    void draw_counts(Editor& editor, const Box& box, const IVec3& counts);
    void draw_box(Editor& editor, const Box& box, const IVec3& counts);
    std::optional<double> draw_third(const char* name, int axis, double value,
                                     const NumberStyle& style, const char* help);

    NumberField fields_;
};

}  // namespace pectin
