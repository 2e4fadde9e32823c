#include "io/material_files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "io/atomic_file.h"
#include "io/file_error.h"
#include "io/read_file.h"
#include "support/scratch_folder.h"
#include "support/small_files.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

// Each test copies files between two folders in a third one.
class MaterialFilesTest : public testing::Test {
  protected:
    MaterialFilesTest() {
        fs::create_directory(from_);
        fs::create_directory(to_);
    }

    static void write(const fs::path& path, const std::string& text) {
        fs::create_directories(path.parent_path());
        write_file_atomically(path.string(), text);
    }
    // Writes a file that begins like a PNG file, so that it is recognised as a picture.
    static std::string picture(const std::string& pixels) { return kPngSignature + pixels; }
    static void write_picture(const fs::path& path, const std::string& pixels = "") {
        write(path, picture(pixels));
    }
    // Names of files and why they were refused or failed, as text.
    static Names names(const std::vector<MaterialCopy::Reason>& reasons) {
        Names all;
        for (const MaterialCopy::Reason& reason : reasons) all.push_back(reason.name);
        return all;
    }
    using Reasons = std::vector<MaterialCopy::Reason>;

    MaterialCopy copy(const Names& statements) const {
        return copy_material_files(statements, from_.string(), to_.string());
    }
    Names files(const fs::path& folder) const {
        const auto names = folder_.files(folder.string());
        return {names.begin(), names.end()};
    }

    ScratchFolder folder_;
    fs::path root_ = folder_.path(), from_ = root_ / "from", to_ = root_ / "to";
};

TEST_F(MaterialFilesTest, CopiesLibrariesAndEveryTextureThatTheyName) {
    write(
        from_ / "a.mtl",
        "newmtl wood\nKd 1 0 0\nmap_Kd wood.png\n\tMap_Ks  -clamp on -o 1 2 -s 1 1 1 my gloss.png "
        "\nbump -bm 0.5 bump.png\nmap_Bump -mm 0 1 -imfchan l b2.png\nrefl -type cube_top r1.png\n"
        "refl -type cube_left r2.png\ndecal d.png\ndisp p.png\nnorm n.png\nmap_Ke maps\\e.png\n"
        "map_opacity -texres 512 -t 0.5 7.png\n# map_Kd no.png\nd 0.5\n");
    const Names textures = {"7.png", "b2.png", "bump.png", "d.png",  "maps/e.png", "my gloss.png",
                            "n.png", "p.png",  "r1.png",   "r2.png", "wood.png"};
    for (const std::string& name : textures) write_picture(from_ / name, "pixels of " + name);
    write(from_ / "no.png", "");
    const MaterialCopy result = copy({"a.mtl"});
    Names all = textures;
    all.insert(all.begin() + 1, "a.mtl");
    EXPECT_EQ(result.copied, all);
    EXPECT_EQ(result.missing, Names{});
    EXPECT_EQ(result.refused, Reasons{});
    EXPECT_EQ(files(to_), all);
    EXPECT_EQ(read_whole_file((to_ / "maps/e.png").string()), picture("pixels of maps/e.png"));
    EXPECT_EQ(read_whole_file((to_ / "a.mtl").string()),
              read_whole_file((from_ / "a.mtl").string()));
}

TEST_F(MaterialFilesTest, DistinguishesSeveralNamesFromOneWithBlanks) {
    for (const char* name : {"a.mtl", "b.mtl", "my first.MTL", "d e.mtl", "x.mtl y.mtl"}) {
        write(from_ / name, "");
    }
    EXPECT_EQ(copy({"a.mtl \t b.mtl my first.MTL"}).copied,
              (Names{"a.mtl", "b.mtl", "my first.MTL"}));
    EXPECT_EQ(copy({"d e.mtl", "x.mtl y.mtl"}).copied, (Names{"d e.mtl", "x.mtl y.mtl"}));
    const MaterialCopy none = copy({"q.mtl r s.mtl t", ".mtl"});
    EXPECT_EQ(none.missing, (Names{"q.mtl", "r s.mtl", "t"}));
    EXPECT_EQ(none.refused, (Reasons{{".mtl", "is hidden"}}));
}

TEST_F(MaterialFilesTest, FindsTexturesBesideTheirLibraryOrBesideTheModel) {
    write(from_ / "mtl/a.mtl", "map_Kd near.png\nmap_Ks far.png\nmap_Ka ../tex/up.png\n");
    for (const char* name : {"mtl/near.png", "near.png", "far.png", "tex/up.png"}) {
        write_picture(from_ / name);
    }
    EXPECT_EQ(copy({"mtl\\a.mtl"}).copied,
              (Names{"far.png", "mtl/a.mtl", "mtl/near.png", "tex/up.png"}));
}

