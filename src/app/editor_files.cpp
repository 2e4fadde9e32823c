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
        const std::string message = workspace_.message();
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
    const std::string message = workspace_.message();
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
    const std::vector<LostSession> sessions = std::exchange(lost_sessions_, {});
    if (answer == RecoveryAnswer::restore) restore(sessions.front());
}

// Does again all that was done. If a command fails, the file stays for the user, under a name that
// is not offered again.
void Editor::restore(const LostSession& session) {
    std::size_t done = 0;
    for (const Command& command : session.commands) {
        if (is_restored(command) &&
            workspace_.execute_to_the_end(command) != Workspace::Outcome::done) {
            break;
        }
        ++done;
    }
    begin_object();
    const std::string why = workspace_.message();
    if (done == session.commands.size()) {
        remove_lost_session(session);
        workspace_.set_message("Restored. Save the object to keep it.");
        return;
    }
    std::error_code ignored;
    const std::string kept = session.path + ".incomplete";
    std::filesystem::rename(session.path, kept, ignored);
    workspace_.set_message("Restored up to command " + std::to_string(done) + " of " +
                           std::to_string(session.commands.size()) + ": " + why +
                           ". The whole script is in " + kept + ".");
}

}  // namespace pectin
