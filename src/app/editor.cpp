#include "app/editor.h"

#include <algorithm>
#include <utility>

#include "app/command_kind.h"
#include "app/tools/drag_tool.h"
#include "app/words.h"
#include "command/check.h"
#include "io/file_error.h"

namespace pectin {

Editor::Editor(std::optional<Recorder> recorder, std::chrono::milliseconds max_blocking_time,
               Tools tools)
    : workspace_(std::move(recorder), max_blocking_time), tools_(std::move(tools)) {
    view_control_.frame_all(kFitDirection);
}

void Editor::begin(const std::string& model) {
    // Work on a file may go on in the background, so the setting comes first.
    set_symmetry(true);
    if (!model.empty()) return document_.open(model);
    document_.make_first_object();
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
    const std::string_view view_hint =
        view_control_.hint(pointer_.at, pointer_.modifiers, holds_space_);
    if (view_control_.has_priority(pointer_.at, pointer_.modifiers, holds_space_)) {
        return view_hint;
    }
    for (const auto& tool : tools_) {
        if (const std::string_view hint = tool->status_hint(*this); !hint.empty()) return hint;
    }
    return view_hint;
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
    if (is_any_of<command::Undo, command::Redo>(command)) figures_ = {};
    if (is_any_of<command::Brush>(command)) update_radius_share();
    if (is_any_of<command::Drag>(command)) report_drag(*this);
    example_.command_done(command);
}

// Discards what belonged to the object before.
void Editor::reset_for_new_object() {
    figures_ = {};
    pins_.clear();
    last_drag.reset();
    view_control_.begin_object();
    reset_sizes();
    // The plane follows the centre of the new object.
    if (session().symmetry() && mirror_.through_centre) {
        document_.execute_keeping_message(symmetry_command(true));
    }
}

// Sizes that were set for the object before may be wrong by orders of magnitude for this one. The
// radius keeps its share of the object, or in the model's units its length as far as the object
// allows it.
void Editor::reset_sizes() {
    const LatticeSettings& lattice = session().lattice_settings();
    const double diagonal = workspace_.diagonal();
    if ((lattice.radius || lattice.cage) && diagonal > 0.0) {
        const bool keeps_length = brush_size_.unit == RadiusUnit::model && lattice.radius;
        const double radius = keeps_length ? *lattice.radius : brush_size_.share * diagonal;
        document_.execute_keeping_message(
            command::Brush{.radius = std::clamp(radius, min_radius(), max_radius())});
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
    last_drag.reset();
    update_radius_share();
    view_control_.begin_object();
}

void Editor::begin_example(Example example) {
    try {
        example_.begin(title_of(example), read_example(example, example_folders()));
    } catch (const FileError& error) {
        return workspace_.set_message(words_of(error));
    }
    shows_hint_ = false;
    // The view stays as it is while the example plays, so it shows all that will be there.
    view_control_.frame_with(drag_targets(example_.steps()));
}

command::Screenshot Editor::picture_command(const std::string& path) const {
    return {.path = path,
            .size = glm::clamp(size(), 16, 8192),
            .camera = camera(),
            .show = {.wireframe = display.wireframe,
                     .lattice = display.lattice,
                     .levels = display.levels,
                     .light = preferences.theme == Theme::light}};
}

// --- Radius, symmetry and cage.

void Editor::update_radius_share() {
    const double diagonal = workspace_.diagonal();
    if (diagonal > 0.0) brush_size_.share = workspace_.radius() / diagonal;
}

void Editor::set_radius(double radius) {
    const double clamped = std::clamp(radius, min_radius(), max_radius());
    if (brush_size_.unit == RadiusUnit::screen) {
        brush_size_.pixels = radius_range().clamped(clamped / pixel_length_at_cursor());
    }
    execute(command::Brush{.radius = clamped});
}

void Editor::set_radius_value(double value) {
    if (is_busy()) return;
    const double clamped = radius_range().clamped(value);
    if (brush_size_.unit == RadiusUnit::screen) {
        brush_size_.pixels = clamped;
    } else {
        execute(command::Brush{.radius = model_radius(clamped, {})});
    }
}

void Editor::set_radius_unit(RadiusUnit unit) {
    if (is_busy() || has_cage() || unit == brush_size_.unit) return;
    const double radius = this->radius();
    brush_size_.unit = unit;
    set_radius(radius);
}

void Editor::use_radius_at(const Vec3& point) {
    if (brush_size_.unit != RadiusUnit::screen || has_cage()) return;
    const double radius = model_radius(brush_size_.pixels, point);
    if (radius != workspace_.radius()) execute(command::Brush{.radius = radius});
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

void Editor::use_brush() {
    if (is_busy()) return;
    sets_pins = false;
    if (!session().lattice_settings().cage) return;
    set_radius(workspace_.radius());
    if (!session().lattice_settings().cage) display.lattice = false;
}

void Editor::use_cage() {
    if (is_busy()) return;
    sets_pins = false;
    if (!session().lattice_settings().cage) fit_cage();
}

void Editor::fit_cage() {
    if (execute(command::Cage{.fit = cage_counts})) display.lattice = true;
}

void Editor::choose_cage_counts(const Box& box, const IVec3& counts) {
    const Done allowed = check(command::Cage{.fit = counts});
    if (!allowed) return workspace_.set_message(words_of(allowed.refusal()));
    cage_counts = counts;
    if (session().lattice_settings().cage) set_cage(box, counts);
}

// --- Actions.

void Editor::perform(Action action) {
    example_.interrupt();
    const ActionInfo& info = info_of(action);
    if (is_busy()) return;
    if (info.is_enabled(*this)) return info.perform(*this);
    if (*info.needs) workspace_.set_message(info.needs, Messages::Kind::information);
}

void Editor::undo() {
    if (session().undo_count() > 0) {
        execute(command::Undo{});
    } else if (session().history().lost_undo_count() > 0) {
        workspace_.set_message(
            "Nothing is left to undo. Older steps were dropped to save memory; Edit, Memory for "
            "undo sets the limit.");
    }
}

void Editor::set_free_area(const ScreenBox& area, double scale) {
    view_control_.set_free_area(area, scale);
    if (!is_busy()) view_control_.follow_free_area();
}

// --- Help.

void Editor::show_help(HelpPage page) {
    const bool closes = help_page_ == page;
    help_page_.reset();
    if (!closes && !document_.has_dialog()) help_page_ = page;
}

}  // namespace pectin
