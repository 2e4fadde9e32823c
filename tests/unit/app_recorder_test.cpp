// Recorder: earlier records are kept, and a record that can no longer be written stays valid.
#include <sys/stat.h>

#include "unit/app_recovery_fixture.h"

namespace pectin {
namespace {

class RecorderTest : public RecoveryTest {
  protected:
    static std::string error_of(const std::string& path) {
        try {
            const Recorder recorder(path);
            return {};
        } catch (const FileError& error) {
            return error.what();
        }
    }
};

TEST_F(RecorderTest, ARecordThatCanNoLongerBeWrittenEndsWithACompleteLineAndAMessage) {
    auto editor = this->editor(Recorder(path("record.jsonl")));
    ASSERT_TRUE(editor.execute(kDrag));
    const std::string before = read("record.jsonl");
    {
        const FileSizeLimit limit(before.size() + 10);
        ASSERT_TRUE(editor.execute(kDrag));
    }
    EXPECT_EQ(read("record.jsonl"), before);
    ASSERT_TRUE(editor.execute(command::Undo{}));  // there is space again
    EXPECT_EQ(read("record.jsonl"), before) << "a command is missing before this one";
    const std::string message = editor.workspace().message();
    EXPECT_EQ(message,
              "record.jsonl cannot be written any more: File too large. The record ends here.");
    EXPECT_EQ(replayed("record.jsonl").undo_count(), 1u);
    editor.workspace().dismiss();
    EXPECT_EQ(editor.workspace().message(), "");
}

TEST_F(RecorderTest, ARecordEndsBeforeOpeningAModelWhosePathItCannotHold) {
    write("caf\xe9.obj", kTetrahedron);
    auto editor = this->editor(Recorder(path("record.jsonl")));
    const std::string before = read("record.jsonl");
    ASSERT_TRUE(editor.execute(command::Open{path("caf\xe9.obj")}));
    ASSERT_TRUE(editor.execute(kFirst));
    EXPECT_EQ(read("record.jsonl"), before);
    EXPECT_EQ(editor.workspace().message(),
              "record.jsonl cannot hold this open command, because its path is not UTF-8. The "
              "record ends here.");
}

TEST_F(RecorderTest, ARecordIsWrittenBesideAnEarlierOne) {
    const std::string wanted = path("record.jsonl");
    { Recorder(wanted).record(kSphere); }
    const std::string first = read("record.jsonl");
    const Recorder second(wanted), third(wanted);
    EXPECT_EQ(second.path(), path("record-2.jsonl"));
    EXPECT_EQ(third.path(), path("record-3.jsonl"));
    EXPECT_EQ(read("record.jsonl"), first);
    write("empty.jsonl", "");
    EXPECT_EQ(Recorder(path("empty.jsonl")).path(), path("empty.jsonl"));
}

TEST_F(RecorderTest, OnlyOrdinaryFilesAreAcceptedForRecords) {
    ::mkfifo(path("pipe").c_str(), 0600);
    EXPECT_NE(error_of(path("pipe")).find("device or a pipe"), std::string::npos);
    EXPECT_NE(error_of("/dev/null").find("device or a pipe"), std::string::npos);
    EXPECT_NE(error_of(path("")).find("cannot be written"), std::string::npos);
    write("model.obj", "v 0 0 0\n");
    EXPECT_NE(error_of(path("model.obj")).find("is no record"), std::string::npos);
    EXPECT_EQ(read("model.obj"), "v 0 0 0\n");
}

}  // namespace
}  // namespace pectin
