// What an Editor does with files: the dialogs about them, and what follows once a command is done.

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "app/command_kind.h"
#include "app/editor.h"
#include "io/model_format.h"

namespace pectin {
namespace {

std::string absolute(const std::string& path) {
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::absolute(path, error);
    return error ? path : whole.lexically_normal().string();
}

}  // namespace

// --- After a command.

// Does what follows a command that has ended. Returns whether the command was done.
bool Editor::finish_command(const Command& command, Workspace::Outcome outcome) {
    if (outcome == Workspace::Outcome::in_progress) return false;
    const bool is_done = outcome == Workspace::Outcome::done;
    const std::optional<Question> next = std::exchange(next_, std::nullopt);
    const bool opens = std::holds_alternative<command::Open>(command);
    if (is_done) update_after(command);
    if (std::exchange(quits_next_, false)) {
        quit();
    } else if (is_done && next) {
        do_without_asking(*next);
    } else if (opens && session().mesh().face_slots() == 0) {
        execute_keeping_message(kFirstObject);
    }
    return is_done;
}

void Editor::update_after(const Command& command) {
    hover_.reset();
    if (makes_object(command)) reset_for_new_object();
    if (is_any_of<command::Undo, command::Redo>(command)) figures_.folded = 0;
}

// Discards what belonged to the object before.
void Editor::reset_for_new_object() {
    figures_ = {};
    pins_.clear();
    frame_all(kFitDirection);
    reset_sizes();
    // The plane follows the centre of the new object.
    if (session().symmetry() && mirror_.through_centre) {
        execute_keeping_message(symmetry_command(true));
    }
}

// Sizes that were set for the object before may be wrong by orders of magnitude for this one.
void Editor::reset_sizes() {
    const LatticeSettings& lattice = session().lattice_settings();
    const double diagonal = workspace_.diagonal();
    if ((lattice.radius || lattice.cage) && diagonal > 0.0) {
        execute_keeping_message(command::Brush{.radius = kAutoRadius * diagonal});
    }
    const AdaptSettings& adapt = session().adapt_settings();
    command::Adapt change;
    if (adapt.l_max.kind == Setting::Kind::value) change.l_max = Setting::automatic();
    if (adapt.floor.kind == Setting::Kind::value) change.floor = Setting::automatic();
    if (change != command::Adapt{}) execute_keeping_message(change);
}

void Editor::execute_keeping_message(const Command& command) {
    const std::string message = workspace_.command_message();
    execute(command);
    workspace_.set_message(message);
}

// --- Opening and saving.

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
            begin_save(std::nullopt);
            break;
        case Action::save_as:
        case Action::export_obj:
            browser.emplace(FileBrowser::Purpose::save, path_to_propose());
            break;
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

// The path that the dialog for saving begins with.
std::string Editor::path_to_propose() const {
    const std::string extension = writable_extensions().front();
    const std::string& path = workspace_.path();
    if (path.empty()) return workspace_.object_name() + extension;
    if (has_writable_format(path)) return path;
    return std::filesystem::path(path).replace_extension(extension).string();
}

// Asks for a path if the object has none, or one in a format that is only read.
void Editor::begin_save(std::optional<Question> next) {
    if (has_writable_format(workspace_.path())) {
        save(workspace_.path(), std::move(next));
    } else {
        perform(Action::save_as);
        after_save_ = std::move(next);
    }
}

// next: to be done once the save is done.
void Editor::save(const std::string& path, std::optional<Question> next) {
    if (is_busy()) return;
    next_ = std::move(next);
    execute(command::Save{path});
}

void Editor::save_picture(const std::string& path) {
    execute(command::Screenshot{
        .path = path,
        .size = glm::clamp(size_, 16, 8192),
        .camera = camera(),
        .show = {
            .wireframe = display.wireframe, .lattice = display.lattice, .levels = display.levels}});
}

void Editor::cancel_work() {
    if (restoration_) {
        restoration_->cancel(workspace_);
    } else if (workspace_.is_working()) {
        workspace_.cancel_work();
    }
}

// --- The file browser.

void Editor::accept_file() {
    const std::string path = browser->choose();
    if (path.empty()) return;
    const bool replaces = browser->purpose() != FileBrowser::Purpose::open &&
                          path != workspace_.path() && FileBrowser::exists(path);
    if (replaces && path != file_to_replace_) {
        file_to_replace_ = path;
        return;
    }
    use_chosen_file(browser->purpose(), path);
}

void Editor::use_chosen_file(FileBrowser::Purpose purpose, const std::string& path) {
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
            save_picture(path);
            break;
    }
}

void Editor::close_browser() {
    browser.reset();
    enter_pressed_ = false;
    file_to_replace_.clear();
    after_save_.reset();
}

// --- The question whether to save changes.

void Editor::ask_or_do(Question asked) {
    if (is_busy()) return;
    if (workspace_.is_modified()) {
        close_browser();
        question = std::move(asked);
    } else {
        do_without_asking(asked);
    }
}

void Editor::do_without_asking(const Question& asked) {
    close_browser();  // only one dialog may be open
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
    enter_pressed_ = false;
    if (answer == Answer::discard) do_without_asking(asked);
    if (answer == Answer::save) begin_save(asked);
}

}  // namespace pectin
