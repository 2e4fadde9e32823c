#include "app/workspace.h"

#include <cctype>
#include <filesystem>

#include "app/execute.h"
#include "io/printable.h"
#include "session/input_summary.h"
#include "session/settings.h"

namespace pectin {
namespace {

const char* shape_name(command::Shape::Kind kind) {
    switch (kind) {
        case command::Shape::Kind::sphere:
            return "sphere";
        case command::Shape::Kind::cube:
            return "cube";
        case command::Shape::Kind::plane:
            return "plane";
        case command::Shape::Kind::torus:
            return "torus";
        case command::Shape::Kind::cylinder:
            return "cylinder";
    }
    return "untitled";
}

// A remark of the session as a sentence.
std::string sentence(std::string remark) {
    remark.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(remark.front())));
    return remark + ".";
}

using FileWork = std::function<Workspace::FileTask::Result(const Progress&)>;

// What a command does with a file while the session stays as it is; none for other commands.
FileWork file_work(const Command& command, const Session& session) {
    if (const auto* open = std::get_if<command::Open>(&command)) {
        return [open = *open](const Progress& progress) { return load_model(open, progress); };
    }
    const auto* save = std::get_if<command::Save>(&command);
    const TriMesh& mesh = session.mesh();
    if (!save || mesh.face_slots() == 0) return {};  // the session says what is missing
    return [save = *save, &mesh, folders = session.material_folders()](const Progress& progress) {
        return save_model(mesh, save, progress, folders).text;
    };
}

}  // namespace

Workspace::Outcome Workspace::execute(const Command& command) {
    if (file_task_) {
        tell("a file is under way; wait until it is done, or cancel it");
        return Outcome::failed;
    }
    const std::size_t step_number = session_.history().step_number();
    const auto complaint = complaint_about(command, session_, [&]() -> std::optional<std::string> {
        auto work = file_work(command, session_);
        if (!work) return session_.execute(command);
        file_task_ = std::make_unique<FileTask>(command, std::move(work));
        return std::nullopt;
    });
    if (complaint) {
        tell(*complaint);
        return Outcome::failed;
    }
    if (file_task_) return patience_.count() > 0 ? poll(patience_) : Outcome::under_way;
    if (session_.history().step_number() != step_number) is_modified_ = true;
    finish(command);
    if (!session_.remark().empty()) tell(sentence(session_.remark()));
    return Outcome::done;
}

Workspace::Outcome Workspace::execute_to_the_end(const Command& command) {
    Outcome outcome = execute(command);
    while (outcome == Outcome::under_way) outcome = poll(std::chrono::hours(1));
    return outcome;
}

Workspace::Outcome Workspace::poll(std::chrono::milliseconds longest_wait) {
    if (!file_task_->work.has_ended(longest_wait)) return Outcome::under_way;
    const std::unique_ptr<FileTask> task = std::move(file_task_);
    const bool is_cancelled = task->work.is_cancelled();
    std::string written;
    const auto complaint =
        complaint_about(task->command, session_, [&]() -> std::optional<std::string> {
            FileTask::Result result = task->work.take();
            auto* const model = std::get_if<LoadedModel>(&result);
            if (model && is_cancelled) throw Cancelled();
            if (model) {
                session_.adopt(std::move(*model));
            } else {
                written = std::move(std::get<std::string>(result));
            }
            return std::nullopt;
        });
    if (complaint) {
        if (!is_cancelled) tell(*complaint);
        return Outcome::failed;
    }
    finish(task->command);
    if (!written.empty()) tell(written);
    return Outcome::done;
}

void Workspace::tell(const std::string& message) { message_ = printable(message); }

// The command is done.
void Workspace::finish(const Command& command) {
    dismiss();
    note(command);
    if (const auto* open = std::get_if<command::Open>(&command)) {
        tell(input_summary(open->path, session_.input_report(), session_.read_report()));
    }
    record(command);
}

void Workspace::note_drag(const Command& drag, bool has_changed) {
    is_modified_ |= has_changed;
    record(drag);
}

void Workspace::record(const Command& command) {
    try {
        if (recorder_) recorder_->record(command);
    } catch (const std::exception& error) {
        tell(error.what());
    }
    try {
        if (recovery_) recovery_->record(command);
    } catch (const std::exception& error) {
        recovery_.reset();
        tell(std::string("This session is no longer kept for recovery: ") + error.what());
    }
}

void Workspace::begin_recovery(const std::string& folder) {
    try {
        recovery_.emplace(folder);
    } catch (const std::exception& error) {
        tell(error.what());
    }
}

void Workspace::end_recovery() {
    if (recovery_) recovery_->remove();
    recovery_.reset();
}

void Workspace::note(const Command& command) {
    const auto begin = [this](std::string path) {
        path_ = std::move(path);
        box_ = session_.mesh().bounding_box();
        diagonal_ = box_.diagonal();
        is_modified_ = false;
    };
    if (const auto* open = std::get_if<command::Open>(&command)) {
        begin(open->path);
    } else if (const auto* shape = std::get_if<command::Shape>(&command)) {
        begin({});
        shape_name_ = shape_name(shape->kind);
    } else if (const auto* save = std::get_if<command::Save>(&command)) {
        session_.note_saved(save->path);
        path_ = save->path;
        is_modified_ = false;
    }
}

std::string Workspace::object_name() const {
    return path_.empty() ? shape_name_ : std::filesystem::path(path_).filename().string();
}

double Workspace::radius() const {
    return session_.lattice_settings().radius.value_or(kAutoRadius * diagonal_);
}

}  // namespace pectin
