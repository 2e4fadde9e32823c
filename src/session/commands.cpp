// Commands that are not drags: objects, settings, readapt, bake, files.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "adapt/accumulated_error.h"
#include "command/json.h"
#include "geometry/decimal.h"
#include "io/atomic_file.h"
#include "io/replace_check.h"
#include "mesh/shapes.h"
#include "session/input_summary.h"
#include "session/session_state.h"

namespace pectin {
namespace {

ShapeKind shape_kind(command::Shape::Kind kind) {
    switch (kind) {
        case command::Shape::Kind::sphere:
            return ShapeKind::sphere;
        case command::Shape::Kind::cube:
            return ShapeKind::cube;
        case command::Shape::Kind::plane:
            return ShapeKind::plane;
        case command::Shape::Kind::torus:
            return ShapeKind::torus;
        case command::Shape::Kind::cylinder:
            return ShapeKind::cylinder;
    }
    return ShapeKind::sphere;
}

// The number of vertices of faces that lie strictly inside at least one of the zones.
std::uint64_t vertices_inside(const TriMesh& mesh, std::span<const Box> zones) {
    std::uint64_t count = 0;
    for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
        const VertexId v{i};
        if (!mesh.is_live(v) || !exists(mesh.half_edge(v))) continue;
        const auto contains = [&](const Box& zone) {
            return zone.contains_strictly(mesh.position(v));
        };
        if (std::any_of(zones.begin(), zones.end(), contains)) ++count;
    }
    return count;
}

// Whether a file is JSON and neither a model nor a script.
bool is_plain_json(const FileKind& kind, std::string_view contents) {
    return !kind.is_known() && is_json(contents);
}

}  // namespace

template <>
Done Session::State::run(const command::Open& open) {
    LoadedModel model = load_model(open);
    // Made first: if memory runs out here, the old object is kept.
    std::string summary = input_summary(open.path, model.report, model.read_report);
    adopt(std::move(model));
    remark = std::move(summary);
    return {};
}

template <>
Done Session::State::run(const command::Shape& shape) {
    const ShapeKind kind = shape_kind(shape.kind);
    adopt(make_model(build_mesh(make_shape(kind, shape.resolution))));
    return {};
}

template <>
Done Session::State::run(const command::Adapt& adapt) {
    const Result<AdaptSettings> changed = adapt_settings.with(adapt);
    if (!changed) return changed.refusal();
    adapt_settings = *changed;
    outcome.forget_limits();
    history.forget_limits();
    return {};
}

template <>
Done Session::State::run(const command::Brush& brush) {
    if (brush.radius) lattice_settings.radius = brush.radius;
    lattice_settings.span = brush.span.value_or(lattice_settings.span);
    lattice_settings.falloff = brush.falloff.value_or(lattice_settings.falloff);
    lattice_settings.cage.reset();
    return {};
}

// The object's box. If the symmetry plane goes through it, it is enlarged to be its own mirror
// image, since control points can then be moved on both sides at once.
Box Session::State::box_to_fit() const {
    Box box = mesh->bounding_box();
    if (!symmetry) return box;
    const Box image = symmetry->image(box);
    if (box.meets(image)) box.include(image);
    return box;
}

template <>
Done Session::State::run(const command::Cage& cage) {
    if (cage.fit && !has_object()) return no_object();
    const Lattice lattice = cage.fit
                                ? fit_lattice(box_to_fit(), *cage.fit)
                                : Lattice{.origin = *cage.origin - Vec3{cage.margin} * *cage.cell,
                                          .cell = *cage.cell,
                                          .deformable = *cage.deformable + 2 * cage.margin,
                                          .margin = cage.margin};
    if (!lattice.is_valid()) {
        return Refusal{"the cage must be finite and have at most " +
                       std::to_string(kMaxDeformable) +
                       " control points per axis with its margins"};
    }
    lattice_settings.cage = lattice;
    return {};
}

template <>
Done Session::State::run(const command::Symmetry& symmetry_command) {
    symmetry.reset();
    if (!symmetry_command.plane) return {};
    const int axis = static_cast<int>(*symmetry_command.plane);
    symmetry = MirrorPlane{axis, symmetry_command.through[axis]};
    return {};
}

// The zones in which readapt refines edges longer than l_max. A length that the user has set has
// nothing to do with a lattice and applies everywhere. Otherwise it comes from a lattice and
// applies in the zones of that lattice.
std::vector<Box> Session::State::zones_of_readapt(const AdaptSettings& settings) const {
    if (settings.l_max.kind != Setting::Kind::value) return zones_in_use;
    constexpr double kFar = std::numeric_limits<double>::max();
    return {Box{.min = Vec3{-kFar}, .max = Vec3{kFar}}};
}