TEST_F(MaterialFilesTest, NeverOverwritesAFile) {
    write(from_ / "a.mtl", "map_Kd t.png\nmap_Ks link.png\nmap_Ka gone.png\nmap_Ke new.png\n");
    for (const char* name : {"t.png", "link.png", "new.png"}) write_picture(from_ / name);
    write(to_ / "a.mtl", "mine");
    write(to_ / "t.png", "mine");
    write(to_ / "gone.png", "mine");
    fs::create_symlink(root_ / "elsewhere", to_ / "link.png");  // to a file that does not exist
    const MaterialCopy result = copy({"a.mtl"});
    EXPECT_EQ(result.copied, Names{"new.png"});
    EXPECT_EQ(result.missing, Names{});
    EXPECT_EQ(read_whole_file((to_ / "a.mtl").string()), "mine");
    EXPECT_EQ(read_whole_file((to_ / "t.png").string()), "mine");
    EXPECT_FALSE(fs::exists(root_ / "elsewhere"));
}

TEST_F(MaterialFilesTest, AccessesNothingOutsideTheFolder) {
    write(root_ / "secret.png", "secret");
    write(root_ / "secret.mtl", "");
    const std::string absolute = (root_ / "secret.png").string();
    write(from_ / "a.mtl", "map_Kd ../secret.png\nmap_Ks " + absolute +
                               "\nmap_Ka x/../../secret.png\nbump ..\\secret.png\nmap_Ke .\n" +
                               "disp ..\nrefl sub/\nnorm ../from/a.mtl\n" +
                               std::string("map_d ..\0x/secret.png\n", 22));
    fs::create_directory(from_ / "sub");
    const MaterialCopy result =
        copy({"a.mtl", "../secret.mtl", (root_ / "secret.mtl").string(), "..\\secret.mtl", ".."});
    EXPECT_EQ(result.copied, Names{"a.mtl"});
    EXPECT_EQ(result.missing, Names{});
    EXPECT_EQ(result.refused.size(), 10u);
    for (const auto& [name, why] : result.refused) {
        EXPECT_EQ(why, "leads out of the model's folder") << name;
    }
    EXPECT_EQ(files(to_), Names{"a.mtl"});
    EXPECT_EQ(files(root_).size(), 4u);
}

TEST_F(MaterialFilesTest, ContinuesAfterMissingAndIrregularFiles) {
    EXPECT_EQ(copy({}).copied, Names{});
    EXPECT_EQ(copy({"none.mtl", "none.mtl"}).missing, Names{"none.mtl"});
    write(from_ / "a.mtl",
          "map_Kd gone.png\nmap_Kd\nmap_Ks -s 1 1\nmap_Ka -o\nbump -bm 1 C:\\w.png\n" +
              ("disp " + std::string(5000, 'x')) + "\nmap_d folder.png\nmap_Ke pipe.png\n");
    fs::create_directory(from_ / "folder.png");
    ASSERT_EQ(::mkfifo((from_ / "pipe.png").c_str(), 0600), 0);
    const MaterialCopy result = copy({"a.mtl"});
    EXPECT_EQ(result.copied, Names{"a.mtl"});
    EXPECT_EQ(result.missing, (Names{"1", "C:/w.png", "gone.png", std::string(5000, 'x')}));
    EXPECT_EQ(result.refused,
              (Reasons{{"folder.png", "is a folder, not a file"},
                       {"pipe.png",
                        "is a pipe, not a file; write what comes out of it to a file "
                        "first"}}));
}

TEST_F(MaterialFilesTest, DoesNothingWithinOneFolderOrWithoutATarget) {
    write(from_ / "a.mtl", "");
    const Names statements = {"a.mtl"};
    fs::create_directory_symlink(from_, root_ / "same");
    for (const char* to : {"from", "from/.", "same", "nowhere"}) {
        const MaterialCopy result =
            copy_material_files(statements, from_.string(), (root_ / to).string());
        EXPECT_EQ(result.copied, Names{}) << to;
        EXPECT_EQ(result.missing, Names{}) << to;
    }
    EXPECT_FALSE(fs::exists(root_ / "nowhere"));
}

