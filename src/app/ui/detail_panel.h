// The section Detail: how fine drags make the mesh.
#pragma once

#include <optional>

#include "app/editor.h"
#include "app/ui/detail_advanced.h"
#include "app/ui/number_field.h"

namespace pectin {

class DetailPanel {
  public:
    // A setting changes when its field is released or typed. The object is only changed by the
    // button for it.
    void draw(Editor& editor);

    // The change of the settings that the user is choosing, if the panel has been drawn since the
    // last call.
    std::optional<command::Adapt> take_preview();

  private:
    void draw_detail(Editor& editor);
    void draw_angle(Editor& editor, const AdaptSettings& settings);
    void draw_tolerance(Editor& editor, const AdaptSettings& settings);

    NumberField fields_;
    DetailAdvanced advanced_;
    std::optional<command::Adapt> preview_;
};

}  // namespace pectin
