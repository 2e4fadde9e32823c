// What an Editor does with files: the dialogs about them, and what follows once one is done.
#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/editor.h"
#include "app/picture.h"
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

// What follows a command once it is no longer under way. Returns whether it is done.
bool Editor::conclude(const Command& command, Workspace::Outcome outcome) {
    if (outcome == Workspace::Outcome::under_way) return false;
    const bool is_done = outcome == Workspace::Outcome::done;
    const std::optional<Question> next = std::exchange(next_, std::nullopt);
    if (is_done) hover_.reset();
    if (is_done && (std::holds_alternative<command::Open>(command) ||
                    std::holds_alternative<command::Shape>(command))) {
        begin_object();
    }
    const bool was_taken_back = std::holds_alternative<command::Undo>(command) ||
                                std::holds_alternative<command::Redo>(command);
    if (is_done && was_taken_back) figures_.folded = 0;
    if (std::exchange(quits_next_, false)) {
        quit();
    } else if (is_done && next) {
        carry_out(*next);
    } else if (std::holds_alternative<command::Open>(command) &&
               session().mesh().face_slots() == 0) {
        // Whatever is told of the model stays to be read.
        const std::string message = workspace_.command_message();
        execute(kFirstObject);
        workspace_.set_message(message);
    }
    return is_done;
}

// Another object: what was set for the one before means nothing.
void Editor::begin_object() {
    figures_ = {};
    pins_.clear();
    frame_all(kFitDirection);
    if (!session().symmetry() || !mirror_.through_centre) return;
    const std::string message = workspace_.command_message();
    set_symmetry(true);
    workspace_.set_message(message);
}

void Editor::begin(const std::string& model) {
    if (model.empty()) {
        execute(kFirstObject);
        set_symmetry(true);
    } else {
        open(model);
    }
}

void Editor::perform_on_file(Action action) {
    switch (action) {
        case Action::open:
            browser.emplace(FileBrowser::Purpose::open, workspace_.path());
            break;
        case Action::save:
            begin_save();
            break;
        case Action::save_as:
        case Action::export_obj: {
            const std::string& path = workspace_.path();
            browser.emplace(
                FileBrowser::Purpose::save,
                path.empty() ? workspace_.object_name() + writable_extensions().front() : path);
            break;
        }
        case Action::save_picture:
            browser.emplace(
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

void Editor::open(const std::string& path) { ask_or_do({command::Open{.path = absolute(path)}}); }

void Editor::begin_save() {
    if (workspace_.path().empty()) {
        perform(Action::save_as);
    } else {
        save(workspace_.path(), std::nullopt);
    }
}

void Editor::save(const std::string& path, std::optional<Question> next) {
    if (is_busy()) return;
    next_ = std::move(next);
    execute(command::Save{path});
}

void Editor::accept_file() {
    const std::string path = browser->choose();
    if (path.empty()) return;
    const bool replaces = browser->purpose() != FileBrowser::Purpose::open &&
                          path != workspace_.path() && FileBrowser::exists(path);
    if (replaces && path != file_to_replace_) {
        file_to_replace_ = path;
        return;
    }
    use_file(browser->purpose(), path);
}

void Editor::use_file(FileBrowser::Purpose purpose, const std::string& path) {
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
            execute(command::Screenshot{.path = path,
                                        .width = std::clamp(size_.x, 16, 8192),
                                        .height = std::clamp(size_.y, 16, 8192),
                                        .camera = camera(),
                                        .show = {.wireframe = display.wireframe,
                                                 .lattice = display.lattice,
                                                 .levels = display.levels}});
            break;
    }
}

void Editor::close_browser() {
    browser.reset();
    enter_ = false;
    file_to_replace_.clear();
    after_save_.reset();
}

void Editor::ask_or_do(Question asked) {
    if (is_busy()) return;
    if (workspace_.is_modified()) {
        close_browser();
        question = std::move(asked);
    } else {
        carry_out(asked);
    }
}

void Editor::carry_out(const Question& asked) {
    close_browser();  // one dialog at a time
    if (const auto* open = std::get_if<command::Open>(&asked.then)) {
        execute(*open);
    } else if (const auto* shape = std::get_if<command::Shape>(&asked.then)) {
        execute(*shape);
    } else {
        wants_to_end_ = true;
    }
}

void Editor::answer(Answer answer) {
    const Question asked = *std::exchange(question, std::nullopt);
    enter_ = false;
    if (answer == Answer::discard) carry_out(asked);
    if (answer != Answer::save) return;
    if (workspace_.path().empty()) {
        perform(Action::save_as);
        after_save_ = asked;
    } else {
        save(workspace_.path(), asked);
    }
}

void Editor::answer_recovery(RecoveryAnswer answer) {
    enter_ = false;
    if (answer == RecoveryAnswer::discard) {
        remove_lost_session(lost_sessions_.front());
        lost_sessions_.erase(lost_sessions_.begin());
        return;  // to the next one
    }
    std::vector<LostSession> sessions = std::exchange(lost_sessions_, {});
    if (answer == RecoveryAnswer::restore) restoration_.emplace(std::move(sessions.front()));
}

void Editor::go_on_restoring() {
    const Restoration::State state = restoration_->advance(workspace_);
    if (state == Restoration::State::under_way) return;
    const Restoration ended = std::move(*restoration_);
    restoration_.reset();
    const bool has_object = session().mesh().face_slots() > 0;
    std::string message;
    if (state == Restoration::State::done) {
        remove_lost_session(ended.session());
        message = "Restored. Save the object to keep it.";
    } else if (state == Restoration::State::failed && has_object) {
        // A part of the session must not take the place of the whole in the model's file.
        workspace_.forget_path();
        message = "Restored up to command " + std::to_string(ended.done()) + " of " +
                  std::to_string(ended.count()) + ": " + workspace_.command_message() +
                  ". The whole script is in " + set_aside(ended.session().path) + ".";
    } else {
        const std::string why =
            state == Restoration::State::failed ? ": " + workspace_.command_message() : "";
        execute(kFirstObject);
        message = "The session was not restored" + why + ". It is offered again at the next start.";
    }
    figures_ = {};
    pins_.clear();
    frame_all(kFitDirection);
    workspace_.set_message(message);
    if (std::exchange(quits_next_, false)) quit();
}

void Editor::cancel_work() {
    if (restoration_) {
        restoration_->cancel(workspace_);
    } else if (workspace_.file_task()) {
        workspace_.cancel_file_task();
    }
}

}  // namespace pectin
