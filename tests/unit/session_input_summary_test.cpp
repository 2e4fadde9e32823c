// Tests the report on an opened model, as a sentence and as counts.
#include "session/input_summary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "command/json.h"
#include "session/session.h"

namespace pectin {
namespace {

TEST(InputSummary, IsEmptyWithoutFindings) {
    EXPECT_EQ(input_summary("a.obj", {}), "");
    // Quads and open borders are not reported.
    EXPECT_EQ(input_summary("a.obj", {.triangulated_polygons = 7, .boundary_edges = 4}), "");
}

TEST(InputSummary, IsOneSentenceThatBeginsWithTheFilesName) {
    EXPECT_EQ(
        input_summary("/models/my beetle.obj",
                      {.zero_area_faces = 3, .nonmanifold_edges = 47, .isolated_vertices = 1}),
        "my beetle.obj: opened with repairs: 47 non-manifold edges split; 3 faces without area "
        "kept, 1 unused vertex kept");
}

TEST(InputSummary, GroupsTheDigitsOfLargeCountsAndTellsRepairsFromWhatIsKept) {
    const InputFindings found = input_findings(
        {.nonmanifold_edges = 2, .nonmanifold_vertices = 4, .isolated_vertices = 1113});
    EXPECT_EQ(found.dropped, "");
    EXPECT_EQ(found.repairs, "2 non-manifold edges split, 4 shared vertices");
    EXPECT_EQ(found.kept, "1,113 unused vertices kept");
}

TEST(InputSummary, BeginsWithWhatWasDroppedAndItsLine) {
    ReadReport read;
    read.missing_uvs.add(7, 3);
    read.undefined_colors.add(2);
    read.unknown_statements.add(5, 2);
    read.unknown_keyword = "F";
    read.likely_keyword = "f";
    EXPECT_EQ(
        input_summary("a.obj", {.isolated_vertices = 1}, read),
        "a.obj: 3 corners name texture coordinates that the file does not have and get none "
        "(first in line 7); 1 vertex has a colour that is no number and gets none (line 2); 2 "
        "statements with unknown keywords dropped ('F' in line 5, perhaps meant as 'f'); 1 "
        "unused vertex kept");
}

TEST(InputSummary, ShowsControlCharactersOfTheFilesNameEscaped) {
    EXPECT_EQ(input_summary("/models/\x1b[2J\n.obj", {.isolated_vertices = 1}),
              "\\x1B[2J\\x0A.obj: 1 unused vertex kept");
}

TEST(InputSummary, ReportsSeamsAndCrossingPolygonsInSingularAndPlural) {
    EXPECT_EQ(input_summary("a.obj", {.crossing_polygons = 1, .seams = 1, .seam_edges = 4}),
              "a.obj: opened with repairs: 1 polygon triangulated roughly (it crosses itself or is "
              "far from flat), 1 seam of unshared vertices moved together");
    EXPECT_EQ(input_summary("a.obj", {.crossing_polygons = 2, .seams = 12}),
              "a.obj: opened with repairs: 2 polygons triangulated roughly (they cross themselves "
              "or are far from flat), 12 seams of unshared vertices moved together");
}

TEST(InputSummary, CountsAreTheReportsAndEachHasAName) {
    const BuildReport report{.triangulated_polygons = 1,
                             .crossing_polygons = 24,
                             .degenerate_polygons = 2,
                             .repeated_corners = 3,
                             .zero_area_faces = 4,
                             .duplicate_faces = 5,
                             .nonmanifold_edges = 6,
                             .misoriented_edges = 7,
                             .nonmanifold_vertices = 8,
                             .seams = 25,
                             .seam_edges = 26,
                             .boundary_edges = 9,
                             .isolated_vertices = 10,
                             .lines = 11,
                             .points = 12};
    const ReadReport read{.missing_uvs = {13},
                          .missing_normals = {14},
                          .undefined_uvs = {15},
                          .undefined_normals = {16},
                          .undefined_colors = {17},
                          .empty_statements = {18},
                          .unknown_statements = {19},
                          .unpainted_vertices = {20},
                          .surplus_paint = {21},
                          .unreadable_paint = {22},
                          .masked_vertices = {23},
                          .unknown_keyword = {},
                          .likely_keyword = {}};
    std::set<std::string> names;
    std::set<std::uint64_t> counts;
    for (const Statistics::Count& count : input_counts(report, read)) {
        names.insert(count.name);
        counts.insert(count.count);
    }
    EXPECT_EQ(names.size(), 26u);
    ASSERT_EQ(counts.size(), 26u);
    EXPECT_EQ(*counts.begin(), 1u);
    EXPECT_EQ(*counts.rbegin(), 26u);
}

TEST(InputSummary, StatisticsHoldTheCountsOfTheObject) {
    Session session;
    ASSERT_TRUE(session.execute(command::Shape{command::Shape::Kind::plane, 2}));
    const auto& input = session.statistics().input;
    EXPECT_EQ(input, input_counts(session.input_report()));
    EXPECT_EQ(session.input_report().triangulated_polygons, 4u);
    EXPECT_NE(format_statistics(session.statistics()).find("\"triangulated_polygons\": 4"),
              std::string::npos);
}

}  // namespace
}  // namespace pectin
