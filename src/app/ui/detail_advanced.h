// The settings behind the detail, each with its unit: angles, lengths and numbers of triangles.
#pragma once

#include "app/editor.h"
#include "app/ui/number_field.h"

namespace pectin {

// Whether the trigger asks by how much normals diverge, and what the controls of these angles say
// if it does not.
bool uses_angles(const AdaptSettings& settings);
inline constexpr const char* kUnusedAngleHelp =
    "This angle has no effect now, because the trigger goes by distances and not by angles.";

class DetailAdvanced {
  public:
    void draw(Editor& editor);

  private:
    struct Row;
    void draw_row(Editor& editor, const Row& row);
    static void draw_modes(Editor& editor, const Row& row);
    static void draw_trigger(Editor& editor, const AdaptSettings& settings);
    void draw_tolerance(Editor& editor, const AdaptSettings& settings);
    void draw_angles(Editor& editor, const AdaptSettings& settings);
    void draw_lengths(Editor& editor, const AdaptSettings& settings);
    void draw_budgets(Editor& editor, const AdaptSettings& settings);

    NumberField fields_;
};

}  // namespace pectin
