#include "session/input_summary.h"

#include <array>
#include <cstdint>
#include <filesystem>

#include "io/printable.h"

namespace pectin {
namespace {

// Whether a finding has changed how the object is made, or is only worth knowing.
enum class Kind { repair, kept };

// A count of the report. `one` and `many` are the words after the number; null if it is not
// reported.
struct Finding {
    const char* name;
    std::uint32_t BuildReport::*count;
    const char* one = nullptr;
    const char* many = nullptr;
    Kind kind = Kind::repair;
};

// In the order in which they are reported.
constexpr std::array kFindings{
    Finding{"triangulated_polygons", &BuildReport::triangulated_polygons},
    Finding{"crossing_polygons", &BuildReport::crossing_polygons,
            "polygon triangulated roughly (it crosses itself or is far from flat)",
            "polygons triangulated roughly (they cross themselves or are far from flat)"},
    Finding{"boundary_edges", &BuildReport::boundary_edges},
    Finding{"seams", &BuildReport::seams, "seam of unshared vertices moved together",
            "seams of unshared vertices moved together"},
    Finding{"seam_edges", &BuildReport::seam_edges},
    Finding{"nonmanifold_edges", &BuildReport::nonmanifold_edges, "non-manifold edge split",
            "non-manifold edges split"},
    Finding{"misoriented_edges", &BuildReport::misoriented_edges,
            "edge between opposite faces split", "edges between opposite faces split"},
    Finding{"nonmanifold_vertices", &BuildReport::nonmanifold_vertices, "shared vertex",
            "shared vertices"},
    Finding{"duplicate_faces", &BuildReport::duplicate_faces, "duplicate face kept",
            "duplicate faces kept", Kind::kept},
    Finding{"zero_area_faces", &BuildReport::zero_area_faces, "face without area kept",
            "faces without area kept", Kind::kept},
    Finding{"degenerate_polygons", &BuildReport::degenerate_polygons,
            "polygon of fewer than three different vertices kept unseen",
            "polygons of fewer than three different vertices kept unseen", Kind::kept},
    Finding{"repeated_corners", &BuildReport::repeated_corners,
            "polygon that names a vertex more than once kept",
            "polygons that name a vertex more than once kept", Kind::kept},
    Finding{"isolated_vertices", &BuildReport::isolated_vertices, "unused vertex kept",
            "unused vertices kept", Kind::kept},
    Finding{"lines", &BuildReport::lines, "line kept", "lines kept", Kind::kept},
    Finding{"points", &BuildReport::points, "group of points kept", "groups of points kept",
            Kind::kept},
};

static_assert(kFindings.size() * sizeof(std::uint32_t) == sizeof(BuildReport),
              "a count of the report is missing here");

// The same for what the reader has dropped.
struct Dropped {
    const char* name;
    ReadFinding ReadReport::*found;
    const char* one;
    const char* many;
};

constexpr std::array kDropped{
    Dropped{"missing_uvs", &ReadReport::missing_uvs,
            "corner names a texture coordinate that the file does not have and gets none",
            "corners name texture coordinates that the file does not have and get none"},
    Dropped{"missing_normals", &ReadReport::missing_normals,
            "corner names a normal that the file does not have and gets one from its faces",
            "corners name normals that the file does not have and get them from their faces"},
    Dropped{"undefined_uvs", &ReadReport::undefined_uvs,
            "corner has a texture coordinate that is no number and gets none",
            "corners have texture coordinates that are no numbers and get none"},
    Dropped{"undefined_normals", &ReadReport::undefined_normals,
            "corner has a normal that is zero or no number and gets one from its faces",
            "corners have normals that are zero or no numbers and get them from their faces"},
    Dropped{"undefined_colors", &ReadReport::undefined_colors,
            "vertex has a colour that is no number and gets none",
            "vertices have colours that are no numbers and get none"},
    Dropped{"unpainted_vertices", &ReadReport::unpainted_vertices,
            "vertex gets no colour, since there are fewer #MRGB colours than vertices",
            "vertices get no colour, since there are fewer #MRGB colours than vertices"},
    Dropped{"surplus_paint", &ReadReport::surplus_paint,
            "#MRGB colour dropped, since there are more than vertices",
            "#MRGB colours dropped, since there are more than vertices"},
    Dropped{"unreadable_paint", &ReadReport::unreadable_paint,
            "#MRGB line dropped, since it is not made of 8 hexadecimal digits for each vertex",
            "#MRGB lines dropped, since the first is not made of 8 hexadecimal digits for each "
            "vertex"},
    Dropped{"masked_vertices", &ReadReport::masked_vertices,
            "vertex has an #MRGB mask, which is not kept",
            "vertices have an #MRGB mask, which is not kept"},
    Dropped{"empty_statements", &ReadReport::empty_statements, "f, l or p without corners dropped",
            "statements f, l or p without corners dropped"},
    Dropped{"unknown_statements", &ReadReport::unknown_statements,
            "statement with an unknown keyword dropped",
            "statements with unknown keywords dropped"},
};

// Formats 1234567 as 1,234,567.
std::string grouped(std::uint32_t number) {
    std::string digits = std::to_string(number);
    for (std::size_t i = digits.size(); i > 3;) digits.insert(i -= 3, ",");
    return digits;
}

// The first line of the finding, with the keyword if that is unknown.
std::string first_of(const ReadFinding& found, const ReadReport& read) {
    const std::string line = "line " + std::to_string(found.line);
    if (&found != &read.unknown_statements) {
        return (found.count == 1 ? " (" : " (first in ") + line + ")";
    }
    const std::string should =
        read.likely_keyword.empty() ? "" : ", perhaps meant as " + quoted_word(read.likely_keyword);
    return " (" + quoted_word(read.unknown_keyword) + " in " + line + should + ")";
}

}  // namespace

std::vector<Statistics::Count> input_counts(const BuildReport& report, const ReadReport& read) {
    std::vector<Statistics::Count> counts;
    for (const Finding& finding : kFindings) {
        counts.push_back({finding.name, report.*finding.count});
    }
    for (const Dropped& dropped : kDropped) {
        counts.push_back({dropped.name, (read.*dropped.found).count});
    }
    return counts;
}

InputFindings input_findings(const BuildReport& report, const ReadReport& read) {
    InputFindings findings;
    const auto add = [](std::string& to, const char* separator, std::uint32_t count,
                        const char* one, const char* many) {
        to += (to.empty() ? "" : separator) + grouped(count) + " " + (count == 1 ? one : many);
    };
    for (const Dropped& dropped : kDropped) {
        const ReadFinding& found = read.*dropped.found;
        if (found.count == 0) continue;
        add(findings.dropped, "; ", found.count, dropped.one, dropped.many);
        findings.dropped += first_of(found, read);
    }
    for (const Finding& finding : kFindings) {
        const std::uint32_t count = report.*finding.count;
        if (count == 0 || !finding.one) continue;
        std::string& list = finding.kind == Kind::repair ? findings.repairs : findings.kept;
        add(list, ", ", count, finding.one, finding.many);
    }
    return findings;
}

std::string input_summary(const std::string& path, const BuildReport& report,
                          const ReadReport& read) {
    const InputFindings findings = input_findings(report, read);
    std::string summary;
    const auto tell = [&](const char* before, const std::string& what) {
        if (what.empty()) return;
        summary += summary.empty()
                       ? printable(std::filesystem::path(path).filename().string()) + ": "
                       : "; ";
        summary += before + what;
    };
    tell("", findings.dropped);
    tell("opened with repairs: ", findings.repairs);
    tell("", findings.kept);
    return summary;
}

}  // namespace pectin
