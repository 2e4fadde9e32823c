// Lines and points drawn over the object: the lattice, drags, pins, and what a host adds.
//
// Those behind the object show faintly through it. Positions are in world space, widths and
// diameters in pixels (times Scene::pixel_scale).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ffd/lattice.h"
#include "ffd/symmetry.h"
#include "geometry/vec.h"

namespace pectin {

// As on screen, 0 to 255.
struct Colour {
    std::uint8_t red = 255, green = 255, blue = 255, alpha = 255;
    bool operator==(const Colour&) const = default;
};

struct Overlay {
    struct Line {
        Vec3 from{0.0}, to{0.0};
        Colour colour{};
        float width = 1.0f;
    };
    struct Point {
        enum class Shape : std::uint8_t { disc, ring, diamond };
        Vec3 position{0.0};
        Colour colour{};
        float diameter = 6.0f;
        Shape shape = Shape::disc;
    };
    std::vector<Line> lines{};
    std::vector<Point> points{};

    bool is_empty() const { return lines.empty() && points.empty(); }
    Box bounds() const;
};

// A drag's grabbed point (ring), where it is to go (disc), and the way between. Faint: its image.
void add_drag(Overlay& overlay, const Vec3& from, const Vec3& to, bool is_faint = false);
void add_pin(Overlay& overlay, const Vec3& position, bool is_faint = false);
// A control point that is under the cursor, selected, or both.
void add_control_point(Overlay& overlay, const Vec3& position, bool is_selected, bool is_hovered);

// A grid where the plane cuts the box, in the colour of its axis: red for x, green for y, blue for
// z.
void add_mirror_plane(Overlay& overlay, const MirrorPlane& plane, const Box& box);

// The zones of a lattice, told apart (Gain & Dodgson 1999, figure 2): the deformable control points
// and the grid between them, where they have been moved to; the box of the influenced zone with the
// grid on its faces; the phantom layer as points about it.
// displacements: control_count in the order of control_index, or empty: at rest.
void add_lattice(Overlay& overlay, const Lattice& lattice, std::span<const Vec3> displacements);
// Whether add_lattice draws this control point: of large lattices only those on the border.
bool draws_control(const Lattice& lattice, const IVec3& control);

}  // namespace pectin