TEST_F(MaterialFilesTest, ReportsWhyItCannotCopy) {
    write(from_ / "a.mtl", "map_Kd t/x.png\n");
    write_picture(from_ / "t/x.png");
    write(to_ / "t", "a file where the folder has to be");
    const MaterialCopy result = copy({"a.mtl"});
    ASSERT_EQ(result.failed.size(), 1u);
    EXPECT_EQ(result.failed.front().name, "t/x.png");
    EXPECT_TRUE(result.failed.front().why.starts_with("the folder cannot be made: "))
        << result.failed.front().why;
    EXPECT_EQ(files(to_), (Names{"a.mtl", "t"}));
}

// While an object exists, the process has only the rights of an ordinary user, who owns the folder.
class OrdinaryUser {
  public:
    explicit OrdinaryUser(const fs::path& folder) {
        if (::geteuid() != 0) return;
        constexpr uid_t kNobody = 65534;
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            EXPECT_EQ(::lchown(entry.path().c_str(), kNobody, kNobody), 0);
        }
        EXPECT_EQ(::chown(folder.c_str(), kNobody, kNobody), 0);
        EXPECT_EQ(::seteuid(kNobody), 0);
        is_changed_ = true;
    }
    OrdinaryUser(const OrdinaryUser&) = delete;
    OrdinaryUser& operator=(const OrdinaryUser&) = delete;
    ~OrdinaryUser() {
        if (is_changed_) {
            EXPECT_EQ(::seteuid(0), 0);
        }
    }

  private:
    bool is_changed_ = false;
};

TEST_F(MaterialFilesTest, DistinguishesUnreadableFromMissingFiles) {
    write(from_ / "a.mtl",
          "newmtl a\nmap_Kd t/x.png\nmap_Ks locked.png\nmap_Ka loop.png\nmap_d good.png\n");
    write(from_ / "locked.mtl", "newmtl b\n");
    fs::create_symlink("loop.mtl", from_ / "loop.mtl");
    fs::create_symlink("loop.png", from_ / "loop.png");
    for (const char* name : {"t/x.png", "locked.png", "good.png"}) write_picture(from_ / name);
    MaterialCopy result;
    {
        const OrdinaryUser user(root_);
        for (const char* name : {"t", "locked.mtl", "locked.png"}) {
            fs::permissions(from_ / name, fs::perms::none);
        }
        result = copy({"a.mtl", "locked.mtl", "loop.mtl", "gone.mtl"});
        fs::permissions(from_ / "t", fs::perms::owner_all);
    }
    EXPECT_EQ(result.copied, (Names{"a.mtl", "good.png"}));
    EXPECT_EQ(result.missing, Names{"gone.mtl"});
    EXPECT_EQ(result.refused, Reasons{});
    EXPECT_EQ(
        result.failed,
        (Reasons{{"locked.mtl", "no permission to read it"},
                 {"locked.png", "no permission to read it"},
                 {"loop.mtl", "its path cannot be followed: Too many levels of symbolic links"},
                 {"loop.png", "its path cannot be followed: Too many levels of symbolic links"},
                 {"t/x.png", "its path cannot be followed: Permission denied"}}));
}

TEST_F(MaterialFilesTest, ReportsMissingFilesIfTheWholeFolderIsMissing) {
    fs::remove_all(from_);
    EXPECT_EQ(copy({"a.mtl"}).missing, Names{"a.mtl"});
}

TEST_F(MaterialFilesTest, LooksUpALimitedNumberOfNamesAndReportsIt) {
    std::string library = "newmtl a\n";
    for (int i = 0; i < 8; ++i) library += "map_Kd " + std::to_string(i % 4) + ".png\n";
    write(from_ / "a.mtl", library);
    for (const char* name : {"0.png", "1.png", "2.png", "3.png"}) write_picture(from_ / name);
    const Names statements = {"a.mtl", "a.mtl"};
    const auto copy_at_most = [&](std::size_t names) {
        return copy_material_files(statements, from_.string(), to_.string(), {}, {.names = names});
    };
    MaterialCopy result = copy_at_most(3);
    EXPECT_EQ(result.copied.size(), 3u);
    EXPECT_EQ(result.refused, (Reasons{{"all names after the first 3", "are too many"}}));
    result = copy_at_most(5);
    EXPECT_EQ(result.copied.size(), 2u) << "those that are not there yet";
    EXPECT_EQ(result.refused, Reasons{}) << "a name counts once";
}

