// Tests that nothing is lost if memory runs out during refinement or decimation. In a long run
// every allocation fails in turn, otherwise a sample of them (see FailurePoints). The limit of the
// address space grows in steps of 5 MB.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <new>
#include <string>
#include <variant>
#include <vector>

#include "adapt/adapt.h"
#include "embedding/embedding.h"
#include "ffd/drag_solver.h"
#include "geometry/parallel.h"
#include "memory/failing_new.h"
#include "mesh/build_mesh.h"
#include "mesh/face_tree.h"
#include "mesh/shapes.h"
#include "support/test_run.h"

namespace pectin {
namespace {

// Limits the address space of the process to what it uses now and `bytes` more, for the lifetime of
// the object.
class Shortage {
  public:
    explicit Shortage(std::size_t bytes) {
        std::ifstream statm("/proc/self/statm");
        std::size_t pages = 0;
        statm >> pages;
        getrlimit(RLIMIT_AS, &before_);
        rlimit now = before_;
        now.rlim_cur = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + bytes;
        setrlimit(RLIMIT_AS, &now);
    }
    Shortage(const Shortage&) = delete;
    Shortage& operator=(const Shortage&) = delete;
    ~Shortage() { setrlimit(RLIMIT_AS, &before_); }

  private:
    rlimit before_{};
};

using test::FailingNew;
using test::FailurePoints;

// A mesh in a warp of two steps. The whole mesh is active.
class Refined {
  public:
    explicit Refined(const TriMesh& mesh) : mesh_(mesh), active_(mesh_) {
        const Vec3 pole{0, 0, 1};
        const auto solver =
            std::get<DragSolver>(DragSolver::create(brush_lattice(pole, 4.0, 3), {&pole, 1}, {}));
        for (double far : {0.2, 0.3}) {
            warp_.steps.push_back(DragStep{solver.field(), {Vec3{0, 0, far}}});
        }
        zone_ = warp_.zone();
        active_.begin(FaceTree(mesh_).faces_meeting(zone_, mesh_), zone_);
        embedding_ = std::make_unique<Embedding>(active_, warp_);
        embedding_->embed();
        embedding_->deform();
    }

    void refine(double l_max) {
        pectin::refine(active_, *embedding_, criteria({.l_max = l_max, .floor = 1e-6}));
    }
    void decimate(double l_max) { pectin::decimate(active_, criteria({.l_max = l_max})); }
    void roll_back() { active_.roll_back(); }
    const TriMesh& mesh() const { return mesh_; }

  private:
    Criteria criteria(const AdaptLimits& limits) const { return {limits, zone_, zone_}; }

    TriMesh mesh_;
    ActiveSet active_;
    Warp warp_;
    Box zone_;
    std::unique_ptr<Embedding> embedding_;
};

// Splits and removes many elements at a time, on all threads. Returns false if memory has run out.
bool adapt(Refined& refined) try {
    refined.refine(0.025);
    refined.decimate(0.06);
    refined.refine(0.02);
    return true;
} catch (const std::bad_alloc&) {
    return false;
}

TriMesh sphere() { return build_mesh(make_shape(ShapeKind::sphere, 4)).mesh; }

TEST(AdaptMemory, RollsBackWhicheverAllocationFails) {
    const TriMesh mesh = sphere();
    prepare_parallel_loops();  // TBB does not survive a lack of memory when it starts
    for (const FailingNew::How how : {FailingNew::How::once, FailingNew::How::from_there_on}) {
        int shortages = 0;
        bool is_enough = false;
        for (FailurePoints points(16); !is_enough; points.advance()) {
            SCOPED_TRACE("served " + std::to_string(points.served()));
            Refined refined(mesh);
            {
                const FailingNew failing(points.served(), how);
                const bool all_done = adapt(refined);
                is_enough = !failing.has_failed();
                if (is_enough) {
                    EXPECT_TRUE(all_done);
                }
            }
            shortages += is_enough ? 0 : 1;
            EXPECT_EQ(refined.mesh().validate(), std::vector<std::string>{});
            refined.roll_back();
            ASSERT_TRUE(refined.mesh() == mesh);
        }
        EXPECT_GT(shortages, 40);
    }
}

// Ends the process. Its exit status is 0 if every roll back has restored the mesh, however early
// memory ran out.
[[noreturn]] void adapt_short_of_memory(const TriMesh& mesh) {
    Refined warm(mesh);  // starts the threads
    bool is_enough = !adapt(warm);
    int shortages = 0;
    for (std::size_t megabytes = 0; !is_enough; megabytes += 5) {
        Refined refined(mesh);
        {
            const Shortage shortage(megabytes << 20);
            is_enough = adapt(refined);
        }
        shortages += is_enough ? 0 : 1;
        refined.roll_back();
        if (!(refined.mesh() == mesh)) {
            std::fprintf(stderr, "another mesh after %zu MB", megabytes);
            std::_Exit(1);
        }
    }
    std::fprintf(stderr, "short %d times", shortages);
    std::_Exit(shortages > 5 ? 0 : 1);
}

// The limit also applies to the pages of large arrays.
TEST(AdaptMemoryDeathTest, RollsBackWhereverThePagesRunOut) {
    if (test::is_sanitized()) {
        GTEST_SKIP() << "a sanitizer's allocator ends the program instead";
    }
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const TriMesh mesh = sphere();
    EXPECT_EXIT(adapt_short_of_memory(mesh), testing::ExitedWithCode(0), "short");
}

}  // namespace
}  // namespace pectin
