#include "app/workspace.h"

#include <filesystem>

#include "app/execute.h"
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

}  // namespace

bool Workspace::execute(const Command& command) {
    const std::size_t undo_count = session_.undo_count();
    if (const auto refusal = pectin::execute(session_, command)) {
        tell(*refusal);
        return false;
    }
    dismiss();
    if (session_.undo_count() != undo_count) is_modified_ = true;
    note(command);
    record(command);
    return true;
}

void Workspace::note_drag(const command::Drag& drag, bool has_changed) {
    is_modified_ |= has_changed;
    record(drag);
}

void Workspace::record(const Command& command) {
    if (!recorder_) return;
    try {
        recorder_->record(command);
    } catch (const std::exception& error) {
        tell(error.what());
    }
}

void Workspace::note(const Command& command) {
    const auto begin = [this](std::string path) {
        path_ = std::move(path);
        diagonal_ = session_.mesh().bounding_box().diagonal();
        is_modified_ = false;
    };
    if (const auto* open = std::get_if<command::Open>(&command)) {
        begin(open->path);
    } else if (const auto* shape = std::get_if<command::Shape>(&command)) {
        begin({});
        shape_name_ = shape_name(shape->kind);
    } else if (const auto* save = std::get_if<command::Save>(&command)) {
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
