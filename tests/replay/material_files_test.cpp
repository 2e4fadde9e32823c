// Tests that saving a model in another folder copies its material files and no others, and reports
// what happened to each.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <filesystem>
#include <set>
#include <string>

#include "replay/program.h"
#include "support/small_files.h"

namespace pectin {
namespace {

using Files = std::set<std::string>;

// Opens the model and saves it; both paths are relative to the folder.
Outcome open_and_save(const ScratchFolder& folder, const std::string& model,
                      const std::string& saved) {
    return run_program({"replay", write_script(folder, "s.jsonl",
                                               {R"({"cmd": "open", "path": ")" + model + "\"}",
                                                R"({"cmd": "save", "path": ")" + saved + "\"}",
                                                R"({"cmd": "stats", "path": "s.json"})"})});
}

TEST(MaterialFiles, AreRefusedIfTheyWouldWriteAHiddenFile) {
    const ScratchFolder folder;
    folder.write("from/w.obj", "mtllib w.mtl\n" + kTriangle);
    folder.write("from/w.mtl", "newmtl a\nmap_Kd .config/autostart/x.desktop\n");
    folder.write("from/.config/autostart/x.desktop", "[Desktop Entry]\n");
    folder.write("home/own.txt", "");
    const Outcome outcome = open_and_save(folder, "from/w.obj", "home/w.obj");
    EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
    EXPECT_FALSE(folder.holds("home/.config"));
    EXPECT_EQ(outcome.err, folder.path("s.jsonl") +
                               ":3: save: w.obj: material files copied: w.mtl; material files not "
                               "copied: .config/autostart/x.desktop (is hidden)\n");
}

TEST(MaterialFiles, DoNotIncludeHiddenFilesOfTheHomeFolder) {
    const ScratchFolder folder;
    folder.write("home/w.obj", "mtllib .bashrc\nmtllib w.mtl\n" + kTriangle);
    folder.write("home/w.mtl", "newmtl a\nmap_Kd .ssh/id.png\nmap_Ks notes.txt\n");
    folder.write("home/.bashrc", "newmtl export TOKEN=secret\n");
    folder.write("home/.ssh/id.png", kPngSignature);
    folder.write("home/notes.txt", "private\n");
    folder.write("stick/own.txt", "");
    const Outcome outcome = open_and_save(folder, "home/w.obj", "stick/w.obj");
    EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
    for (const char* name : {"stick/.bashrc", "stick/.ssh", "stick/notes.txt"}) {
        EXPECT_FALSE(folder.holds(name)) << name;
    }
    EXPECT_NE(outcome.err.find("not copied: .bashrc (is hidden), .ssh/id.png (is hidden), "
                               "notes.txt (is not named as a picture)\n"),
              std::string::npos)
        << outcome.err;
}

TEST(MaterialFiles, AreReportedIfOutsideTheFolderOrMissing) {
    const ScratchFolder folder;
    folder.write("from/w.obj", "mtllib w.mtl ../up.mtl gone.mtl\n" + kTriangle);
    folder.write("from/w.mtl", "newmtl a\nmap_Kd ../t.png\nmap_Ks lost.png\n");
    folder.write("up.mtl", "newmtl b\n");
    folder.write("t.png", kPngSignature);
    folder.write("to/own.txt", "");
    const Outcome outcome = open_and_save(folder, "from/w.obj", "to/w.obj");
    EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("material files not found: gone.mtl, lost.png; material files not "
                               "copied: ../t.png (leads out of the model's folder), ../up.mtl "
                               "(leads out of the model's folder)\n"),
              std::string::npos)
        << outcome.err;
}

// The model is saved and later lines are executed, but the script has not fully succeeded.
TEST(MaterialFiles, CauseExitStatusOneIfTheyCannotBeCopied) {
    const ScratchFolder folder;
    folder.write("from/w.obj", "mtllib w.mtl\n" + kTriangle);
    folder.write("from/w.mtl", "newmtl a\nmap_Kd t/x.png\n");
    folder.write("from/t/x.png", kPngSignature);
    folder.write("to/t", "a file where the folder has to be");
    const Outcome outcome = open_and_save(folder, "from/w.obj", "to/w.obj");
    EXPECT_EQ(outcome.exit_status, 1);
    EXPECT_TRUE(folder.holds("to/w.obj"));
    EXPECT_TRUE(folder.holds("s.json")) << "the next line is done";
    EXPECT_NE(outcome.err.find("could not be copied: t/x.png (the folder cannot be made"),
              std::string::npos)
        << outcome.err;
}

TEST(MaterialFiles, CauseExitStatusOneIfTheyCannotBeRead) {
    const ScratchFolder folder;
    folder.write("from/w.obj", "mtllib w.mtl\n" + kTriangle);
    std::filesystem::create_symlink("w.mtl", folder.path("from/w.mtl"));
    folder.write("to/own.txt", "");
    const Outcome outcome = open_and_save(folder, "from/w.obj", "to/w.obj");
    EXPECT_EQ(outcome.exit_status, 1);
    EXPECT_NE(outcome.err.find("could not be copied: w.mtl (its path cannot be followed"),
              std::string::npos)
        << outcome.err;
}

TEST(MaterialFiles, AreRefusedIfTheyAreScriptsWithALineOfALibrary) {
    const ScratchFolder folder;
    folder.write("from/w.obj", "mtllib evil.desktop\nmtllib autorun.sh\n" + kTriangle);
    folder.write("from/evil.desktop", "[Desktop Entry]\nExec=evil\nnewmtl a\n");
    folder.write("from/autorun.sh", "#!/bin/sh\nnewmtl a\n");
    folder.write("to/own.txt", "");
    const Outcome outcome = open_and_save(folder, "from/w.obj", "to/w.obj");
    EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
    EXPECT_FALSE(folder.holds("to/evil.desktop"));
    EXPECT_FALSE(folder.holds("to/autorun.sh"));
}

TEST(MaterialFiles, DoNotBlockIfTheyArePipes) {
    const ScratchFolder folder;
    folder.write("from/w.obj", "mtllib w.mtl pipe.mtl\n" + kTriangle);
    folder.write("from/w.mtl", "newmtl a\nmap_Kd pipe.png\n");
    folder.write("to/own.txt", "");
    for (const char* pipe : {"from/pipe.mtl", "from/pipe.png", "pipe.obj"}) {
        ASSERT_EQ(::mkfifo(folder.path(pipe).c_str(), 0600), 0);
    }
    const auto begin = std::chrono::steady_clock::now();
    Outcome outcome = open_and_save(folder, "from/w.obj", "to/w.obj");
    EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("pipe.png (is a pipe"), std::string::npos) << outcome.err;
    outcome = open_and_save(folder, "pipe.obj", "to/p.obj");
    EXPECT_EQ(outcome.exit_status, 1);
    EXPECT_NE(outcome.err.find("pipe.obj: is a pipe, not a file"), std::string::npos);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

}  // namespace
}  // namespace pectin
