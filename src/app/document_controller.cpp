#include "app/document_controller.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "app/command_kind.h"
#include "io/model_format.h"

namespace pectin {
namespace {

constexpr command::Shape kFirstObject{command::Shape::Kind::sphere, 4};

std::string absolute(const std::string& path) {
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::absolute(path, error);
    return error ? path : whole.lexically_normal().string();
}

}  // namespace

// --- Commands.

bool DocumentController::execute(const Command& command) {
    return !is_busy() && finish_command(command, workspace_.execute(command));
}

// Does what follows a command that has ended. Returns whether the command was done.
bool DocumentController::finish_command(const Command& command, Workspace::Outcome outcome) {
    if (outcome == Workspace::Outcome::in_progress) return false;
    const bool is_done = outcome == Workspace::Outcome::done;
    const std::optional<Question> next = std::exchange(next_, std::nullopt);
    if (is_done) delegate_.command_done(command);
    if (quits_next_) {
        continue_quitting();
    } else if (is_done && next) {
        do_without_asking(*next);
    } else if (is_any_of<command::Open>(command) && !has_object()) {
        execute_keeping_message(kFirstObject);
    }
    return is_done;
}

void DocumentController::execute_keeping_message(const Command& command) {
    const std::string message = workspace_.command_message();
    const Messages::Kind kind = workspace_.command_message_kind();
    execute(command);
    workspace_.set_message(message, kind);
}

void DocumentController::make_first_object() { execute(kFirstObject); }

// --- Opening and saving.

void DocumentController::perform(Action action) {
    if (is_busy()) return;
    switch (action) {
        case Action::open:
            show_browser(FileBrowser::Purpose::open, workspace_.path());
            break;
        case Action::save:
            begin_save(std::nullopt);
            break;
        case Action::save_as:
            show_browser(FileBrowser::Purpose::save, path_to_propose());
            break;
        case Action::save_picture:
            show_browser(
                FileBrowser::Purpose::save_picture,
                std::filesystem::path(workspace_.object_name()).replace_extension(".png").string());
            break;
        case Action::quit:
            quit();
            break;
        default:
            break;
    }
}

void DocumentController::open(const std::string& path) {
    ask_or_do({command::Open{.path = absolute(path)}});
}

void DocumentController::new_shape(command::Shape::Kind kind, int resolution) {
    ask_or_do({command::Shape{kind, resolution}});
}

void DocumentController::begin_example(Example example) { ask_or_do({example}); }

// The path that the dialog for saving begins with.
std::string DocumentController::path_to_propose() const {
    const std::string extension = writable_extensions().front();
    const std::string& path = workspace_.path();
    if (path.empty()) return workspace_.object_name() + extension;
    if (has_writable_format(path)) return path;
    return std::filesystem::path(path).replace_extension(extension).string();
}

// Asks for a path if the object has none, or one in a format that is only read.
// next: to be done once the save is done.
void DocumentController::begin_save(std::optional<Question> next) {
    if (has_writable_format(workspace_.path())) {
        save(workspace_.path(), std::move(next));
    } else {
        show_browser(FileBrowser::Purpose::save, path_to_propose());
        after_save_ = std::move(next);
    }
}

void DocumentController::save(const std::string& path, std::optional<Question> next) {
    if (is_busy()) return;
    next_ = std::move(next);
    execute(command::Save{path});
}

// --- The file browser.

void DocumentController::show_browser(FileBrowser::Purpose purpose, const std::string& path) {
    browser_.emplace(purpose, path);
}

void DocumentController::accept_file() {
    const std::string path = browser_->choose();
    if (path.empty()) return;
    const bool replaces = browser_->purpose() != FileBrowser::Purpose::open &&
                          path != workspace_.path() && FileBrowser::exists(path);
    if (replaces && path != file_to_replace_) {
        file_to_replace_ = path;
        return;
    }
    use_chosen_file(browser_->purpose(), path);
}

void DocumentController::use_chosen_file(FileBrowser::Purpose purpose, const std::string& path) {
    const std::optional<Question> next = std::exchange(after_save_, std::nullopt);
    close_browser();
    switch (purpose) {
        case FileBrowser::Purpose::open:
            open(path);
            break;
        case FileBrowser::Purpose::save:
            save(path, next);
            break;
        case FileBrowser::Purpose::save_picture:
            execute(delegate_.picture_command(path));
            break;
    }
}

void DocumentController::close_browser() {
    browser_.reset();
    enter_pressed_ = false;
    file_to_replace_.clear();
    after_save_.reset();
}

// --- The question whether to save changes, and quitting.

void DocumentController::ask_or_do(Question asked) {
    if (is_busy()) return;
    if (workspace_.is_modified()) {
        close_browser();
        question_ = std::move(asked);
    } else {
        do_without_asking(asked);
    }
}

void DocumentController::do_without_asking(const Question& asked) {
    close_browser();  // only one dialog may be open
    if (const auto* open = std::get_if<command::Open>(&asked.then)) {
        execute(*open);
    } else if (const auto* shape = std::get_if<command::Shape>(&asked.then)) {
        execute(*shape);
    } else if (const auto* example = std::get_if<Example>(&asked.then)) {
        delegate_.begin_example(*example);
    } else {
        wants_to_end_ = true;
    }
}

void DocumentController::answer(Answer answer) {
    const Question asked = *std::exchange(question_, std::nullopt);
    enter_pressed_ = false;
    if (answer == Answer::discard) do_without_asking(asked);
    if (answer == Answer::save) begin_save(asked);
}

void DocumentController::quit() {
    if (is_working()) {
        cancel_work();
        quits_next_ = true;
    } else {
        ask_or_do({Question::Quit{}});
    }
}

void DocumentController::continue_quitting() {
    if (std::exchange(quits_next_, false)) quit();
}

bool DocumentController::escape() {
    if (is_working()) {
        cancel_work();
    } else if (!file_to_replace_.empty()) {
        keep_file();
    } else if (offered_session()) {
        answer_recovery(RecoveryAnswer::later);
    } else if (question_) {
        answer(Answer::cancel);
    } else if (browser_) {
        close_browser();
    } else {
        return false;
    }
    return true;
}

// --- Work.

void DocumentController::advance() {
    if (restoration_) return continue_restoring();
    const EditTask* const edit = workspace_.edit_task();
    const Command command = edit ? *edit->command() : workspace_.file_task()->command;
    finish_command(command, workspace_.poll());
}

void DocumentController::cancel_work() {
    if (restoration_) {
        restoration_->cancel(workspace_);
    } else if (workspace_.is_working()) {
        workspace_.cancel_work();
    }
}

// --- Restoring.

void DocumentController::answer_recovery(RecoveryAnswer answer) {
    enter_pressed_ = false;
    if (answer == RecoveryAnswer::discard) {
        remove_lost_session(lost_sessions_.front());
        lost_sessions_.erase(lost_sessions_.begin());
        return;  // the next session is offered
    }
    std::vector<LostSession> sessions = std::exchange(lost_sessions_, {});
    if (answer == RecoveryAnswer::restore) restoration_.emplace(std::move(sessions.front()));
}

void DocumentController::continue_restoring() {
    const Restoration::State state = restoration_->advance(workspace_);
    if (state == Restoration::State::in_progress) return;
    const Restoration ended = std::move(*restoration_);
    restoration_.reset();
    const std::string message = end_restoring(ended, state);
    delegate_.restoration_ended();
    workspace_.set_message(message, state == Restoration::State::done ? Messages::Kind::information
                                                                      : Messages::Kind::warning);
    continue_quitting();
}

// Leaves an object in the window, and decides what becomes of the session's file. Returns the
// message for the user.
std::string DocumentController::end_restoring(const Restoration& ended, Restoration::State state) {
    if (state == Restoration::State::done) {
        remove_lost_session(ended.session());
        return "The session was restored. Save the object to keep it.";
    }
    const bool has_failed = state == Restoration::State::failed;
    const std::string error = workspace_.command_message();
    if (has_failed && has_object()) {
        // The next save must not replace the model's file by a part of the session.
        workspace_.clear_path();
        return "Restored up to step " + std::to_string(ended.commands_done()) + " of " +
               std::to_string(ended.command_count()) + ". " + error +
               " All steps are kept as a script in " + set_aside(ended.session().path) + ".";
    }
    make_first_object();
    return "The session was not restored. " + (has_failed ? error + " " : "") +
           "It is offered again at the next start.";
}

}  // namespace pectin
