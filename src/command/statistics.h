// What the `stats` command reports about the object and the last edit.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace pectin {

struct Statistics {
    std::uint64_t vertices = 0, faces = 0;  // live ones
    std::uint64_t base_vertices = 0, base_faces = 0;
    int max_level = 0;

    struct Count {
        const char* name = "";
        std::uint64_t count = 0;
        bool operator==(const Count&) const = default;
    };
    std::vector<Count> input{};  // counts of what the input file contained

    struct Seconds {
        double begin = 0.0, solve = 0.0, deform = 0.0, refine = 0.0, decimate = 0.0, commit = 0.0;
    };
    struct Last {  // about the last drag, control or readapt
        std::uint64_t splits = 0, unsplits = 0;
        std::uint64_t influenced_vertices = 0;  // at its start
        std::uint64_t steps = 0;                // number of steps of the deformation
        Seconds seconds;
    } last;

    // Upper bounds of the distance between the mesh and the exact surface, to which all drags
    // together would take the flat faces of the object as it was opened. None where it is not
    // known, since a drag was adapted by another trigger than certified.
    struct Error {
        std::optional<double> last;   // what the last drag, control or readapt has added
        std::optional<double> total;  // since the object was opened
        bool operator==(const Error&) const = default;
    } error{};

    double edge_max = 0.0;            // longest edge
    double angle_min_deg = 0.0;       // smallest triangle angle
    double divergence_max_deg = 0.0;  // largest divergence of same-side end normals
                                      // over edges with a deformed end
    // Edges that the last edit left: that need refinement and may be split, and that need it but
    // are kept by floor or budget.
    std::uint64_t needing_refinement = 0, held_back = 0;
    bool floor_hit = false, budget_hit = false, drag_budget_hit = false;
    std::uint64_t folded_vertices = 0;  // those with det J <= 0 in any step of the last drag or
                                        // control
    std::uint64_t memory_bytes = 0;
    std::uint64_t undo_steps = 0;  // that can be undone
    std::uint64_t undo_bytes = 0;  // the part of memory_bytes that undo and redo take
};

}  // namespace pectin
