// Tests the table of model file formats and the functions that use it.
#include "io/model_format.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "io/file_error.h"
#include "io/obj_reader.h"
#include "mesh/build_mesh.h"

namespace pectin {
namespace {

TEST(ModelFormats, HaveDifferentLowerCaseExtensionsAndReaders) {
    std::vector<std::string> extensions = readable_extensions();
    EXPECT_EQ(extensions.size(), model_formats().size());
    for (const ModelFormat& format : model_formats()) {
        EXPECT_TRUE(format.extension.starts_with('.'));
        EXPECT_TRUE(std::none_of(format.extension.begin(), format.extension.end(),
                                 [](char c) { return c >= 'A' && c <= 'Z'; }));
        EXPECT_NE(format.read, nullptr);
    }
    std::sort(extensions.begin(), extensions.end());
    EXPECT_EQ(std::adjacent_find(extensions.begin(), extensions.end()), extensions.end());
}

TEST(ModelFormats, ArePreferredInTheOrderOfTheTable) {
    EXPECT_EQ(writable_extensions().front(), model_formats().front().extension);
    EXPECT_EQ(readable_extensions().front(), model_formats().front().extension);
}

TEST(ModelFormats, AreRecognisedByExtensionInUpperAndLowerCase) {
    EXPECT_TRUE(has_extension("a.OBJ", ".obj"));
    EXPECT_TRUE(has_extension(".obj", ".obj"));
    EXPECT_FALSE(has_extension("a.obj.gz", ".obj"));
    EXPECT_FALSE(has_extension("obj", ".obj"));
}

TEST(ModelFormats, OfUnknownExtensionsAreTheFirst) {
    EXPECT_EQ(format_for_reading("a.obj").name, "OBJ");
    EXPECT_EQ(format_for_reading("a.unknown").name, model_formats().front().name);
    EXPECT_EQ(format_for_reading("a").name, model_formats().front().name);
}

TEST(ModelFormats, RefuseToWriteAnUnknownExtensionAndNameTheKnownOnes) {
    const BuiltMesh triangle =
        build_mesh(parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "triangle"), {});
    try {
        write_model(triangle.mesh, "triangle.stl");
        FAIL() << "wrote a format that is not in the table";
    } catch (const FileError& error) {
        EXPECT_EQ(error.message(), "does not end in .obj; save writes OBJ files");
    }
    EXPECT_FALSE(std::filesystem::exists("triangle.stl"));
}

}  // namespace
}  // namespace pectin
