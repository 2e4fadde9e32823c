// What the `stats` command reports of the object and of the last edit.
#pragma once

#include <cstdint>
#include <vector>

namespace pectin {

struct Statistics {
    std::uint64_t vertices = 0, faces = 0;  // live
    std::uint64_t base_vertices = 0, base_faces = 0;
    int max_level = 0;

    struct Count {
        const char* name = "";
        std::uint64_t count = 0;
        bool operator==(const Count&) const = default;
    };
    std::vector<Count> input{};  // what was found in the input of the object

    struct Seconds {
        double begin = 0.0, solve = 0.0, deform = 0.0, refine = 0.0, decimate = 0.0, commit = 0.0;
    };
    struct Last {  // of the last drag, control or readapt
        std::uint64_t splits = 0, unsplits = 0;
        std::uint64_t influenced_vertices = 0;  // in the zone at its start
        std::uint64_t steps = 0;                // that the deformation was made of
        Seconds seconds;
    } last;

    double edge_max = 0.0;                 // longest edge
    double angle_min_deg = 0.0;            // smallest triangle angle
    double divergence_max_deg = 0.0;       // largest same-side normal divergence over edges
                                           // with a deformed end
    std::uint64_t needing_refinement = 0;  // edges that need it and may be split
    std::uint64_t held_back = 0;           // edges that need it but floor or budget forbid
    bool floor_hit = false, budget_hit = false;
    std::uint64_t folded_vertices = 0;  // det J <= 0 in any step of the last drag or control
    std::uint64_t memory_bytes = 0;
    std::uint64_t undo_steps = 0;  // that can be undone
    std::uint64_t undo_bytes = 0;  // of memory_bytes what undo and redo take
};

}  // namespace pectin
