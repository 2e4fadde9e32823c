// Tests how much is uploaded, and that an updated mesh gives the same picture as a new one.
#include "render/gpu_mesh.h"

#include <gtest/gtest.h>

#include "mesh/build_mesh.h"
#include "mesh/shapes.h"
#include "support/offscreen.h"

namespace pectin {
namespace {

constexpr IVec2 kSize{160, 120};

TriMesh sphere(int resolution) {
    return build_mesh(make_shape(ShapeKind::sphere, resolution)).mesh;
}

std::size_t whole_size(const TriMesh& mesh) {
    return mesh.wedge_slots() * sizeof(GpuVertex) + mesh.face_slots() * sizeof(GpuTriangle);
}

class GpuMeshTest : public OffscreenTest {
  protected:
    void expect_same_picture(const GpuMesh& mesh, const TriMesh& truth) {
        const Scene scene{
            .camera = fit(truth.bounding_box(), 4.0 / 3.0), .wireframe = true, .levels = true};
        GpuMesh fresh(gl());
        fresh.upload(truth, mesh.centre());
        EXPECT_EQ(draw(gl(), mesh, scene, kSize).rgba, draw(gl(), fresh, scene, kSize).rgba);
    }
};

TEST_F(GpuMeshTest, UploadsEveryWedgeAndFaceOnce) {
    const TriMesh mesh = sphere(3);
    GpuMesh gpu_mesh(gl());
    EXPECT_EQ(gpu_mesh.upload(mesh).bytes, whole_size(mesh));
    EXPECT_EQ(gpu_mesh.face_slots(), mesh.face_slots());
    EXPECT_TRUE(gpu_mesh.bounds().contains(Box{.min = Vec3(-0.99), .max = Vec3(0.99)}));
}

TEST_F(GpuMeshTest, JoinsRangesOnlyOverSmallGaps) {
    const TriMesh mesh = sphere(4);
    GpuMesh gpu_mesh(gl());
    gpu_mesh.upload(mesh);
    std::vector<WedgeId> wedges;
    for (std::uint32_t i = 0; i < 100; ++i) wedges.push_back(WedgeId{3 * i});
    const GpuMesh::Upload near = gpu_mesh.update(mesh, wedges, {});
    EXPECT_EQ(near.ranges, 1u);
    EXPECT_EQ(near.bytes, 298 * sizeof(GpuVertex));
    wedges = {WedgeId{2000}, WedgeId{3}, WedgeId{4}, WedgeId{3}};
    const GpuMesh::Upload far = gpu_mesh.update(mesh, wedges, {});
    EXPECT_EQ(far.ranges, 2u);
    EXPECT_EQ(far.bytes, 3 * sizeof(GpuVertex));
    EXPECT_EQ(gpu_mesh.update(mesh, {}, {}).bytes, 0u);
}

// The upload for one split does not depend on the size of the mesh, although buffers must grow.
TEST_F(GpuMeshTest, UploadsForASplitIndependentlyOfTheSizeOfTheMesh) {
    std::size_t bytes[2] = {};
    for (const int i : {0, 1}) {
        TriMesh mesh = sphere(i == 0 ? 3 : 6);
        GpuMesh gpu_mesh(gl());
        gpu_mesh.upload(mesh);
        const EdgeId bc{7};
        const HalfEdgeId h = mesh.half_edge(bc);
        const FaceId face1 = TriMesh::face(h), face2 = TriMesh::face(mesh.twin(h));
        const Split split = mesh.split(bc);
        bytes[i] = gpu_mesh
                       .update(mesh, std::vector{split.left.m},
                               std::vector{face1, face2, split.face3, split.face4})
                       .bytes;
        EXPECT_LT(bytes[i], 5000u);
        expect_same_picture(gpu_mesh, mesh);
    }
    // On the larger mesh there may be two more triangles between face1 and face2.
    EXPECT_NEAR(static_cast<double>(bytes[0]), static_cast<double>(bytes[1]), 1100.0);
}

TEST_F(GpuMeshTest, IsUpdatedByEveryFrameOfADrag) {
    Session session;
    execute(session,
            {R"({"cmd": "shape", "kind": "sphere", "resolution": 4})",
             R"({"cmd": "adapt", "theta_max": 12})", R"({"cmd": "brush", "radius": 0.6})"});
    GpuMesh gpu_mesh(gl());
    gpu_mesh.upload(session.mesh());
    session.take_dirty();
    ASSERT_TRUE(session.begin_drag(std::vector{Vec3(0, 0, 1)}, {}));
    for (int frame = 1; frame <= 5; ++frame) {
        const double reach = frame < 4 ? 0.1 * frame : 0.5 - 0.08 * frame;  // forth and back
        ASSERT_TRUE(session.drag_to(std::vector{Vec3(0.05, 0, 1.0 + reach)}));
        const DirtyElements dirty = session.take_dirty();
        ASSERT_FALSE(dirty.everything);
        const auto upload = gpu_mesh.update(session.mesh(), dirty.wedges, dirty.faces);
        EXPECT_GT(upload.bytes, 0u);
        EXPECT_LT(upload.bytes, whole_size(session.mesh()));
        expect_same_picture(gpu_mesh, session.mesh());
    }
    const auto expect_same_after_update = [&] {
        const DirtyElements dirty = session.take_dirty();
        if (dirty.everything) {
            gpu_mesh.upload(session.mesh());
        } else {
            gpu_mesh.update(session.mesh(), dirty.wedges, dirty.faces);
        }
        expect_same_picture(gpu_mesh, session.mesh());
    };
    session.end_drag();
    expect_same_after_update();
    execute(session, {R"({"cmd": "undo"})"});
    expect_same_after_update();
}

TEST_F(GpuMeshTest, UploadsPerFrameIndependentlyOfTheSizeOfTheMesh) {
    double bytes[2] = {};
    for (const int i : {0, 1}) {
        Session session;
        // Four times as many triangles and half the brush radius, so that the brush has as many
        // faces.
        execute(session, {R"({"cmd": "shape", "kind": "sphere", "resolution": )" +
                              std::to_string(5 + i) + "}",
                          R"({"cmd": "adapt", "enabled": false})",
                          R"({"cmd": "brush", "radius": )" + std::to_string(i ? 0.15 : 0.3) + "}"});
        GpuMesh gpu_mesh(gl());
        gpu_mesh.upload(session.mesh());
        session.take_dirty();
        ASSERT_TRUE(session.begin_drag(std::vector{Vec3(0, 0, 1)}, {}));
        ASSERT_TRUE(session.drag_to(std::vector{Vec3(0, 0, 1.02)}));
        const DirtyElements dirty = session.take_dirty();
        bytes[i] =
            static_cast<double>(gpu_mesh.update(session.mesh(), dirty.wedges, dirty.faces).bytes);
        EXPECT_LT(bytes[i], 0.2 * static_cast<double>(whole_size(session.mesh())));
    }
    EXPECT_LT(bytes[1], 1.5 * bytes[0]);
}

TEST_F(GpuMeshTest, FreesItsBuffers) {
    GrowingBuffer kept(gl(), 4);
    kept.reserve(10);
    GLuint name = 0;
    {
        GrowingBuffer buffer(gl(), 4);
        buffer.reserve(10);
        name = buffer.name();
        EXPECT_TRUE(gl().IsBuffer(name));
        buffer.reserve(100);  // replaces the first buffer
        EXPECT_FALSE(gl().IsBuffer(name));
        name = buffer.name();
        kept = std::move(buffer);
    }
    EXPECT_EQ(kept.name(), name);
    EXPECT_TRUE(gl().IsBuffer(name));
}

}  // namespace
}  // namespace pectin
