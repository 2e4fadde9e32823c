#include "app/frame_figures.h"

namespace pectin {

void FrameFigures::reset_drag() {
    steps = 1;
    degrees = 0.0;
    scale = 1.0;
    folded = 0;
}

void FrameFigures::record(const Frame& frame, std::chrono::duration<double> taken) {
    splits = frame.splits;
    unsplits = frame.unsplits;
    seconds = taken.count();
    deform_seconds = frame.deform_seconds;
    refine_seconds = frame.refine_seconds;
    decimate_seconds = frame.decimate_seconds;
    floor_hit = frame.floor_hit;
    budget_hit = frame.budget_hit;
    drag_budget_hit = frame.drag_budget_hit;
}

}  // namespace pectin
