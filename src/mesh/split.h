// What a split of an edge makes, and what its inverse finds.
// Source: Gain & Dodgson 1999, section 4, figure 3.
#pragma once

#include <cstddef>
#include <optional>

#include "mesh/ids.h"

namespace pectin {

// What split(bc) made. On a boundary there is no d, no second side, no dm. Along a cut this is the
// sheet of the sibling with the lowest id; for_each_sheet tells of the others.
struct Split {
    VertexId m = kNone<VertexId>;
    VertexId a = kNone<VertexId>, b = kNone<VertexId>, c = kNone<VertexId>, d = kNone<VertexId>;
    EdgeId bm = kNone<EdgeId>, mc = kNone<EdgeId>;  // bm is the id that bc had
    EdgeId am = kNone<EdgeId>, dm = kNone<EdgeId>;
    FaceId face3 = kNone<FaceId>, face4 = kNone<FaceId>;  // mca and cmd, the new ones
    // Corners of the two sides: at m, and at the two ends whose attributes m's are made from.
    struct Side {
        WedgeId m = kNone<WedgeId>, b = kNone<WedgeId>, c = kNone<WedgeId>;
    };
    Side left;                  // the side of a
    std::optional<Side> right;  // the side of d; its m is left.m where the edge is smooth

    // Whether its sides share the corners at both ends.
    bool is_smooth() const { return right && right->b == left.b && right->c == left.c; }
};

// What a split of a smooth edge takes, in the order that it takes them.
struct SplitIds {
    VertexId m = kNone<VertexId>;
    WedgeId wedge = kNone<WedgeId>;
    EdgeId mc = kNone<EdgeId>, am = kNone<EdgeId>, dm = kNone<EdgeId>;
    FaceId face3 = kNone<FaceId>, face4 = kNone<FaceId>;
};

// Places in the lists of what is free, for what several such splits took and now give back: those
// of the first split.
struct FreedSlots {
    std::size_t vertex = 0, wedge = 0, edge = 0, face = 0;
};

// The surroundings of an inserted vertex that unsplit may remove (figure 3, after the split); along
// a cut those in one of the sheets, whose boundary b-m-c is.
struct Star {
    VertexId m = kNone<VertexId>;
    VertexId a = kNone<VertexId>, b = kNone<VertexId>, c = kNone<VertexId>, d = kNone<VertexId>;
    HalfEdgeId mc = kNone<HalfEdgeId>;  // in face mca
    HalfEdgeId bm = kNone<HalfEdgeId>;  // in face bma
    HalfEdgeId mb = kNone<HalfEdgeId>;  // in face mbd, none on a boundary
    HalfEdgeId cm = kNone<HalfEdgeId>;  // in face cmd, none on a boundary
    bool on_boundary() const { return mb == kNone<HalfEdgeId>; }
};

}  // namespace pectin
