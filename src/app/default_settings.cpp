#include "app/default_settings.h"

#include "session/history.h"
#include "session/settings.h"

namespace pectin {

std::vector<Command> default_settings() {
    constexpr double kMegabyte = 1e6;
    const AdaptSettings adapt;
    const LatticeSettings lattice;
    const auto undo_limit = static_cast<double>(History::kDefaultLimit) / kMegabyte;
    return {command::Adapt{.enabled = adapt.enabled,
                           .trigger = adapt.trigger,
                           .theta_max = adapt.theta_max,
                           .theta_min = adapt.theta_min,
                           .tolerance = adapt.tolerance,
                           .l_max = adapt.l_max,
                           .flatness = adapt.flatness,
                           .floor = adapt.floor,
                           .budget = adapt.budget,
                           .drag_budget = adapt.drag_budget,
                           .propagation = adapt.propagation},
            command::Brush{.span = lattice.span, .falloff = lattice.falloff}, command::Symmetry{},
            command::History{Setting::of(undo_limit)}};
}

}  // namespace pectin