Frame Session::State::adapt_everything() {
    const Warp no_warp;
    Embedding embedding(*active, no_warp);
    AdaptLimits adapt_limits = limits_in_use();
    const std::uint64_t faces = mesh->face_count();
    const auto drag_budget = adapt_settings.drag_budget_for(faces);
    const bool is_drag_budget_less =
        drag_budget && faces < adapt_limits.budget && *drag_budget < adapt_limits.budget - faces;
    if (is_drag_budget_less) adapt_limits.budget = faces + *drag_budget;
    // Once a budget is used up, refinement rests: until the settings change, or that of the object
    // until the next drag.
    if (outcome.has_ended_at_budget()) adapt_limits.budget = 0;
    const Criteria criteria(adapt_limits, zones_of_readapt(adapt_settings), {});
    Adaptation adaptation =
        adapt_without_self_intersections(*active, embedding, criteria, {}, stop);
    Frame frame;
    frame.splits = adaptation.refinement.splits;
    frame.unsplits = adaptation.decimation.unsplits;
    frame.floor_hit = adaptation.refinement.floor_hit;
    const bool is_used_up_now = adaptation.refinement.budget_hit && !outcome.has_ended_at_budget();
    frame.drag_budget_hit = is_used_up_now && is_drag_budget_less;
    frame.budget_hit = outcome.budget_hit || (is_used_up_now && !is_drag_budget_less);
    frame.error = accumulate_errors(*active, criteria);
    frame.assessment = assess(*active, criteria, std::move(adaptation.refinement.blocked));
    frame.refine_seconds = adaptation.refine_seconds;
    frame.decimate_seconds = adaptation.decimate_seconds;
    return frame;
}

template <>
Done Session::State::run(const command::Readapt& readapt) {
    if (!has_object()) return no_object();
    Stopwatch stopwatch;
    std::vector<FaceId> faces;
    for (std::uint32_t i = 0; i < mesh->face_slots(); ++i) {
        if (mesh->is_live(FaceId{i})) faces.push_back(FaceId{i});
    }
    last = {};
    last.influenced_vertices = vertices_inside(*mesh, zones_in_use);
    try {
        if (adapt_settings.trigger == command::Adapt::Trigger::certified) mesh->track_errors();
        active->begin(faces, Box{});
    } catch (...) {
        active->abandon();
        throw;
    }
    last.seconds.begin = stopwatch.lap();
    MeshChange change;
    try {
        const Frame frame = adapt_everything();
        change = active->finish();
        stopwatch.lap();
        record(frame);
        add_step(readapt, change);
    } catch (...) {  // stopped, or out of memory: restores the object
        if (active->is_begun()) {
            active->cancel();
            dirty = {};
            dirty.everything = true;  // the tree was not touched
        } else {
            undo(change, *mesh);
            update_everything();
        }
        outcome = history.outcome();
        throw;
    }
    last.seconds.commit = stopwatch.lap();
    return {};
}

template <>
Done Session::State::run(const command::Bake& bake) {
    if (!has_object()) return no_object();
    if (mesh->vertex_count() == mesh->base_vertex_count()) return {};
    History::Step step{bake, {}, outcome, std::make_unique<TriMesh>(mesh->baked())};
    stop.throw_if_requested();  // nothing has changed yet
    exchange(*step.exchanged);
    try {
        history.add(std::move(step));
    } catch (...) {
        exchange(*step.exchanged);
        throw;
    }
    last = {};
    return {};
}

template <>
Done Session::State::run(const command::Save& save) {
    if (!has_object()) return no_object();
    SaveReport report = save_model(*mesh, save, {}, material_folders);
    remark = std::move(report.text);
    has_failed_partly = report.has_failed;
    record_saved(save.path);
    return {};
}

template <>
Done Session::State::run(const command::Stats& stats) {
    if (!has_object()) return no_object();
    check_may_replace(stats.path, is_plain_json, "stats writes JSON files");
    write_file_atomically(stats.path, format_statistics(statistics()));
    return {};
}

template <>
Done Session::State::run(const command::Screenshot& screenshot) {
    if (!has_object()) return no_object();
    if (!viewport)
        return Refusal{"there is nothing here to draw with; replay the script with pectin"};
    check_may_replace(screenshot.path, is_png, "screenshot writes PNG pictures");
    const bool has_cage = lattice_settings.cage.has_value();
    return viewport->screenshot(*mesh, has_cage ? lattice_settings.cage : lattice_in_use,
                                screenshot);
}

// After the specialisations, which it needs.
Done Session::State::execute(const Command& command) {
    return std::visit([this](const auto& c) { return run(c); }, command);
}

}  // namespace pectin
