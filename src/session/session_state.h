// What a Session holds, shared by the files that implement it.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ffd/drag_solver.h"
#include "session/gesture.h"
#include "session/history.h"
#include "session/model_file.h"
#include "session/session.h"
#include "session/settings.h"

namespace pectin {

using Refusal = std::optional<std::string>;

inline constexpr const char* kNoObject =
    "there is no object yet; use the open or shape command first";

class Stopwatch {
  public:
    // Seconds since the last lap.
    double lap() {
        const auto now = Clock::now();
        const std::chrono::duration<double> passed = now - last_;
        last_ = now;
        return passed.count();
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
};

struct Session::State {
    // A drag between begin and end.
    struct DragInHand {
        command::Drag drag;  // `to` is where the last frame put it
        Lattice lattice;
        DragSolver solver;
        Statistics::Last measured;           // so far
        std::unique_ptr<Gesture> gesture{};  // refers to the active set

        std::vector<Vec3> displacements() const;
    };

    // Behind pointers: the active set refers to the mesh wherever the session goes.
    std::unique_ptr<TriMesh> mesh = std::make_unique<TriMesh>();
    std::unique_ptr<ActiveSet> active = std::make_unique<ActiveSet>(*mesh);
    std::unique_ptr<FaceTree> tree;  // made when first asked for
    std::unique_ptr<DragInHand> in_hand;
    History history;
    AdaptSettings adapt_settings;
    LatticeSettings lattice_settings;
    DirtyElements dirty;
    Viewport* viewport = nullptr;
    double diagonal = 0.0;                  // of the object's box as it was opened
    std::optional<Lattice> lattice_in_use;  // the last drag's
    Statistics::Last last;
    std::uint64_t folded = 0;
    AdaptOutcome outcome;                       // of the mesh as it is
    BuildReport input_report;                   // what opening the object took
    double largest_coordinate = 0.0;            // of the object as it was opened
    std::vector<std::string> material_folders;  // as LoadedModel has them

    bool has_object() const { return mesh->face_slots() > 0; }
    AdaptLimits limits(const std::optional<Lattice>& lattice) const {
        return adapt_settings.limits(lattice ? lattice->smallest_cell_extent() : kOff, diagonal,
                                     largest_coordinate);
    }
    std::optional<Box> zone_in_use() const {
        if (!lattice_in_use) return std::nullopt;
        return lattice_in_use->influenced_zone();
    }
    void adopt(LoadedModel model);
    void note_saved(const std::string& path);
    const FaceTree& face_tree();
    void note(const Frame& frame);
    void add_step(Command command, MeshChange change);
    // The picture has to learn these faces and their corners anew.
    void show(std::span<const FaceId> faces);
    // The same, and the tree has to follow.
    void follow(std::span<const FaceId> faces);
    void restore_outcome();
    // Of a bake's step: the mesh on its one side for that on its other.
    void exchange(TriMesh& other);

    // --- One for each command.
    Refusal run(const command::Open& open);
    Refusal run(const command::Shape& shape);
    Refusal run(const command::Adapt& adapt);
    Refusal run(const command::Brush& brush);
    Refusal run(const command::Cage& cage);
    Refusal run(const command::Drag& drag);
    Refusal run(const command::Undo& undo);
    Refusal run(const command::Redo& redo);
    Refusal run(const command::Readapt& readapt);
    Refusal run(const command::Bake& bake);
    Refusal run(const command::Save& save);
    Refusal run(const command::Stats& stats);
    Refusal run(const command::Screenshot& screenshot);

    // --- Drags (drag.cpp).
    Refusal begin_drag(std::span<const Vec3> points, std::span<const Vec3> pins);
    Refusal set_targets(std::span<const Vec3> targets);
    Refusal drag_to(std::span<const Vec3> targets);
    std::optional<command::Drag> end_drag();
    void cancel_drag();

    Statistics statistics() const;
};

}  // namespace pectin
