// Loading and saving models without a session.
#include "session/model_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stop_token>
#include <tuple>
#include <vector>

#include "io/file_error.h"
#include "io/obj_writer.h"
#include "session/session.h"
#include "support/scratch_folder.h"
#include "support/small_files.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;

class ModelFile : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_.path(name); }
    void write(const std::string& name, const std::string& text) const {
        folder_.write(name, text);
    }
    std::string read(const std::string& name) const { return folder_.read(name); }
    std::size_t file_count() const { return folder_.files().size(); }
    // A sphere of 20480 faces in a file of its own.
    std::string sphere() const {
        Session session;
        EXPECT_TRUE(session.execute(command::Shape{command::Shape::Kind::sphere, 5}));
        EXPECT_TRUE(session.execute(command::Save{path("sphere.obj")}));
        return path("sphere.obj");
    }

  private:
    ScratchFolder folder_;
};

// The fractions that the work reports.
template <typename Work>
std::vector<double> reported(Work work) {
    std::vector<double> fractions;
    work(Progress({}, [&](double fraction) { fractions.push_back(fraction); }));
    return fractions;
}

void expect_rise_to_one(const std::vector<double>& fractions) {
    ASSERT_GE(fractions.size(), 10u) << "too few to move a bar";
    EXPECT_GE(fractions.front(), 0.0);
    EXPECT_EQ(fractions.back(), 1.0);
    for (std::size_t i = 1; i < fractions.size(); ++i) {
        EXPECT_GE(fractions[i], fractions[i - 1]) << i;
    }
}

// Runs the work and stops it at `fraction`. Returns whether it ended with that.
template <typename Work>
bool is_stopped_at(double fraction, Work work) {
    std::stop_source stop;
    const Progress progress(stop.get_token(), [&](double reached) {
        if (reached >= fraction) stop.request_stop();
    });
    try {
        work(progress);
    } catch (const Cancelled&) {
        return true;
    }
    return false;
}

TEST_F(ModelFile, AdoptedIsWhatOpenMakesWithANewHistory) {
    const command::Open open{sphere()};
    Session opened, adopting;
    ASSERT_TRUE(opened.execute(open));
    ASSERT_TRUE(adopting.execute(command::Shape{}));
    ASSERT_TRUE(adopting.execute(command::Drag{.moves = {{{0, 0, 1}, {0, 0, 1.3}}}}));
    ASSERT_EQ(adopting.undo_count(), 1u);
    adopting.adopt(load_model(open));
    EXPECT_EQ(adopting.mesh(), opened.mesh());
    EXPECT_EQ(adopting.undo_count(), 0u);
    EXPECT_TRUE(adopting.take_dirty().everything);
    for (Session* session : {&opened, &adopting}) {
        ASSERT_TRUE(session->execute(command::Drag{.moves = {{{0, 0, 1}, {0, 0, 1.3}}}}));
    }
    EXPECT_EQ(format_obj(adopting.mesh()), format_obj(opened.mesh()));
}

TEST_F(ModelFile, LoadingMakesTheTreeSoThatTheFirstPickDoesNotWait) {
    const LoadedModel model = load_model({sphere()});
    ASSERT_TRUE(model.tree);
    const auto hit = model.tree->first_hit(Ray{{0, 0, 5}, {0, 0, -1}}, *model.mesh);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->hit.t, 4.0, 1e-3);
}

TEST_F(ModelFile, ProgressRisesToOne) {
    const std::string file = sphere();
    LoadedModel model;
    expect_rise_to_one(reported([&](const Progress& p) { model = load_model({file}, p); }));
    expect_rise_to_one(
        reported([&](const Progress& p) { save_model(*model.mesh, {path("b.obj")}, p); }));
    EXPECT_EQ(read("b.obj"), read("sphere.obj"));
}

TEST_F(ModelFile, LoadingCanBeStoppedAnywhere) {
    const std::string file = sphere();
    for (double fraction : {0.0, 0.15, 0.3, 0.7}) {
        EXPECT_TRUE(is_stopped_at(fraction, [&](const Progress& p) { load_model({file}, p); }))
            << fraction;
    }
}

TEST_F(ModelFile, SavingThatIsStoppedLeavesTheFileAsItWasAndNoOther) {
    const LoadedModel model = load_model({sphere()});
    write("kept.obj", "precious");
    const std::size_t files = file_count();
    for (double fraction : {0.0, 0.2, 0.4, 0.6, 0.9}) {
        EXPECT_TRUE(is_stopped_at(fraction, [&](const Progress& p) {
            save_model(*model.mesh, {path("kept.obj")}, p);
        })) << fraction;
        EXPECT_EQ(read("kept.obj"), "precious") << fraction;
        EXPECT_EQ(file_count(), files) << fraction;
    }
}

