// The schema of the commands: for each command its name and meaning, and for each field its name,
// what it may be, its default and one sentence. Parsing, printing, limits, help, JSON Schema and
// the table in the README all follow from here. Modules that cannot see commands have some of the
// limits as constants of their own; tests compare them.
//
// To add a field, add a member to the command's struct and a line here.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <tuple>

#include "command/command.h"
#include "command/field_types.h"

namespace pectin {

// Whether an empty optional stands for a field that was left out, and not for null or a word.
template <typename Member, typename Type>
inline constexpr bool kIsLeftOutIfEmpty = false;
template <typename T, typename Type>
inline constexpr bool kIsLeftOutIfEmpty<std::optional<T>, Type> = true;
template <typename T, std::size_t N>
inline constexpr bool kIsLeftOutIfEmpty<std::optional<T>, field::ChoiceOrNull<N>> = false;
template <typename T>
inline constexpr bool kIsLeftOutIfEmpty<std::optional<T>, field::ObjectOr> = false;

template <typename Owner, typename Member, typename Type>
struct Field {
    const char* name;
    Member Owner::*member;
    Type type;
    // The default as JSON or in words; null if the field has to be there.
    const char* initial;
    const char* meaning;

    // Any value of the type that the field has where it is there.
    static auto any_value() {
        if constexpr (kIsLeftOutIfEmpty<Member, Type>) {
            return typename Member::value_type{};
        } else {
            return Member{};
        }
    }
    bool is_required() const { return initial == nullptr; }
    // The value, or null if the field was left out.
    auto* value_in(const Owner& owner) const {
        if constexpr (kIsLeftOutIfEmpty<Member, Type>) {
            return owner.*member ? &*(owner.*member) : nullptr;
        } else {
            return &(owner.*member);
        }
    }
    // The value, which is there from now on.
    auto& add_to(Owner& owner) const {
        if constexpr (kIsLeftOutIfEmpty<Member, Type>) {
            return (owner.*member).emplace();
        } else {
            return owner.*member;
        }
    }
};

template <typename Owner, typename Member, typename Type>
constexpr Field<Owner, Member, Type> make_field(const char* name, Member Owner::*member,
                                                const Type& type, const char* initial,
                                                const char* meaning) {
    return {name, member, type, initial, meaning};
}

inline constexpr const char* kRequired = nullptr;

// The finest resolution of each kind of shape, in the order of their words.
inline constexpr std::array kMostResolutions{9, 707, 1732, 612, 500};

// Schema<C> has the members
//   kName     of the command, or what a nested object is
//   kMeaning  one sentence or a few
//   kFields   a tuple of Field
template <typename C>
struct Schema;

// Calls visit(field) for each field, in order.
template <typename C, typename Visit>
constexpr void for_each_field(Visit visit) {
    std::apply([&](const auto&... fields) { (visit(fields), ...); }, Schema<C>::kFields);
}

template <>
struct Schema<command::Open> {
    static constexpr const char* kName = "open";
    static constexpr const char* kMeaning =
        "Reads a model, which becomes the object. A new history begins.";
    static constexpr std::tuple kFields{
        make_field("path", &command::Open::path, field::Path{"an OBJ file"}, kRequired,
                   "The file to read."),
        make_field("crease_angle", &command::Open::crease_angle,
                   field::Number{field::between(0.0, 180.0), field::Unit::angle}, "45",
                   "Where the file has neither normals nor smoothing groups, edges whose faces "
                   "turn by more are creases.")};
};

template <>
struct Schema<command::Shape> {
    static constexpr const char* kName = "shape";
    static constexpr const char* kMeaning = "Makes a new object. A new history begins.";
    static constexpr std::tuple kFields{
        make_field("kind", &command::Shape::kind,
                   field::Choice<5>{{"sphere", "cube", "plane", "torus", "cylinder"}}, kRequired,
                   "The shape: a sphere of radius 1, a cube of side 2, a plane of side 2 in y = 0, "
                   "a torus about y with radii 1 and 0.4, or a cylinder about y of radius 1 and "
                   "height 2."),
        make_field(
            "resolution", &command::Shape::resolution, field::Whole{0, 1732}, kRequired,
            "How fine it is. A sphere has 20 * 4^resolution faces, from 0 to 9. A cube (1 to "
            "707) and a plane (1 to 1732) have resolution * resolution quads a side; a "
            "torus (1 to 612) and a cylinder (1 to 500) have some more.")};
};

template <>
struct Schema<command::Adapt> {
    static constexpr const char* kName = "adapt";
    static constexpr const char* kMeaning =
        "Sets when the mesh is refined and decimated. Settings that are left out do not change.";
    static constexpr std::tuple kFields{
        make_field("enabled", &command::Adapt::enabled, field::Flag{}, "true",
                   "Whether drags refine and decimate."),
        make_field("trigger", &command::Adapt::trigger,
                   field::Choice<3>{{"normals", "midpoint", "certified"}}, "\"normals\"",
                   "What tells that the surface bends: the normals at an edge's ends, by theta_max "
                   "and theta_min, how far its middle leaves the faces at it, by tolerance, or how "
                   "far a face is from the exact surface at most, by tolerance."),
        make_field(
            "theta_max", &command::Adapt::theta_max,
            field::NumberOr{field::above(0.0), field::Unit::angle}.or_null(), "180/7",
            "With normals, an edge whose end normals diverge by more is refined, unless they "
            "diverged nearly as much before the drag; null: none is."),
        make_field("theta_min", &command::Adapt::theta_min,
                   field::NumberOr{field::at_least(0.0), field::Unit::angle}.or_auto().or_null(),
                   "\"auto\"",
                   "With normals, an edge whose end normals diverge by less may be decimated; "
                   "\"auto\": 7/9 of theta_max; null: any angle."),
        make_field("tolerance", &command::Adapt::tolerance,
                   field::NumberOr{field::above(0.0), field::Unit::length}.or_auto(), "\"auto\"",
                   "With midpoint, an edge is refined if its middle is farther from the planes of "
                   "its two faces, in sum, and a vertex may be decimated if it is nearer than a "
                   "quarter of this to the middle of the edge that it leaves; with certified, the "
                   "largest distance that is left; \"auto\": 1e-3 of the box diagonal."),
        make_field("l_max", &command::Adapt::l_max,
                   field::NumberOr{field::above(0.0), field::Unit::length}.or_auto().or_null(),
                   "\"auto\"",
                   "An edge in the zone of a drag that is longer is refined, with a length also by "
                   "readapt in the whole object; \"auto\": the smallest cell extent of the lattice "
                   "in use, and in a fold-free drag of several steps longer edges may stay where "
                   "the surface is straight, with certified null; null: none is."),
        make_field("flatness", &command::Adapt::flatness,
                   field::NumberOr{field::at_least(0.0), field::Unit::ratio}.or_auto().or_null(),
                   "\"auto\"",
                   "How far decimation may move the surface, in lengths of the edge that it "
                   "restores; \"auto\": tan(theta_max / 4) / 2, with certified null; null: any."),
        make_field("floor", &command::Adapt::floor,
                   field::NumberOr{field::above(0.0), field::Unit::length}.or_auto(), "\"auto\"",
                   "An edge shorter than twice this is kept; \"auto\": 1e-4 of the box diagonal."),
        make_field("budget", &command::Adapt::budget, field::Whole{}, "4000000",
                   "The most triangles that the object may get."),
        make_field(
            "drag_budget", &command::Adapt::drag_budget,
            field::NumberOr{field::between(1.0, field::kMostWhole), field::Unit::none, true}
                .or_auto()
                .or_null(),
            "\"auto\"",
            "The most triangles that one drag, control or readapt may add; \"auto\": 200000, "
            "or four times the faces that it works on if that is more; null: no limit."),
        make_field("propagation", &command::Adapt::propagation,
                   field::Number{field::at_least_and_below(1.0, 1.5)}, "1",
                   "How much longer than a split edge the other edges of its faces may be.")};
};

template <>
struct Schema<command::Brush> {
    static constexpr const char* kName = "brush";
    static constexpr const char* kMeaning =
        "From now on drags use a lattice around the point that they grab.";
    static constexpr std::tuple kFields{
        make_field("radius", &command::Brush::radius,
                   field::Number{field::above(0.0), field::Unit::length},
                   "a quarter of the box diagonal", "How far the lattice reaches."),
        make_field("span", &command::Brush::span, field::Whole{1, 16}, "3",
                   "The number of control points along each axis that may move."),
        make_field("falloff", &command::Brush::falloff, field::Choice<2>{{"sharp", "plateau"}},
                   "\"sharp\"",
                   "How a drag decreases around its points; sharp: to a peak, the narrower the "
                   "more control points there are; plateau: control points around the point move "
                   "as far as the point, and more of them make it wider.")};
};

template <>
struct Schema<command::Cage> {
    static constexpr const char* kName = "cage";
    static constexpr const char* kMeaning =
        "From now on drags use this lattice, until the next brush: either origin, cell and "
        "deformable, or fit.";
    static constexpr std::tuple kFields{
        make_field("origin", &command::Cage::origin, field::Point{}, "none",
                   "The position of its control point [0, 0, 0]."),
        make_field("cell", &command::Cage::cell, field::Point{field::above(0.0)}, "none",
                   "The distances of its control points along each axis."),
        make_field("deformable", &command::Cage::deformable, field::Counts{1, 256}, "none",
                   "The numbers of its control points along each axis."),
        make_field("margin", &command::Cage::margin, field::Counts{0, 2}, "[0, 0, 0]",
                   "The numbers of further layers of control points on both sides along each "
                   "axis."),
        make_field("fit", &command::Cage::fit, field::Counts{1, 254}, "none",
                   "The numbers of control points along each axis of the object's box. One more "
                   "layer lies beyond the box on each side, and two where a number is 1, so that "
                   "moving all of them by one affine map moves the object by that map. A box that "
                   "the symmetry plane meets is enlarged to be its own mirror image.")};
};

template <>
struct Schema<command::Symmetry> {
    static constexpr const char* kName = "symmetry";
    static constexpr const char* kMeaning =
        "From now on drags, pins and control points act on both sides of a plane at once. A point "
        "on the plane stays on it, and none can be dragged across.";
    static constexpr std::tuple kFields{
        make_field("plane", &command::Symmetry::plane, field::ChoiceOrNull<3>{{"x", "y", "z"}},
                   kRequired, "The axis that the plane is perpendicular to; null: no symmetry."),
        make_field("through", &command::Symmetry::through, field::Point{}, "[0, 0, 0]",
                   "A point on the plane.")};
};

template <>
struct Schema<Twist> {
    static constexpr const char* kName = "twist";
    static constexpr const char* kMeaning = "A rotation about an axis through the point.";
    static constexpr std::tuple kFields{
        make_field("axis", &Twist::axis, field::Point{}, kRequired,
                   "The axis, of any length above 0."),
        make_field("degrees", &Twist::degrees,
                   field::Number{field::between(-3600.0, 3600.0), field::Unit::angle}, kRequired,
                   "The angle, by the right-hand rule.")};
};

template <>
struct Schema<Move> {
    static constexpr const char* kName = "move";
    static constexpr const char* kMeaning = "A point that is moved.";
    static constexpr std::tuple kFields{
        make_field("from", &Move::from, field::Point{}, kRequired,
                   "The point, which has to lie inside the influenced zone of the lattice."),
        make_field("to", &Move::to, field::Point{}, kRequired, "Where it goes."),
        make_field("twist", &Move::twist, field::Object{}, "none",
                   "How the surroundings turn right at the point. With fold_free they turn all the "
                   "way, otherwise only where the turn ends counts."),
        make_field("scale", &Move::scale, field::Number{field::between(0.001, 1000.0)}, "1",
                   "How the surroundings grow right at the point.")};
};

template <>
struct Schema<command::Drag> {
    static constexpr const char* kName = "drag";
    static constexpr const char* kMeaning =
        "Drags points, and the object follows. At most 1024 different points are moved and pinned; "
        "one with a twist or a scale counts as four, and with symmetry each beside the plane "
        "counts twice.";
    static constexpr std::tuple kFields{
        make_field("moves", &command::Drag::moves,
                   field::List<field::Object>{.may_be_empty = false}, kRequired,
                   "The points to move."),
        make_field("pins", &command::Drag::pins, field::List<field::Point>{}, "[]",
                   "Points that stay."),
        make_field("connected", &command::Drag::connected, field::Flag{}, "false",
                   "Whether only the surface follows that is connected to the moved points inside "
                   "the zone. If it passes through a part that stays, this is reported."),
        make_field("fold_free", &command::Drag::fold_free, field::Flag{}, "false",
                   "Whether the drag goes in steps that do not turn space inside out, at most 256, "
                   "with the brush centred anew at each, and refines until no triangles intersect "
                   "that were apart, as far as floor and budget allow; what is left is reported."),
        make_field("via", &command::Drag::via, field::List<field::Point>{}, "[]",
                   "Waypoints of the first move, each the end of a step. Twists and further moves "
                   "happen after the last of them.")};
};

template <>
struct Schema<command::Control::Point> {
    static constexpr const char* kName = "control point";
    static constexpr const char* kMeaning = "A control point that is moved.";
    static constexpr std::tuple kFields{
        make_field("index", &command::Control::Point::index, field::Counts{-2, 255}, kRequired,
                   "Which one, from [0, 0, 0]; layers beyond a fitted box have the indices -1 and "
                   "-2, and those after the last."),
        make_field("to", &command::Control::Point::to, field::Point{}, kRequired,
                   "Where it goes.")};
};

template <>
struct Schema<command::Control> {
    static constexpr const char* kName = "control";
    static constexpr const char* kMeaning =
        "Moves control points of the cage, and the object follows. Folds are counted, not "
        "prevented. The cage is regular again afterwards.";
    static constexpr std::tuple kFields{make_field(
        "points", &command::Control::points, field::List<field::Object>{.may_be_empty = false},
        kRequired, "The control points to move, each once.")};
};

template <>
struct Schema<command::Undo> {
    static constexpr const char* kName = "undo";
    static constexpr const char* kMeaning = "Undoes edits, the latest first.";
    static constexpr std::tuple kFields{
        make_field("count", &command::Undo::count, field::Whole{1, 2147483647}, "1", "How many.")};
};

template <>
struct Schema<command::Redo> {
    static constexpr const char* kName = "redo";
    static constexpr const char* kMeaning = "Does undone edits again.";
    static constexpr std::tuple kFields{
        make_field("count", &command::Redo::count, field::Whole{1, 2147483647}, "1", "How many.")};
};

template <>
struct Schema<command::History> {
    static constexpr const char* kName = "history";
    static constexpr const char* kMeaning =
        "Limits how much memory undo and redo may take. Where it is too little the oldest steps "
        "are dropped first, which is reported; the newest step and those that can be redone stay.";
    static constexpr std::tuple kFields{make_field(
        "megabytes", &command::History::megabytes, field::NumberOr{field::above(0.0)}.or_null(),
        "1000", "The limit in units of 10^6 bytes; null: no limit.")};
};

template <>
struct Schema<command::Readapt> {
    static constexpr const char* kName = "readapt";
    static constexpr const char* kMeaning =
        "Refines and decimates the whole object once by the present settings. Roughness that drags "
        "leave alone counts here.";
    static constexpr std::tuple<> kFields{};
};

template <>
struct Schema<command::Bake> {
    static constexpr const char* kName = "bake";
    static constexpr const char* kMeaning =
        "Makes the refined mesh the base mesh: what drags have inserted stays, whatever is "
        "decimated later.";
    static constexpr std::tuple<> kFields{};
};

template <>
struct Schema<command::Save> {
    static constexpr const char* kName = "save";
    static constexpr const char* kMeaning =
        "Writes the model, whole or not at all, and copies material files that are not there yet.";
    static constexpr std::tuple kFields{make_field(
        "path", &command::Save::path, field::Path{"an OBJ file"}, kRequired, "The file to write.")};
};

template <>
struct Schema<command::Stats> {
    static constexpr const char* kName = "stats";
    static constexpr const char* kMeaning =
        "Writes figures of the object, of what was found in its input and of the last edit.";
    static constexpr std::tuple kFields{
        make_field("path", &command::Stats::path, field::Path{"a JSON file"}, kRequired,
                   "The file to write, which may replace one but no file of another kind.")};
};

template <>
struct Schema<Camera> {
    static constexpr const char* kName = "camera";
    static constexpr const char* kMeaning = "Where the picture is taken from.";
    static constexpr std::tuple kFields{
        make_field("eye", &Camera::eye, field::Point{}, kRequired, "Where it is."),
        make_field("target", &Camera::target, field::Point{}, kRequired, "What it looks at."),
        make_field("up", &Camera::up, field::Point{}, "[0, 1, 0]",
                   "What is up in the picture, at an angle to the view."),
        make_field("fov", &Camera::fov,
                   field::Number{field::between(1.0, 170.0), field::Unit::angle}, "45",
                   "The field of view from the lower to the upper border."),
        make_field("projection", &Camera::projection,
                   field::Choice<2>{{"perspective", "orthographic"}}, "\"perspective\"",
                   "Orthographic: what is at any depth is as large as at the target.")};
};

template <>
struct Schema<command::Screenshot::Show> {
    static constexpr const char* kName = "picture";
    static constexpr const char* kMeaning = "What is drawn beside the surface, and behind it.";
    static constexpr std::tuple kFields{
        make_field("wireframe", &command::Screenshot::Show::wireframe, field::Flag{}, "false",
                   "the edges of the mesh."),
        make_field("lattice", &command::Screenshot::Show::lattice, field::Flag{}, "false",
                   "the cage, or the lattice of the last drag."),
        make_field("levels", &command::Screenshot::Show::levels, field::Flag{}, "false",
                   "how often the surface was refined, in colours."),
        make_field("light", &command::Screenshot::Show::light, field::Flag{}, "false",
                   "a light background, as in the light theme.")};
};

template <>
struct Schema<command::Screenshot> {
    static constexpr const char* kName = "screenshot";
    static constexpr const char* kMeaning = "Draws the object. It needs no display.";
    static constexpr std::tuple kFields{
        make_field("path", &command::Screenshot::path, field::Path{"a PNG file", ".png"}, kRequired,
                   "The file to write, which may replace one but no file of another kind."),
        make_field("size", &command::Screenshot::size, field::Counts{16, 8192}, "[1280, 960]",
                   "Width and height in pixels."),
        make_field("camera", &command::Screenshot::camera, field::ObjectOr{"fit"}, "\"fit\"",
                   "Where the picture is taken from; \"fit\": the whole object from the front."),
        make_field("show", &command::Screenshot::show, field::Names{}, "[]",
                   "What is drawn beside the surface, and behind it.")};
};

}  // namespace pectin
