// The stencil of a split: the vertices, edges and faces around one edge before and after.
//
//          a                    a
//         / \                  /|\.
//        / 1 \     split      /1|3\.
//       b-----c   ------->   b--m--c
//        \ 2 /    unsplit     \2|4/
//         \ /     <------      \|/
//          d                    d
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999, section 4 and figure 3.
#pragma once

#include <optional>

#include "mesh/ids.h"

namespace pectin {

// The result of splitting the edge bc. On a boundary, d, dm, face 4 and the right side do not
// exist. Along a cut this describes the sheet of the representative;
// TriMesh::for_each_sheet visits the others.
struct Split {
    VertexId m = kNone<VertexId>;
    VertexId a = kNone<VertexId>, b = kNone<VertexId>, c = kNone<VertexId>, d = kNone<VertexId>;
    EdgeId bm = kNone<EdgeId>, mc = kNone<EdgeId>;  // bm keeps the id of bc
    EdgeId am = kNone<EdgeId>, dm = kNone<EdgeId>;
    FaceId face3 = kNone<FaceId>, face4 = kNone<FaceId>;  // the new faces mca and cmd
    // The wedges on one side of the edge: the new one at m, whose attributes are computed from
    // those at the two ends.
    struct Side {
        WedgeId m = kNone<WedgeId>, b = kNone<WedgeId>, c = kNone<WedgeId>;
    };
    Side left;                  // the side of a
    std::optional<Side> right;  // the side of d; its m is left.m where the edge is smooth

    // Whether both sides share the wedges at both ends.
    bool is_smooth() const { return right && right->b == left.b && right->c == left.c; }
};

// The surroundings of an inserted vertex that unsplit() may remove. Along a cut they are those in
// one of the sheets, in which b-m-c is a boundary.
struct Star {
    VertexId m = kNone<VertexId>;
    VertexId a = kNone<VertexId>, b = kNone<VertexId>, c = kNone<VertexId>, d = kNone<VertexId>;
    HalfEdgeId mc = kNone<HalfEdgeId>;  // in face 3, mca
    HalfEdgeId bm = kNone<HalfEdgeId>;  // in face 1, bma
    HalfEdgeId mb = kNone<HalfEdgeId>;  // in face 2, mbd; none on a boundary
    HalfEdgeId cm = kNone<HalfEdgeId>;  // in face 4, cmd; none on a boundary
    bool on_boundary() const { return mb == kNone<HalfEdgeId>; }
};

}  // namespace pectin