// In an earlier version each name took two or four threads, and this many names took minutes.
TEST_F(MaterialFilesTest, TakesLittleTimeForManyNames) {
    std::string library = "newmtl a\n";
    for (int i = 0; i < 100'000; ++i) library += "map_Kd " + std::to_string(i) + "\\t.png\n";
    write(from_ / "m/a.mtl", library);
    Names statements(100'000, "m/a.mtl");
    const auto begin = std::chrono::steady_clock::now();
    MaterialCopy result = copy(statements);
    EXPECT_EQ(result.copied, Names{"m/a.mtl"});
    EXPECT_EQ(result.missing.size() + 1, MaterialLimits{}.names);
    for (std::string& name : statements) name = std::to_string(&name - statements.data()) + ".mtl";
    result = copy(statements);
    EXPECT_EQ(result.missing.size(), MaterialLimits{}.names);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(40));
}

TEST_F(MaterialFilesTest, CanBeCancelledWhileLookingUpNames) {
    std::string library = "newmtl a\n";
    for (int i = 0; i < 1000; ++i) library += "map_Kd " + std::to_string(i) + ".png\n";
    write(from_ / "a.mtl", library);
    std::stop_source stop;
    int reports = 0;
    const Progress progress(stop.get_token(), [&](double) {
        if (++reports == 100) stop.request_stop();
    });
    const Names statements = {"a.mtl"};
    EXPECT_THROW(copy_material_files(statements, from_.string(), to_.string(), progress),
                 Cancelled);
    EXPECT_LE(reports, 101);
    EXPECT_EQ(files(to_), Names{});
}

TEST_F(MaterialFilesTest, FollowsNoLinkOutOfEitherFolder) {
    const fs::path secret = from_.parent_path() / "secret";
    fs::create_directories(secret);
    write_picture(secret / "s.png");
    write(from_ / "a.mtl",
          "map_Kd link.png\nmap_Ks linked/s.png\nmap_Ka sub/t.png\nbump near.png\n");
    fs::create_symlink(secret / "s.png", from_ / "link.png");
    fs::create_directory_symlink(secret, from_ / "linked");
    write_picture(from_ / "t.png");
    fs::create_symlink("t.png", from_ / "near.png");  // stays inside the folder
    fs::create_directories(from_ / "sub");
    write_picture(from_ / "sub/t.png");
    fs::create_directory_symlink(secret, to_ / "sub");
    const Names statements = {"a.mtl"};
    const MaterialCopy copy = copy_material_files(statements, from_.string(), to_.string());
    EXPECT_EQ(copy.copied, (Names{"a.mtl", "near.png"}));
    EXPECT_EQ(names(copy.refused), (Names{"link.png", "linked/s.png", "sub/t.png"}));
    EXPECT_FALSE(fs::exists(secret / "t.png"));
    fs::remove_all(secret);
}

// The names in an untrusted model are chosen so that a save would write or copy hidden files.
TEST_F(MaterialFilesTest, RefusesEveryNameWithAHiddenPart) {
    write(from_ / "a.mtl",
          "newmtl a\nmap_Kd .config/autostart/x.desktop\nmap_Ks tex/.hidden.png\n"
          "map_Ka tex\\.deep\\x.png\nbump ./.ssh/id.png\nmap_Ke link.png\nmap_d .\\shown.png\n");
    for (const char* name : {".config/autostart/x.desktop", "tex/.hidden.png", "tex/.deep/x.png",
                             ".ssh/id.png", ".kept.png", "shown.png"}) {
        write_picture(from_ / name);
    }
    fs::create_symlink(".kept.png", from_ / "link.png");
    write(from_ / ".bashrc", "newmtl a\n");
    const MaterialCopy result = copy({"a.mtl", ".bashrc", "./.bashrc", "sub/../.bashrc"});
    EXPECT_EQ(result.copied, (Names{"a.mtl", "shown.png"}));
    EXPECT_EQ(names(result.refused), (Names{".bashrc", ".config/autostart/x.desktop", ".ssh/id.png",
                                            "link.png", "tex/.deep/x.png", "tex/.hidden.png"}));
    for (const auto& [name, why] : result.refused) EXPECT_EQ(why, "is hidden") << name;
    EXPECT_EQ(files(to_), (Names{"a.mtl", "shown.png"}));
}

TEST_F(MaterialFilesTest, RefusesToWriteThroughALinkIntoAHiddenFolder) {
    write(from_ / "a.mtl", "map_Kd t/x.png\n");
    write_picture(from_ / "t/x.png");
    fs::create_directory(to_ / ".config");
    fs::create_directory_symlink(".config", to_ / "t");
    EXPECT_EQ(copy({"a.mtl"}).refused, (Reasons{{"t/x.png", "is hidden"}}));
    EXPECT_TRUE(fs::is_empty(to_ / ".config"));
}

TEST_F(MaterialFilesTest, RefusesTexturesAndLibrariesOfAnotherKind) {
    write(from_ / "a.mtl", "newmtl a\nmap_Kd run.png\nmap_Ks empty.png\nmap_Ka ok.tga\n");
    write(from_ / "run.png", "#!/bin/sh\nrm -r ~\n");
    write(from_ / "empty.png", "");
    std::string tga(18 + 4 * 4 * 3, '\x55');
    tga.replace(0, 18, std::string("\0\0\2\0\0\0\0\0\0\0\0\0\4\0\4\0\x18\0", 18));
    write(from_ / "ok.tga", tga);
    write(from_ / "notes.mtl", "the password is swordfish\n");
    const MaterialCopy result = copy({"a.mtl", "notes.mtl"});
    EXPECT_EQ(result.copied, (Names{"a.mtl", "ok.tga"}));
    EXPECT_EQ(result.refused, (Reasons{{"empty.png", "is no picture"},
                                       {"notes.mtl", "is no material library"},
                                       {"run.png", "is no picture"}}));
}

// Files that other programs would execute or obey, made to look like libraries or pictures.
TEST_F(MaterialFilesTest, RefusesScriptsThatLookLikeLibrariesOrPictures) {
    write(from_ / "evil.desktop", "[Desktop Entry]\nExec=evil\nnewmtl a\n");
    write(from_ / "autorun.sh", "#!/bin/sh\nnewmtl a\n");
    write(from_ / "plain.desktop", "newmtl a\n");
    write(from_ / "script.mtl", "#!/bin/sh\nnewmtl a\nmap_Kd a.png\n");
    // Radiance pictures and desktop files may begin with comments; Netpbm pictures may contain any
    // text.
    write(from_ / "start.desktop", "#?RGBE\n[Desktop Entry]\nExec=evil\n");
    write(from_ / "Makefile", "P1 3\nall:\n\tevil\n");
    write_picture(from_ / "a.png");
    write(from_ / "a.mtl", "newmtl a\nmap_Kd start.desktop\nmap_Ks Makefile\n");
    const MaterialCopy result =
        copy({"evil.desktop", "autorun.sh", "plain.desktop", "script.mtl", "a.mtl"});
    EXPECT_EQ(result.copied, Names{"a.mtl"});
    EXPECT_EQ(result.refused, (Reasons{{"Makefile", "is not named as a picture"},
                                       {"autorun.sh", "does not end in .mtl"},
                                       {"evil.desktop", "does not end in .mtl"},
                                       {"plain.desktop", "does not end in .mtl"},
                                       {"script.mtl", "is no material library"},
                                       {"start.desktop", "is not named as a picture"}}));
    EXPECT_EQ(files(to_), Names{"a.mtl"});
}

TEST_F(MaterialFilesTest, RefusesFilesLargerThanTheLimits) {
    write(from_ / "a.mtl", "map_Kd large.png\nmap_Ks small.png\n");
    write(from_ / "b.mtl", "newmtl b\n" + std::string(3 << 20, '#'));
    write_picture(from_ / "small.png");
    write_picture(from_ / "large.png");
    fs::resize_file(from_ / "large.png", (5u << 20) + 1);
    const Names statements = {"a.mtl", "b.mtl"};
    const MaterialCopy result =
        copy_material_files(statements, from_.string(), to_.string(), {},
                            {.library_bytes = 2u << 20, .texture_bytes = 5u << 20});
    EXPECT_EQ(result.copied, (Names{"a.mtl", "small.png"}));
    EXPECT_EQ(result.refused,
              (Reasons{{"b.mtl", "is larger than 2 MB"}, {"large.png", "is larger than 5 MB"}}));
}

TEST_F(MaterialFilesTest, CanBeCancelledBetweenTwoFiles) {
    write(from_ / "a.mtl", "map_Kd b.png\n");
    write_picture(from_ / "b.png", std::string(3 << 20, 'x'));
    std::stop_source stop;
    double last = 0.0;
    const Progress progress(stop.get_token(), [&](double fraction) {
        EXPECT_GE(fraction, last);
        last = fraction;
        if (fraction >= 0.5) stop.request_stop();
    });
    const Names statements = {"a.mtl"};
    EXPECT_THROW(copy_material_files(statements, from_.string(), to_.string(), progress),
                 Cancelled);
    EXPECT_EQ(files(to_), Names{"a.mtl"});
}

}  // namespace
}  // namespace pectin
