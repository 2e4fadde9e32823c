#include "render/overlay.h"

#include <array>
#include <cassert>

namespace pectin {
namespace {

constexpr Colour kDragged{255, 214, 64, 255};
constexpr Colour kPinned{255, 92, 92, 255};
constexpr Colour kSelected{255, 172, 48, 255};
constexpr Colour kHovered{255, 255, 255, 235};
constexpr std::array kAxes{Colour{255, 120, 120, 92}, Colour{130, 235, 120, 92},
                           Colour{120, 165, 255, 92}};
constexpr int kMirrorGrid = 6;  // squares per side

constexpr Colour kDeformable{70, 220, 255, 235};
constexpr Colour kDeformableMoved{255, 244, 150, 255};
// Of the layers of a cage beyond the object's box, and what is drawn with them.
constexpr Colour kMargin{70, 220, 255, 120}, kMarginGrid{70, 220, 255, 34};
constexpr Colour kInfluenced{150, 170, 255, 170};
constexpr Colour kInfluencedGrid{150, 170, 255, 48};
constexpr Colour kPhantom{190, 196, 206, 110};

// The interior of the grid is drawn up to this many control points per axis.
constexpr int kInnerGrid = 5;

Colour faint(Colour colour) {
    colour.alpha = static_cast<std::uint8_t>(colour.alpha * 2 / 5);
    return colour;
}

// A range of control points from `first` to `last`, inclusive.
struct ControlRange {
    IVec3 first, last;

