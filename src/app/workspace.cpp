#include "app/workspace.h"

#include <cctype>
#include <filesystem>
#include <utility>
#include <vector>

#include "app/execute.h"
#include "io/file_error.h"
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

// All settings as a new session has them, but for the brush's radius and the cage: commands can
// not say that there is none.
std::vector<Command> default_settings() {
    const AdaptSettings adapt;
    constexpr double kMegabyte = 1e6;
    return {command::Adapt{.enabled = adapt.enabled,
                           .theta_max = adapt.theta_max,
                           .theta_min = adapt.theta_min,
                           .l_max = adapt.l_max,
                           .flatness = adapt.flatness,
                           .floor = adapt.floor,
                           .budget = adapt.budget,
                           .propagation = adapt.propagation},
            command::Brush{.span = LatticeSettings{}.span}, command::Symmetry{},
            command::History{Setting::of(static_cast<double>(History::kDefaultLimit) / kMegabyte)}};
}

}  // namespace

// What a command does with a file while the session stays as it is; none for other commands.
Workspace::FileWork Workspace::file_work(const Command& command) const {
    if (const auto* open = std::get_if<command::Open>(&command)) return opening(*open);
    const auto* save = std::get_if<command::Save>(&command);
    // Where there is no object, the session says so.
    return save && session_.mesh().face_slots() > 0 ? saving(*save) : FileWork();
}

Workspace::FileWork Workspace::opening(const command::Open& open) const {
    return [open, is_kept = has_recovery()](const Progress& progress) {
        const double compared = is_kept ? 0.1 : 0.0;  // of the time that it takes
        FileTask::Result result;
        // First: a file that is changed now does not match its fingerprint later.
        if (is_kept) result.fingerprint = fingerprint(open.path, progress.part(0.0, compared));
        result.model = load_model(open, progress.part(compared, 1.0));
        return result;
    };
}

Workspace::FileWork Workspace::saving(const command::Save& save) const {
    std::vector<ModelCopy> copies;
    if (recovery_) copies = recovery_->copies_before_save(save.path);
    return [save, copies = std::move(copies), &mesh = session_.mesh(),
            folders = session_.material_folders()](const Progress& progress) {
        FileTask::Result result;
        const double copied = copies.empty() ? 0.0 : 0.2;  // of the time that it takes
        for (const ModelCopy& copy : copies) {
            try {
                make_copy(copy, progress.part(0.0, copied));
            } catch (const FileError& error) {
                result.warning =
                    std::string("this session can no longer be restored after a crash: ") +
                    error.what();
            }
        }
        result.report = save_model(mesh, save, progress.part(copied, 1.0), folders).text;
        return result;
    };
}

// make_work: gives the work that the command does on a file, if any.
template <typename MakeWork>
Workspace::Outcome Workspace::carry_out(const Command& command, MakeWork make_work) {
    if (file_task_) {
        set_message("a file is under way; wait until it is done, or cancel it");
        return Outcome::failed;
    }
    const std::size_t step_number = session_.history().step_number();
    const auto complaint = complaint_about(command, session_, [&]() -> std::optional<std::string> {
        FileWork work = make_work();
        if (!work) return session_.execute(command);
        file_task_ = std::make_unique<FileTask>(command, std::move(work));
        return std::nullopt;
    });
    if (complaint) {
        set_message(*complaint);
        return Outcome::failed;
    }
    if (file_task_) return patience_.count() > 0 ? poll(patience_) : Outcome::under_way;
    if (session_.history().step_number() != step_number) is_modified_ = true;
    finish(command);
    if (!session_.remark().empty()) set_message(sentence(session_.remark()));
    return Outcome::done;
}

Workspace::Outcome Workspace::execute(const Command& command) {
    return carry_out(command, [&] { return file_work(command); });
}

Workspace::Outcome Workspace::reopen(const command::Open& open, const LostSession& session,
                                     const std::string& fingerprint) {
    return carry_out(open, [&]() -> FileWork {
        const ModelCopy copy{
            .from = copy_path(session, open.path, fingerprint),
            .to = has_recovery() ? recovery_->copy_path(open.path, fingerprint) : "",
            .fingerprint = fingerprint};
        return [open, copy](const Progress& progress) {
            return FileTask::Result{.model = load_original(open, copy, progress),
                                    .fingerprint = copy.fingerprint};
        };
    });
}

Workspace::Outcome Workspace::poll(std::chrono::milliseconds longest_wait) {
    if (!file_task_->work.has_ended(longest_wait)) return Outcome::under_way;
    const std::unique_ptr<FileTask> task = std::move(file_task_);
    const bool is_cancelled = task->work.is_cancelled();
    FileTask::Result result;
    const auto complaint =
        complaint_about(task->command, session_, [&]() -> std::optional<std::string> {
            result = task->work.take();
            if (result.model && is_cancelled) throw Cancelled();
            if (result.model) session_.adopt(std::move(*result.model));
            return std::nullopt;
        });
    if (complaint) {
        if (!is_cancelled) set_message(*complaint);
        return Outcome::failed;
    }
    finish(task->command, result.fingerprint);
    if (!result.report.empty()) set_message(result.report);
    if (!result.warning.empty()) add_notice(sentence(result.warning));
    return Outcome::done;
}

void Workspace::begin_anew() {
    for (const Command& command : default_settings()) record(command);
    session_ = Session();
    session_.set_viewport(viewport_);
    path_.clear();
    shape_name_ = "untitled";
    is_modified_ = false;
}

void Workspace::pass_over(const command::Save& save) {
    update_file_state(save);
    keep(save);
}

void Workspace::set_viewport(Viewport* viewport) {
    viewport_ = viewport;
    session_.set_viewport(viewport);
}

void Workspace::set_message(const std::string& message) { command_message_ = printable(message); }

void Workspace::add_notice(const std::string& message) {
    notices_ += (notices_.empty() ? "" : "\n") + printable(message);
}

std::string Workspace::message() const {
    const bool are_both = !notices_.empty() && !command_message_.empty();
    return notices_ + (are_both ? "\n" : "") + command_message_;
}

void Workspace::dismiss() {
    command_message_.clear();
    notices_.clear();
}

// The command is done.
void Workspace::finish(const Command& command, const std::string& fingerprint) {
    clear_command_message();
    update_file_state(command);
    if (const auto* open = std::get_if<command::Open>(&command)) {
        set_message(input_summary(open->path, session_.input_report(), session_.read_report()));
    }
    record(command, fingerprint);
}

void Workspace::record_drag(const Command& drag, bool has_changed) {
    is_modified_ |= has_changed;
    record(drag);
}

void Workspace::record(const Command& command, const std::string& fingerprint) {
    try {
        if (recorder_) recorder_->record(command);
    } catch (const std::exception& error) {
        add_notice(error.what());
    }
    keep(command, fingerprint);
}

// For recovery.
void Workspace::keep(const Command& command, const std::string& fingerprint) {
    try {
        if (recovery_) recovery_->record(command, fingerprint);
    } catch (const std::exception& error) {
        add_notice(std::string("From now on this session is not kept for recovery: ") +
                   error.what());
    }
}

void Workspace::begin_recovery(const std::string& folder) {
    try {
        recovery_.emplace(folder);
    } catch (const std::exception& error) {
        add_notice(error.what());
    }
}

void Workspace::end_recovery() {
    if (recovery_) recovery_->remove();
    recovery_.reset();
}

void Workspace::update_file_state(const Command& command) {
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
        session_.record_saved(save->path);
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
