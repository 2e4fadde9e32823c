#include "session/input_summary.h"

#include <array>
#include <cstdint>
#include <filesystem>

namespace pectin {
namespace {

// A count of the report; `one` and `many` tell it behind the number, where it is news.
struct Finding {
    const char* name;
    std::uint32_t BuildReport::*count;
    const char* one = nullptr;
    const char* many = nullptr;
};

// In the order in which they are told.
constexpr std::array kFindings{
    Finding{"triangulated_polygons", &BuildReport::triangulated_polygons},
    Finding{"crossing_polygons", &BuildReport::crossing_polygons,
            "polygon crosses itself, so that no triangles cover it exactly",
            "polygons cross themselves, so that no triangles cover them exactly"},
    Finding{"boundary_edges", &BuildReport::boundary_edges},
    Finding{"seams", &BuildReport::seams, "seam of unshared vertices is moved together",
            "seams of unshared vertices are moved together"},
    Finding{"seam_edges", &BuildReport::seam_edges},
    Finding{"nonmanifold_edges", &BuildReport::nonmanifold_edges,
            "edge cut where more than two faces meet", "edges cut where more than two faces meet"},
    Finding{"misoriented_edges", &BuildReport::misoriented_edges,
            "edge cut between faces that face opposite ways",
            "edges cut between faces that face opposite ways"},
    Finding{"nonmanifold_vertices", &BuildReport::nonmanifold_vertices,
            "vertex shared by several sheets", "vertices shared by several sheets"},
    Finding{"duplicate_faces", &BuildReport::duplicate_faces, "duplicate face", "duplicate faces"},
    Finding{"zero_area_faces", &BuildReport::zero_area_faces, "face without area kept",
            "faces without area kept"},
    Finding{"degenerate_polygons", &BuildReport::degenerate_polygons,
            "polygon of fewer than three different vertices kept unseen",
            "polygons of fewer than three different vertices kept unseen"},
    Finding{"repeated_corners", &BuildReport::repeated_corners,
            "polygon that names a vertex more than once",
            "polygons that name a vertex more than once"},
    Finding{"isolated_vertices", &BuildReport::isolated_vertices, "isolated vertex",
            "isolated vertices"},
    Finding{"lines", &BuildReport::lines, "line kept", "lines kept"},
    Finding{"points", &BuildReport::points, "group of points kept", "groups of points kept"},
};

static_assert(kFindings.size() * sizeof(std::uint32_t) == sizeof(BuildReport),
              "a count of the report is missing here");

}  // namespace

std::vector<Statistics::Count> input_counts(const BuildReport& report) {
    std::vector<Statistics::Count> counts;
    for (const Finding& finding : kFindings) {
        counts.push_back({finding.name, report.*finding.count});
    }
    return counts;
}

std::string input_summary(const std::string& path, const BuildReport& report) {
    std::string summary;
    for (const Finding& finding : kFindings) {
        const std::uint32_t count = report.*finding.count;
        if (count == 0 || !finding.one) continue;
        summary += summary.empty() ? std::filesystem::path(path).filename().string() + ": " : "; ";
        summary += std::to_string(count) + " " + (count == 1 ? finding.one : finding.many);
    }
    return summary;
}

}  // namespace pectin