TEST_F(ModelFile, LoadingAFileThatIsNoModelIsAnErrorThatNamesIt) {
    write("flat.obj", "v 0 0 0\nv 1 0 0\nf 1 2 1\n");
    try {
        load_model({path("flat.obj")});
        FAIL() << "was loaded";
    } catch (const FileError& error) {
        EXPECT_EQ(error.path(), path("flat.obj"));
        EXPECT_NE(error.message().find("three different vertices"), std::string::npos);
    }
    EXPECT_THROW(load_model({path("absent.obj")}), FileError);
    const LoadedModel model = load_model({sphere()});
    EXPECT_THROW(save_model(*model.mesh, {path("model.stl")}), FileError);
    EXPECT_FALSE(fs::exists(path("model.stl")));
}

TEST_F(ModelFile, SavedElsewhereHasItsMaterialFilesThere) {
    for (const char* folder : {"a", "b", "c", "d"}) fs::create_directory(path(folder));
    write("a/model.obj", "mtllib m.mtl\n" + kTriangle);
    write("a/m.mtl", "map_Kd t.png\n");
    write("a/t.png", kPngSignature + "pixels");
    Session session;
    ASSERT_TRUE(session.execute(command::Open{path("a/model.obj")}));
    ASSERT_TRUE(session.execute(command::Save{path("b/model.obj")}));
    EXPECT_EQ(read("b/t.png"), kPngSignature + "pixels");
    EXPECT_EQ(session.remark(), "model.obj: material files copied: m.mtl, t.png");
    EXPECT_FALSE(session.has_failed_partly());
    // Now the files are in both folders, and the folder of the later save is searched first.
    write("b/m.mtl", "map_Kd t.png\nmap_Ks u.png\n");
    fs::remove(path("b/t.png"));
    write("b/u.png", kPngSignature + "more");
    ASSERT_TRUE(session.execute(command::Save{path("c/model.obj")}));
    EXPECT_EQ(read("c/m.mtl"), read("b/m.mtl"));
    EXPECT_EQ(read("c/t.png"), kPngSignature + "pixels");
    EXPECT_EQ(read("c/u.png"), kPngSignature + "more");
    EXPECT_EQ(session.remark(), "model.obj: material files copied: m.mtl, t.png, u.png")
        << "a file that one folder lacks and another has is not missing";
    // The files of another object are not copied.
    ASSERT_TRUE(session.execute(command::Shape{}));
    EXPECT_TRUE(session.material_folders().empty());
}

TEST_F(ModelFile, SavedElsewhereReportsOnEachMaterialFile) {
    for (const char* folder : {"a", "b", "a/.ssh"}) fs::create_directory(path(folder));
    write("a/model.obj", "mtllib m.mtl .ssh/k.mtl\nmtllib ../up.mtl\n" + kTriangle);
    write("a/m.mtl", "newmtl m\nmap_Kd t.png\nmap_Ks gone\x1b[1m.png\nmap_Ka run.png\n");
    write("a/t.png", kPngSignature);
    write("a/run.png", "#!/bin/sh\n");
    write("a/.ssh/k.mtl", "newmtl k\n");
    write("up.mtl", "newmtl u\n");
    Session session;
    ASSERT_TRUE(session.execute(command::Open{path("a/model.obj")}));
    ASSERT_TRUE(session.execute(command::Save{path("b/model.obj")}));
    EXPECT_EQ(session.remark(),
              "model.obj: material files copied: m.mtl, t.png; material files not found: "
              "gone\\x1B[1m.png; material files not copied: ../up.mtl (leads out of the model's "
              "folder), .ssh/k.mtl (is hidden), run.png (is no picture)");
    EXPECT_FALSE(session.has_failed_partly()) << "nothing that should be copied was not";
}

TEST_F(ModelFile, IsSavedAlsoIfItsMaterialFilesCannotBe) {
    for (const char* folder : {"a", "b"}) fs::create_directory(path(folder));
    write("a/model.obj", "mtllib m/m.mtl other.mtl\n" + kTriangle);
    fs::create_directory(path("a/m"));
    write("a/m/m.mtl", "");
    write("a/other.mtl", "newmtl red\n");
    write("b/m", "a file where the folder has to be");
    Session session;
    ASSERT_TRUE(session.execute(command::Open{path("a/model.obj")}));
    EXPECT_EQ(session.remark(), "");
    ASSERT_TRUE(session.execute(command::Save{path("b/model.obj")}));
    EXPECT_EQ(read("b/model.obj"), format_obj(session.mesh()));
    EXPECT_EQ(read("b/other.mtl"), "newmtl red\n");
    EXPECT_TRUE(session.remark().starts_with(
        "model.obj: material files copied: other.mtl; material files that could not be copied: "
        "m/m.mtl (the folder cannot be made: "))
        << session.remark();
    EXPECT_TRUE(session.has_failed_partly());
    // A save that fails copies nothing.
    fs::create_directory(path("c"));
    fs::create_directory(path("c/model.obj"));
    EXPECT_THROW(std::ignore = session.execute(command::Save{path("c/model.obj")}), FileError);
    EXPECT_FALSE(fs::exists(path("c/other.mtl")));
}

}  // namespace
}  // namespace pectin
