#include "app/editor.h"

#include <algorithm>
#include <utility>

#include "app/command_kind.h"
#include "app/picture.h"
#include "io/file_error.h"

namespace pectin {
namespace {

// The part of the window between the panels on both sides, centred in the window.
constexpr double kFreeWidth = 0.56, kFreeHeight = 0.78;
// The space below an example for its panel, in heights of what is shown.
constexpr double kSpaceBelow = 0.35;

Vec3 below(const std::vector<Vec3>& points) {
    Box box;
    for (const Vec3& point : points) box.include(point);
    return box.centre() - Vec3{0.0, (0.5 + kSpaceBelow) * (box.max.y - box.min.y), 0.0};
}

}  // namespace

Editor::Editor(std::optional<Recorder> recorder, std::chrono::milliseconds max_blocking_time,
               Tools tools)
    : workspace_(std::move(recorder), max_blocking_time), tools_(std::move(tools)) {
    frame_all(kFitDirection);
}

void Editor::begin(const std::string& model) {
    if (!model.empty()) return document_.open(model);
    document_.make_first_object();
    set_symmetry(true);
}

// --- What the tools show.

void Editor::add_overlays(Overlay& overlay) const {
    for (const auto& tool : tools_) tool->overlay(*this, overlay);
    example_.overlay(overlay);
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

// --- For the document controller.

void Editor::command_done(const Command& command) {
    hover_.reset();
    if (makes_object(command)) reset_for_new_object();
    if (is_any_of<command::Undo, command::Redo>(command)) figures_.folded = 0;
    example_.command_done(command);
}

// Discards what belonged to the object before.
void Editor::reset_for_new_object() {
    figures_ = {};
    pins_.clear();
    frame_all(kFitDirection);
    reset_sizes();
    // The plane follows the centre of the new object.
    if (session().symmetry() && mirror_.through_centre) {
        document_.execute_keeping_message(symmetry_command(true));
    }
}

// Sizes that were set for the object before may be wrong by orders of magnitude for this one.
void Editor::reset_sizes() {
    const LatticeSettings& lattice = session().lattice_settings();
    const double diagonal = workspace_.diagonal();
    if ((lattice.radius || lattice.cage) && diagonal > 0.0) {
        document_.execute_keeping_message(command::Brush{.radius = kAutoRadius * diagonal});
    }
    const AdaptSettings& adapt = session().adapt_settings();
    command::Adapt change;
    if (adapt.l_max.kind == Setting::Kind::value) change.l_max = Setting::automatic();
    if (adapt.floor.kind == Setting::Kind::value) change.floor = Setting::automatic();
    if (change != command::Adapt{}) document_.execute_keeping_message(change);
}

void Editor::restoration_ended() {
    figures_ = {};
    pins_.clear();
    frame_all(kFitDirection);
}

void Editor::begin_example(Example example) {
    try {
        example_.begin(title_of(example), read_example(example, example_folders()));
    } catch (const FileError& error) {
        return workspace_.set_message(error.what());
    }
    shows_hint_ = false;
    // The view stays as it is while the example plays, so it shows all that will be there.
    std::vector<Vec3> points = referenced_positions(session().mesh());
    const std::vector<Vec3> targets = drag_targets(example_.steps());
    points.insert(points.end(), targets.begin(), targets.end());
    points.push_back(below(points));  // the panel with the caption
    frame(points, kFitDirection);
}

command::Screenshot Editor::picture_command(const std::string& path) const {
    return {
        .path = path,
        .size = glm::clamp(size_, 16, 8192),
        .camera = camera(),
        .show = {
            .wireframe = display.wireframe, .lattice = display.lattice, .levels = display.levels}};
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
    execute(command::Cage{.origin = cage.rest(cage.margin),
                          .cell = cage.cell,
                          .deformable = cage.counts(),
                          .margin = cage.margin});
}

// --- Actions.

void Editor::perform(Action action) {
    example_.interrupt();
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

void Editor::frame_all(const std::optional<Vec3>& direction) {
    frame(referenced_positions(session().mesh()), direction);
}

void Editor::frame(std::span<const Vec3> points, const std::optional<Vec3>& direction) {
    const double aspect = kFreeWidth * size_.x / (kFreeHeight * size_.y);
    navigation_.frame(points, aspect, kFreeHeight, direction);
}

// --- Help.

void Editor::show_help(HelpPage page) {
    const bool closes = help_page_ == page;
    help_page_.reset();
    if (!closes && !document_.has_dialog()) help_page_ = page;
}

}  // namespace pectin
