// The settings that say which lattice drags use: that of the brush, or a cage.
#pragma once

#include <optional>

#include "app/editor.h"

namespace pectin {

class CagePanel {
  public:
    // scale: of the screen.
    void draw(Editor& editor, float scale);

  private:
    void draw_cage(Editor& editor, const Lattice& cage, float scale);
    void draw_cage_actions(Editor& editor) const;

    // Values of fields that are being edited.
    std::optional<Box> edited_box_;
    std::optional<IVec3> edited_counts_;
    IVec3 counts_{4};  // for the next cage
};

}  // namespace pectin
