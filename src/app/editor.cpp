#include "app/editor.h"

#include <algorithm>
#include <utility>

#include "app/picture.h"

namespace pectin {
namespace {

// The part of the window between the panels on both sides, centred in the window.
constexpr double kFreeWidth = 0.56, kFreeHeight = 0.78;

}  // namespace

Editor::Editor(std::optional<Recorder> recorder, std::chrono::milliseconds max_blocking_time,
               Tools tools)
    : workspace_(std::move(recorder), max_blocking_time), tools_(std::move(tools)) {
    frame_all(kFitDirection);
}

// --- What the tools show.

void Editor::add_overlays(Overlay& overlay) const {
    for (const auto& tool : tools_) tool->overlay(*this, overlay);
}

std::optional<ScreenBox> Editor::selection_box() const {
    const Tool* const tool = active_tool();
    return tool ? tool->selection_box() : std::nullopt;
}

std::string_view Editor::status_hint() const {
    if (has_dialog()) return {};
    if (const Tool* const tool = active_tool()) return tool->status_hint(*this);
    if (!pointer_.is_in_viewport) return {};
    for (const auto& tool : tools_) {
        if (const std::string_view hint = tool->status_hint(*this); !hint.empty()) return hint;
    }
    return navigation_hint(pointer_.modifiers);
}

ShownSettings Editor::shown_settings() const {
    ShownSettings settings;
    for (const auto& tool : tools_) settings |= tool->settings();
    return settings;
}

// The outcome of the object stands for that of the last frame once there is no drag.
FrameFigures Editor::figures() const {
    FrameFigures figures = figures_;
    if (!is_dragging()) {
        const AdaptOutcome outcome = workspace_.object_figures().outcome;
        figures.floor_hit = outcome.floor_hit;
        figures.budget_hit = outcome.budget_hit;
        figures.drag_budget_hit = outcome.drag_budget_hit;
    }
    return figures;
}

// --- Radius, symmetry and cage.

void Editor::set_radius(double radius) {
    execute(command::Brush{.radius = std::clamp(radius, min_radius(), max_radius())});
}

command::Symmetry Editor::symmetry_command(bool is_on) const {
    command::Symmetry symmetry;
    if (is_on) {
        symmetry.plane = mirror_.plane;
        if (mirror_.through_centre) symmetry.through = workspace_.box().centre();
    }
    return symmetry;
}

void Editor::set_symmetry(bool is_on) { execute(symmetry_command(is_on)); }

void Editor::choose_mirror(const MirrorChoice& choice) {
    if (is_busy()) return;
    mirror_ = choice;
    if (session().symmetry()) set_symmetry(true);
}

void Editor::set_cage(const Box& box, const IVec3& counts) {
    const Lattice cage = fit_lattice(box, counts);
    execute(command::Cage{command::Cage::Grid{.origin = cage.rest(cage.margin),
                                              .cell = cage.cell,
                                              .deformable = cage.counts(),
                                              .margin = cage.margin}});
}

// --- Actions.

void Editor::perform(Action action) {
    const ActionInfo& info = info_of(action);
    if (!is_busy() && info.is_enabled(*this)) info.perform(*this);
}

void Editor::undo() {
    if (session().undo_count() > 0) {
        execute(command::Undo{});
    } else if (session().history().lost_undo_count() > 0) {
        workspace_.set_message(
            "There is nothing left to undo: older steps were dropped to limit memory. The limit is "
            "in the menu Edit, Memory for undo.");
    }
}

bool Editor::execute(const Command& command) {
    return !is_busy() && finish_command(command, workspace_.execute(command));
}

void Editor::new_shape(command::Shape::Kind kind, int resolution) {
    ask_or_do({command::Shape{kind, resolution}});
}

void Editor::quit() {
    if (is_working()) {
        cancel_work();
        quits_next_ = true;
    } else {
        ask_or_do({Question::Quit{}});
    }
}

void Editor::frame_all(const std::optional<Vec3>& direction) {
    const double aspect = kFreeWidth * size_.x / (kFreeHeight * size_.y);
    navigation_.frame(referenced_positions(session().mesh()), aspect, kFreeHeight, direction);
}

}  // namespace pectin
