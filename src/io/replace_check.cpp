#include "io/replace_check.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>

#include "io/file_error.h"
#include "io/obj_keywords.h"
#include "io/obj_statements.h"
#include "io/open_file.h"
#include "io/printable.h"

namespace pectin {
namespace {

// As many bytes of a file as are read to tell its kind.
constexpr std::size_t kMaxBytes = std::size_t{16} << 20;

// Whether the beginning of a text has vertices and only OBJ statements. The last line, which may be
// incomplete, is ignored.
bool is_obj(std::string_view head) {
    std::size_t vertices = 0;
    ObjStatements statements(head.substr(0, head.rfind('\n')));
    while (statements.next()) {
        if (!is_obj_keyword(statements.keyword())) return false;
        if (statements.keyword() == "v") ++vertices;
    }
    return vertices > 0;
}

std::string describe_file(const FileKind& kind, std::string_view contents) {
    if (kind.is_known()) return std::string(kind.is);
    const std::string_view head = contents.substr(0, kSignatureBytes);
    if (is_obj(head)) return "is an OBJ model";
    const bool is_text = std::none_of(head.begin(), head.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 0x20 && c != '\n' && c != '\r' && c != '\t' && c != '\f';
    });
    return is_text ? "is a text file" : "is a file of another kind";
}

}  // namespace

void check_may_replace(const std::string& path, MayReplace may_replace, std::string_view writes) {
    FileAccess access;
    FileAnswer answer = access.ask(path);
    if (answer.error == ENOENT || answer.error == ENOTDIR) return;
    if (answer.error == 0 && !S_ISREG(answer.mode)) return;
    const OpenFile file = opened(path, std::move(answer));
    const std::string contents = access.read(file, path, 0, std::min(file.bytes, kMaxBytes));
    if (contents.empty()) return;
    const FileKind kind = recognise_file(contents, file.bytes);
    if (may_replace(kind, contents)) return;
    throw FileError(path, describe_file(kind, contents) + " and is not replaced; " +
                              std::string(writes) + ", so give it another name");
}

bool is_png(const FileKind& kind, std::string_view) { return kind.is == "is a PNG picture"; }

}  // namespace pectin
