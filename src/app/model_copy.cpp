#include "app/model_copy.h"

#include <filesystem>
#include <string_view>
#include <system_error>

#include "app/fingerprint.h"
#include "io/atomic_file.h"
#include "io/file_error.h"

namespace pectin {

void make_copy(const ModelCopy& copy, const Progress& progress) {
    // Only the owner may read the copy, since that may be so for the original, too. The empty file
    // has these permissions, and AtomicFile keeps them.
    FileDescriptor(copy.to.c_str(), O_WRONLY | O_CREAT, 0600).close();
    try {
        AtomicFile file(copy.to);
        const std::string found = fingerprint(
            copy.from, progress, [&file](std::string_view bytes) { file.write(bytes); });
        if (found != copy.fingerprint) {
            throw FileError(copy.from, "was changed by another program after it was opened");
        }
        file.commit();
    } catch (...) {
        ::unlink(copy.to.c_str());
        throw;
    }
}

namespace {

// Makes copy.to a hard link to copy.from, since neither file is ever changed. Where links are not
// possible, the contents are copied.
void link_or_copy(const ModelCopy& copy) {
    std::error_code error;
    std::filesystem::create_hard_link(copy.from, copy.to, error);
    if (error) make_copy(copy);
}

}  // namespace

LoadedModel load_original(const command::Open& open, const ModelCopy& copy,
                          const Progress& progress) {
    constexpr double kFingerprintTime = 0.1;  // fraction of the whole time
    const Progress comparing = progress.part(0.0, kFingerprintTime);
    std::error_code ignored;
    const bool has_copy = std::filesystem::file_size(copy.from, ignored) > 0 && !ignored &&
                          fingerprint(copy.from, comparing) == copy.fingerprint;
    if (!has_copy && fingerprint(open.path, comparing) != copy.fingerprint) {
        throw FileError(open.path,
                        "was changed after the session had opened it; put the earlier file back "
                        "to restore the session");
    }
    LoadedModel model =
        load_model({.path = has_copy ? copy.from : open.path, .crease_angle = open.crease_angle},
                   progress.part(kFingerprintTime, 1.0));
    model.material_folders = {material_folder(open.path)};
    if (has_copy && !copy.to.empty()) link_or_copy(copy);
    return model;
}

}  // namespace pectin
