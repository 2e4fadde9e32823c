// Lines and points that are drawn over the object: the lattice, drags, pins and others.
//
// Those behind the object are drawn faintly. Positions are in world space, widths and diameters in
// pixels (multiplied by Scene::pixel_scale).
//
// J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation. Eurographics
// UK 1999.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ffd/lattice.h"
#include "ffd/symmetry.h"
#include "geometry/vec.h"

namespace pectin {

// Channels from 0 to 255, as on screen.
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

// The grabbed point of a drag (ring), its target (disc) and the line between them.
// is_faint: for the mirror image of a drag.
void add_drag(Overlay& overlay, const Vec3& from, const Vec3& to, bool is_faint = false);
void add_pin(Overlay& overlay, const Vec3& position, bool is_faint = false);
// A control point that is selected, under the cursor (hovered), or both.
void add_control_point(Overlay& overlay, const Vec3& position, bool is_selected, bool is_hovered);

// A grid where the plane intersects the box. The colour is that of the plane's axis: red for x,
// green for y, blue for z.
void add_mirror_plane(Overlay& overlay, const MirrorPlane& plane, const Box& box);

// The zones of a lattice (Gain & Dodgson 1999, figure 2): the displaced deformable control points
// and the grid between them, the box of the influenced zone with the grid on its faces, and the
// control points of the phantom layer around it. Of a lattice with margins only the first is drawn,
// and the margins fainter and smaller.
// displacements: one per control point in the order of control_index(); empty: all zero.
void add_lattice(Overlay& overlay, const Lattice& lattice, std::span<const Vec3> displacements);
// Whether add_lattice() draws this control point. In large lattices only boundary points are drawn.
bool draws_control(const Lattice& lattice, const IVec3& control);

}  // namespace pectin
