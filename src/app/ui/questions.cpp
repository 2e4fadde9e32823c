#include "app/ui/questions.h"

#include <imgui.h>

#include <optional>
#include <string>

#include "app/ui/action_widgets.h"
#include "app/ui/file_panel.h"

namespace pectin {
namespace {

constexpr float kWidth = 460.0f;
constexpr float kButtonWidth = 120.0f;

// A button of a dialog. Returns whether it was pressed.
bool answer_button(const char* label, const char* help, float scale) {
    const bool is_pressed = ImGui::Button(label, ImVec2(kButtonWidth * scale, 0.0f));
    tooltip(label, help);
    return is_pressed;
}

void draw_save_question(Editor& editor, float scale) {
    using Answer = DocumentController::Answer;
    DocumentController& document = editor.document();
    const std::string title =
        "Save changes to " + editor.workspace().object_name() + "?###save question";
    if (!begin_dialog(document.question() != nullptr, title.c_str(), kWidth * scale, 0.0f)) return;
    ImGui::TextWrapped("Changes that are not saved will be lost.");
    ImGui::Spacing();
    std::optional<Answer> answer;
    if (answer_button("Save", "Save the changes and go on. (Enter)", scale) ||
        document.take_enter()) {
        answer = Answer::save;
    }
    ImGui::SameLine();
    if (answer_button("Don't save", "Go on and lose the changes.", scale)) {
        answer = Answer::discard;
    }
    ImGui::SameLine();
    if (answer_button("Cancel", "Go back to the object. (Esc)", scale)) answer = Answer::cancel;
    ImGui::EndPopup();
    if (answer) document.answer(*answer);
}

void draw_recovery_question(DocumentController& document, float scale) {
    using Answer = DocumentController::RecoveryAnswer;
    const LostSession* const session = document.offered_session();
    const std::string title =
        (session ? "Restore " + session->object + "?" : std::string()) + "###recovery question";
    if (!begin_dialog(session != nullptr, title.c_str(), kWidth * scale, 0.0f)) return;
    ImGui::TextWrapped("pectin ended unexpectedly before your changes were saved.");
    ImGui::Spacing();
    std::optional<Answer> answer;
    if (answer_button("Restore", "Bring back the object with its changes. (Enter)", scale) ||
        document.take_enter()) {
        answer = Answer::restore;
    }
    ImGui::SameLine();
    if (answer_button("Discard", "Delete these changes for good.", scale)) {
        answer = Answer::discard;
    }
    ImGui::SameLine();
    if (answer_button("Later", "Ask again at the next start. (Esc)", scale)) {
        answer = Answer::later;
    }
    ImGui::EndPopup();
    if (answer) document.answer_recovery(*answer);
}

}  // namespace

void draw_questions(Editor& editor, float scale) {
    draw_save_question(editor, scale);
    draw_recovery_question(editor.document(), scale);
}

}  // namespace pectin
