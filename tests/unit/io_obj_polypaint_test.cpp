// Tests the reading of vertex colours in ZBrush's #MRGB comments.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "io/obj_reader.h"
#include "io/obj_writer.h"
#include "mesh/build_mesh.h"

namespace pectin {
namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

IndexedFaceSet parse(const std::string& text, ReadReport& report) {
    return parse_obj(text, "t.obj", {}, {}, &report);
}

TEST(Polypaint, IsReadAndSavedAsVertexColours) {
    ReadReport report;
    const IndexedFaceSet f = parse(kTriangle +
                                       "# The following MRGB block contains ZBrush Vertex Color\n"
                                       "#MRGB ffff0000ff00ff80\n#MRGB FF0000ff\nf 1 2 3\n",
                                   report);
    ASSERT_EQ(f.colors.size(), 3u);
    EXPECT_EQ(f.colors[0], Vec3f(1, 0, 0));
    EXPECT_EQ(f.colors[1], Vec3f(0, 1, 128.0f / 255.0f));
    EXPECT_EQ(f.colors[2], Vec3f(0, 0, 1));
    EXPECT_EQ(report.up_axis, UpAxis::y) << "as ZBrush writes its files";
    report.up_axis.reset();
    EXPECT_EQ(report, ReadReport{});
    const std::string text = format_obj(build_mesh(f).mesh);
    EXPECT_NE(text.find("v 0 0 0 1 0 0\nv 1 0 0 0 1 0.5019608\nv 0 1 0 0 0 1\n"), text.npos)
        << text;
    EXPECT_EQ(parse(text, report).colors, f.colors);
}

TEST(Polypaint, DropsTheMaskAndReportsIt) {
    ReadReport report;
    const IndexedFaceSet f = parse(kTriangle + "#MRGB 00102030fe102030ff102030\nf 1 2 3\n", report);
    EXPECT_EQ(f.colors[0], f.colors[2]);
    EXPECT_EQ(report.masked_vertices, (ReadFinding{2, 4}));
}

TEST(Polypaint, IsReportedIfTheNumberOfVerticesDiffers) {
    ReadReport report;
    IndexedFaceSet f = parse(kTriangle + "#MRGB ffff0000\nf 1 2 3\n", report);
    ASSERT_EQ(f.colors.size(), 3u);
    EXPECT_EQ(f.colors[0], Vec3f(1, 0, 0));
    EXPECT_TRUE(std::isnan(f.colors[1].x));
    EXPECT_EQ(report.unpainted_vertices, (ReadFinding{2, 4}));
    f = parse("#MRGB ffff0000ffff0000ffff0000ffff0000ffff0000\n" + kTriangle + "f 1 2 3\n", report);
    EXPECT_EQ(f.colors.size(), 3u);
    EXPECT_EQ(report.surplus_paint, (ReadFinding{2, 1}));
    EXPECT_EQ(report.unpainted_vertices.count, 0u);
}

TEST(Polypaint, DoesNotReplaceAColourOfTheVertex) {
    ReadReport report;
    const IndexedFaceSet f =
        parse("v 0 0 0 0 1 0\nv 1 0 0\nv 0 1 0\n#MRGB ffff0000ffff0000ffff0000\nf 1 2 3\n", report);
    EXPECT_EQ(f.colors[0], Vec3f(0, 1, 0));
    EXPECT_EQ(f.colors[1], Vec3f(1, 0, 0));
}

TEST(Polypaint, EndsAtAMalformedLine) {
    ReadReport report;
    for (const char* line : {"#MRGB ffff0000ffff00", "#MRGB ffff000g", "#MRGB ffff0000 ff",
                             "#MRGB -fff0000", "#MRGB"}) {
        const IndexedFaceSet f =
            parse(kTriangle + "#MRGB ff00ff00\n" + line + "\n#MRGB ff0000ff\nf 1 2 3\n", report);
        ASSERT_EQ(f.colors.size(), 3u) << line;
        EXPECT_EQ(f.colors[0], Vec3f(0, 1, 0)) << line;
        if (std::string(line) == "#MRGB") continue;  // a line without colours is valid
        EXPECT_TRUE(std::isnan(f.colors[1].x)) << line;
        EXPECT_EQ(report.unreadable_paint, (ReadFinding{2, 5})) << line;
    }
}

TEST(Polypaint, IsNotReadFromOtherComments) {
    ReadReport report;
    const IndexedFaceSet f =
        parse(kTriangle + "#MRG ffff0000\n# MRGB ffff0000\n#mrgb ffff0000\n#MRGBfoo bar\n" +
                  "#MRGBffff0000\nf 1 2 3\n",
              report);
    EXPECT_TRUE(f.colors.empty());
    EXPECT_EQ(report, ReadReport{});
}

}  // namespace
}  // namespace pectin
