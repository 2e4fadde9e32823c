#include "app/file_task.h"

#include <new>
#include <utility>

#include "app/fingerprint.h"
#include "io/file_error.h"
#include "session/model_file.h"

namespace pectin {
namespace {

// A copy that cannot be made does not prevent the save. Returns a warning then, or else nothing.
std::string make_copies(const std::vector<ModelCopy>& copies, const Progress& progress) {
    std::string warning;
    for (const ModelCopy& copy : copies) {
        try {
            make_copy(copy, progress);
        } catch (const FileError& error) {
            warning = std::string("this session can no longer be restored after a crash: ") +
                      error.what();
        }
    }
    return warning;
}

// Takes memory for the first drag while the file is being opened, if there is any.
LoadedModel prepared(LoadedModel model) {
    try {
        model.active->prepare_splits(kPreparedSplits);
    } catch (const std::bad_alloc&) {
        // The drag does so itself, if there is memory by then.
    }
    return model;
}

}  // namespace

FileWork open_work(const command::Open& open, bool with_fingerprint) {
    return [open, with_fingerprint](const Progress& progress) {
        const double fingerprint_time = with_fingerprint ? 0.1 : 0.0;  // fraction of the whole time
        FileResult result;
        // The fingerprint is taken first. If another program changes the file in between, the
        // fingerprint does not match the file later, so that the change is noticed.
        if (with_fingerprint) {
            result.fingerprint = fingerprint(open.path, progress.part(0.0, fingerprint_time));
        }
        result.model = prepared(load_model(open, progress.part(fingerprint_time, 1.0)));
        return result;
    };
}

FileWork reopen_work(const command::Open& open, const ModelCopy& copy) {
    return [open, copy](const Progress& progress) {
        // The model may be read from the copy because its file was replaced since then.
        return FileResult{.model = prepared(load_original(open, copy, progress)),
                          .fingerprint = copy.fingerprint,
                          .is_in_file = false};
    };
}

FileWork save_work(const command::Save& save, std::vector<ModelCopy> copies,
                   const Session& session) {
    return [save, copies = std::move(copies), &mesh = session.mesh(),
            folders = session.material_folders()](const Progress& progress) {
        const double copy_time = copies.empty() ? 0.0 : 0.2;  // fraction of the whole time
        FileResult result;
        result.warning = make_copies(copies, progress.part(0.0, copy_time));
        result.report = save_model(mesh, save, progress.part(copy_time, 1.0), folders);
        return result;
    };
}

}  // namespace pectin