    int border_axes(const IVec3& c) const {
        int axes = 0;
        for (int axis = 0; axis < 3; ++axis)
            axes += c[axis] == first[axis] || c[axis] == last[axis];
        return axes;
    }
    template <class Visit>
    void for_each(const Visit& visit) const {
        for (int k = first.z; k <= last.z; ++k)
            for (int j = first.y; j <= last.y; ++j)
                for (int i = first.x; i <= last.x; ++i) visit(IVec3{i, j, k});
    }
};

int max_component(const IVec3& counts) { return glm::max(counts.x, glm::max(counts.y, counts.z)); }

IVec3 unit_step(int axis) {
    IVec3 step{0};
    step[axis] = 1;
    return step;
}

// Whether the control point lies beyond the points that the user has asked for.
bool is_in_margin(const Lattice& lattice, const IVec3& control) {
    const IVec3 first = lattice.margin, last = lattice.margin + lattice.counts() - 1;
    return glm::any(glm::lessThan(control, first)) || glm::any(glm::greaterThan(control, last));
}

void add_deformable(Overlay& overlay, const Lattice& lattice, std::span<const Vec3> displacements) {
    const ControlRange range{IVec3{0}, lattice.deformable - 1};
    const int most = max_component(lattice.deformable);
    // Denser grids have thinner lines, so that they do not hide the object.
    const float fine = most <= kInnerGrid ? 1.0f : glm::max(0.4f, 6.0f / static_cast<float>(most));
    const double threshold = 1e-6 * lattice.smallest_cell_extent();
    const auto displacement = [&](const IVec3& c) {
        return displacements.empty() ? Vec3{0.0} : displacements[lattice.control_index(c)];
    };
    const auto position = [&](const IVec3& c) { return lattice.rest(c) + displacement(c); };
    range.for_each([&](const IVec3& c) {
        if (!draws_control(lattice, c)) return;
        const bool moved = glm::length(displacement(c)) > threshold;
        const bool in_margin = is_in_margin(lattice, c);
        const float diameter = moved ? 7.0f : in_margin ? 3.5f : 6.0f;
        overlay.points.push_back({.position = position(c),
                                  .colour = moved       ? kDeformableMoved
                                            : in_margin ? kMargin
                                                        : kDeformable,
                                  .diameter = diameter * fine});
        for (int axis = 0; axis < 3; ++axis) {
            const IVec3 next = c + unit_step(axis);
            if (next[axis] > range.last[axis] || !draws_control(lattice, next)) continue;
            const bool reaches_margin = in_margin || is_in_margin(lattice, next);
            overlay.lines.push_back({position(c), position(next),
                                     reaches_margin ? kMarginGrid : kDeformable,
                                     (reaches_margin ? 1.0f : 1.6f) * fine});
        }
    });
}

// Draws the grid lines along each axis on the boundary of the range, with stronger box edges.
void add_influenced(Overlay& overlay, const Lattice& lattice) {
    const ControlRange range{IVec3{-2}, lattice.deformable + 1};
    range.for_each([&](const IVec3& c) {
        for (int axis = 0; axis < 3; ++axis) {
            if (c[axis] != range.first[axis]) continue;
            const int others = range.border_axes(c) - 1;
            if (others == 0) continue;
            IVec3 end = c;
            end[axis] = range.last[axis];
            const bool is_edge = others == 2;
            overlay.lines.push_back({lattice.rest(c), lattice.rest(end),
                                     is_edge ? kInfluenced : kInfluencedGrid,
                                     is_edge ? 1.4f : 1.0f});
        }
    });
}

// Draws only the control points on the edges of their box; all of them would hide the object.
void add_phantom(Overlay& overlay, const Lattice& lattice) {
    const ControlRange range{IVec3{-3}, lattice.deformable + 2};
    range.for_each([&](const IVec3& c) {
        if (range.border_axes(c) < 2) return;
        overlay.points.push_back({.position = lattice.rest(c),
                                  .colour = kPhantom,
                                  .diameter = range.border_axes(c) == 3 ? 4.5f : 3.0f});
    });
}

}  // namespace

Box Overlay::bounds() const {
    Box box;
    for (const Line& line : lines) {
        box.include(line.from);
        box.include(line.to);
    }
    for (const Point& point : points) box.include(point.position);
    return box;
}

void add_drag(Overlay& overlay, const Vec3& from, const Vec3& to, bool is_faint) {
    using Shape = Overlay::Point::Shape;
    const Colour colour = is_faint ? faint(kDragged) : kDragged;
    overlay.lines.push_back({from, to, colour, 2.0f});
    overlay.points.push_back({from, colour, 12.0f, Shape::ring});
    overlay.points.push_back({to, colour, 12.0f, Shape::disc});
}

void add_pin(Overlay& overlay, const Vec3& position, bool is_faint) {
    overlay.points.push_back(
        {position, is_faint ? faint(kPinned) : kPinned, 14.0f, Overlay::Point::Shape::diamond});
}

void add_control_point(Overlay& overlay, const Vec3& position, bool is_selected, bool is_hovered) {
    using Shape = Overlay::Point::Shape;
    if (is_selected) overlay.points.push_back({position, kSelected, 11.0f, Shape::disc});
    if (is_hovered) overlay.points.push_back({position, kHovered, 18.0f, Shape::ring});
}

void add_mirror_plane(Overlay& overlay, const MirrorPlane& plane, const Box& box) {
    const int u = (plane.axis + 1) % 3, v = (plane.axis + 2) % 3;
    const Colour& colour = kAxes[static_cast<std::size_t>(plane.axis)];
    const auto point = [&](double s, double t) {
        Vec3 p = box.min;
        p[u] += s * (box.max[u] - box.min[u]);
        p[v] += t * (box.max[v] - box.min[v]);
        return plane.onto(p);
    };
    for (int i = 0; i <= kMirrorGrid; ++i) {
        const double s = static_cast<double>(i) / kMirrorGrid;
        const bool is_edge = i == 0 || i == kMirrorGrid;
        const Colour shade = is_edge ? colour : faint(colour);
        const float width = is_edge ? 1.4f : 1.0f;
        overlay.lines.push_back({point(s, 0.0), point(s, 1.0), shade, width});
        overlay.lines.push_back({point(0.0, s), point(1.0, s), shade, width});
    }
}

void add_lattice(Overlay& overlay, const Lattice& lattice, std::span<const Vec3> displacements) {
    assert(displacements.empty() || displacements.size() == lattice.control_count());
    // A cage with margins reaches so far beyond the object that its zones would only hide things.
    if (lattice.margin == IVec3{0}) {
        add_phantom(overlay, lattice);
        add_influenced(overlay, lattice);
    }
    add_deformable(overlay, lattice, displacements);
}

bool draws_control(const Lattice& lattice, const IVec3& control) {
    if (max_component(lattice.counts()) <= kInnerGrid) return true;
    for (int axis = 0; axis < 3; ++axis) {
        const int first = lattice.margin[axis], last = first + lattice.counts()[axis] - 1;
        if (control[axis] <= first || control[axis] >= last) return true;
    }
    return false;
}

}  // namespace pectin
