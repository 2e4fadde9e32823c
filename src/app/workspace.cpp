#include "app/workspace.h"

#include <filesystem>
#include <new>
#include <utility>

#include "app/default_settings.h"
#include "app/execute.h"
#include "app/words.h"
#include "session/input_summary.h"
#include "session/settings.h"

namespace pectin {
namespace {

// Whether a command has been done must not depend on whether the memory suffices for a message.
template <typename Tell>
void tell_if_possible(Tell tell) {
    try {
        tell();
    } catch (const std::bad_alloc&) {
    }
}

// Does the work. If it throws a FileError, the refusal is in the words of the window.
template <typename Work>
Done in_words(Work work) {
    try {
        return work();
    } catch (const FileError& error) {
        return Refusal{.reason = words_of(error), .kind = kInWords};
    }
}

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

}  // namespace

// --- Commands.

Workspace::Outcome Workspace::execute(const Command& command) {
    return run(command, [&] { return file_work(command); });
}

Workspace::Outcome Workspace::reopen(const command::Open& open, const LostSession& session,
                                     const std::string& fingerprint) {
    return run(open, [&] {
        return reopen_work(open, {.from = copy_path(session, open.path, fingerprint),
                                  .to = log_.copy_path(open.path, fingerprint),
                                  .fingerprint = fingerprint});
    });
}

// Returns the work on a file that the command needs; null if the session executes the command.
FileWork Workspace::file_work(const Command& command) const {
    if (const auto* open = std::get_if<command::Open>(&command)) {
        return open_work(*open, has_recovery());
    }
    const auto* save = std::get_if<command::Save>(&command);
    // Without an object there is nothing to save, and the session returns the error.
    const bool has_object = session_.mesh().face_slots() > 0;
    if (!save || !has_object) return {};
    return save_work(*save, log_.copies_before_save(save->path), session_);
}

// make_work: returns the work on a file that the command needs, or null.
template <typename MakeWork>
Workspace::Outcome Workspace::run(const Command& command, MakeWork make_work) {
    if (is_working()) {
        return fail({file_task_
                         ? "a file is still being read or written; wait until that is done, or "
                           "cancel it"
                         : "an edit is still in progress; wait until it is done, or cancel "
                           "it"});
    }
    if (is_edit(command)) return begin_edit(command);
    const Done done = try_command(command, session_, [&]() -> Done {
        return in_words([&]() -> Done {
            FileWork work = make_work();
            if (!work) return session_.execute(command);
            file_task_ = std::make_unique<FileTask>(command, std::move(work));
            return {};
        });
    });
    if (!done) return fail(done.refusal());
    if (file_task_) {
        return max_blocking_time_.count() > 0 ? poll(max_blocking_time_) : Outcome::in_progress;
    }
    finish(command);
    tell_if_possible([&] {
        if (!session_.remark().empty()) set_message(sentences(session_.remark()));
        if (const auto* picture = std::get_if<command::Screenshot>(&command)) {
            confirm_save(picture->path);
        }
    });
    return Outcome::done;
}

Workspace::Outcome Workspace::end_drag() { return begin_edit(); }

template <typename... Arguments>
Workspace::Outcome Workspace::begin_edit(const Arguments&... arguments) {
    has_moved_ = false;
    figures_before_edit_ = figures_now();
    const Done done = try_to("edit", session_, [&]() -> Done {
        edit_task_ = std::make_unique<EditTask>(session_, arguments...);
        return {};
    });
    return done ? poll(max_edit_time_) : fail(done.refusal());
}

Workspace::Outcome Workspace::poll(std::chrono::milliseconds longest_wait) {
    return file_task_ ? poll_file(longest_wait) : poll_edit(longest_wait);
}

void Workspace::cancel_work() {
    if (file_task_) file_task_->work.cancel();
    if (edit_task_) edit_task_->cancel();
}

Workspace::Outcome Workspace::poll_file(std::chrono::milliseconds longest_wait) {
    if (!file_task_->work.has_ended(longest_wait)) return Outcome::in_progress;
    const std::unique_ptr<FileTask> task = std::move(file_task_);
    const bool is_cancelled = task->work.is_cancelled();
    FileResult result;
    const Done done = try_command(task->command, session_, [&]() -> Done {
        return in_words([&]() -> Done {
            result = task->work.take();
            if (result.model && is_cancelled) throw Cancelled();
            if (result.model) session_.adopt(std::move(*result.model));
            return {};
        });
    });
    if (!done) return is_cancelled ? Outcome::failed : fail(done.refusal());
    finish(task->command, result.fingerprint);
    if (!result.is_in_file) set_saved_state(std::nullopt);
    tell_if_possible([&] {
        const auto* save = std::get_if<command::Save>(&task->command);
        if (save) confirm_save(save->path, result.report);
        if (!result.warning.empty()) add_notice(sentences(result.warning));
    });
    return Outcome::done;
}

Workspace::Outcome Workspace::poll_edit(std::chrono::milliseconds longest_wait) {
    if (!edit_task_->has_ended(longest_wait)) return Outcome::in_progress;
    const std::unique_ptr<EditTask> task = std::move(edit_task_);
    const std::string what = task->command() ? name(*task->command()) : "drag";
    EditResult result;
    bool is_stopped = false;
    const Done done = try_to(what, session_, [&]() -> Done {
        try {
            result = task->take();
        } catch (const Stopped&) {
            is_stopped = true;
        }
        return result.done;
    });
    update_modified();
    has_moved_ = result.drag.has_value();
    if (!done) return fail(done.refusal());
    if (is_stopped) return Outcome::failed;
    finish_edit(*task, result);
    return Outcome::done;
}

void Workspace::finish_edit(const EditTask& task, const EditResult& result) {
    if (result.drag) record(*result.drag);
    if (!task.command()) return;
    finish(*task.command());
    tell_if_possible([&] {
        if (!session_.remark().empty()) set_message(sentences(session_.remark()));
    });
}

// report: on the material files of a model.
void Workspace::confirm_save(const std::string& path, const SaveReport& report) {
    const std::string what = report.text.empty()
                                 ? std::filesystem::path(path).filename().string()
                                 : report.text;  // which begins with the name of the file
    messages_.set("Saved " + what + ".",
                  report.has_failed ? Messages::Kind::warning : Messages::Kind::confirmation);
}

Workspace::Outcome Workspace::fail(const Refusal& refusal) {
    set_message(words_of(refusal));
    return Outcome::failed;
}

// Updates everything else after the session has executed the command.
void Workspace::finish(const Command& command, const std::string& fingerprint) {
    clear_command_message();
    record(command, fingerprint);  // first, since memory may run out for the rest
    update_file_state(command);
    session_.prepare_for_drags();
    if (std::holds_alternative<command::Open>(command)) {
        tell_if_possible(
            [&] { report_input(input_findings(session_.input_report(), session_.read_report())); });
    }
}

// Tells what was found in a model that was opened.
void Workspace::report_input(const InputFindings& findings) {
    std::string text = sentences(findings.dropped);
    const auto add = [&text](const std::string& more) {
        if (!more.empty()) text += (text.empty() ? "" : " ") + more + ".";
    };
    if (!findings.repairs.empty()) add("Opened with repairs: " + findings.repairs);
    add(findings.kept);
    const bool is_changed = !findings.dropped.empty() || !findings.repairs.empty();
    if (text.empty()) return;
    messages_.set(text, is_changed ? Messages::Kind::warning : Messages::Kind::information);
}

// --- Session.

void Workspace::reset_session() {
    for (const Command& command : default_settings()) record(command);
    session_ = Session();
    session_.set_viewport(viewport_);
    session_.set_frame_time(frame_time_);
    path_.clear();
    shape_name_ = "untitled";
    set_saved_state(session_.history().state_id());
}

void Workspace::skip_save(const command::Save& save) {
    update_file_state(save);
    log_.record_for_recovery(save, {}, messages_);
}

void Workspace::clear_path() {
    path_.clear();
    set_saved_state(std::nullopt);
}

void Workspace::set_viewport(Viewport* viewport) {
    viewport_ = viewport;
    session_.set_viewport(viewport);
}

void Workspace::set_frame_time(std::chrono::milliseconds time) {
    frame_time_ = time;
    session_.set_frame_time(frame_time_);
}

void Workspace::limit_frame_time(bool is_shown) {
    if (!frame_time_) return;
    session_.set_frame_time(is_shown ? *frame_time_ : std::chrono::milliseconds(0));
}

// --- Object.

ObjectFigures Workspace::object_figures() const {
    return edit_task_ ? figures_before_edit_ : figures_now();
}

ObjectFigures Workspace::figures_now() const {
    const TriMesh& mesh = session_.mesh();
    const History& history = session_.history();
    return {.faces = mesh.face_count(),
            .is_refined = mesh.vertex_count() > mesh.base_vertex_count(),
            .outcome = session_.outcome(),
            .undo_steps = history.undo_count(),
            .redo_steps = history.redo_count(),
            .lost_undo_steps = history.lost_undo_count(),
            .undo_bytes = history.memory_bytes(),
            .undo_limit = history.limit()};
}

void Workspace::begin_object(std::string path) {
    path_ = std::move(path);
    box_ = session_.mesh().bounding_box();
    diagonal_ = box_.diagonal();
    set_saved_state(session_.history().state_id());
}

void Workspace::set_saved_state(std::optional<std::uint64_t> state) {
    saved_state_ = state;
    update_modified();
}

// Precondition: no edit is in progress.
void Workspace::update_modified() { is_modified_ = session_.history().state_id() != saved_state_; }

void Workspace::update_file_state(const Command& command) {
    if (const auto* open = std::get_if<command::Open>(&command)) {
        begin_object(open->path);
    } else if (const auto* shape = std::get_if<command::Shape>(&command)) {
        begin_object({});
        shape_name_ = shape_name(shape->kind);
    } else if (const auto* save = std::get_if<command::Save>(&command)) {
        session_.record_saved(save->path);
        path_ = save->path;
        set_saved_state(session_.history().state_id());
    }
}

std::string Workspace::object_name() const {
    return path_.empty() ? shape_name_ : std::filesystem::path(path_).filename().string();
}

double Workspace::radius() const {
    return session_.lattice_settings().radius.value_or(kAutoRadius * diagonal_);
}

}  // namespace pectin
