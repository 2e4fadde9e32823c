// Counts and timings of drags, for display.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

#include "session/session.h"

namespace pectin {

// Counts and timings of the most recent frame in which a drag changed the object.
struct FrameFigures {
    std::uint64_t splits = 0, unsplits = 0;
    double seconds = 0.0;  // without rendering
    double deform_seconds = 0.0, refine_seconds = 0.0, decimate_seconds = 0.0;
    bool floor_hit = false, budget_hit = false, drag_budget_hit = false;
    // --- Of the active drag; as initialised if there is none.
    std::size_t steps = 1;              // number of steps of a fold-free drag
    double degrees = 0.0, scale = 1.0;  // twist and scale at the grabbed point
    // --- Of the last drag.
    std::uint64_t folded = 0;  // number of folded vertices after it

    // Resets the figures of the active and the last drag.
    void reset_drag();
    void record(const Frame& frame, std::chrono::duration<double> taken);
};

}  // namespace pectin
