#include "app/ui/status_line.h"

#include <imgui.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "app/ui/action_widgets.h"
#include "app/ui/figure_text.h"
#include "app/ui/theme.h"

namespace pectin {
namespace {

constexpr const char* kSeparator = " · ";   // between the parts of a hint
constexpr float kGap = 22.0f;               // between figures
constexpr float kLabelGap = 6.0f;           // between a figure and its label
constexpr float kRowIndent = 90.0f;         // of the figures in a tooltip
constexpr float kLeastTextFraction = 0.4f;  // of the line, for the text on the left

// A figure with its label. What there is no space for is left out, the last ones first.
struct Figure {
    const char* label;
    std::string text;
    std::string widest;  // a text as wide as the figure gets, so that it does not move
    bool warns = false;
    const char* explanation = nullptr;  // of a notice
    void (*tooltip)(const Editor&, const PictureFigures&) = nullptr;
};

void tooltip_row(const char* what, const std::string& figure) {
    ImGui::TextDisabled("%s", what);
    ImGui::SameLine(kRowIndent * ImGui::GetFontSize() / 16.0f);
    ImGui::TextUnformatted(figure.c_str());
}

void frame_tooltip(const Editor& editor, const PictureFigures& figures) {
    const FrameFigures frame = editor.figures();
    ImGui::TextUnformatted("Time for the last frame of a drag");
    tooltip_row("deforming", formatted("%.1f ms", 1e3 * frame.deform_seconds));
    tooltip_row("splitting", formatted("%.1f ms", 1e3 * frame.refine_seconds));
    tooltip_row("merging", formatted("%.1f ms", 1e3 * frame.decimate_seconds));
    tooltip_row("uploaded", counted(figures.uploaded_bytes, "byte", "bytes") + " in " +
                                counted(figures.uploaded_ranges, "piece", "pieces"));
}

void memory_tooltip(const Editor& editor, const PictureFigures& figures) {
    const ObjectFigures object = editor.workspace().object_figures();
    ImGui::TextUnformatted("Memory");
    tooltip_row("program", megabytes(figures.memory_bytes));
    tooltip_row("undo", undo_memory(object));
    tooltip_row("steps", grouped(object.undo_steps) + " to undo, " + grouped(object.redo_steps) +
                             " to redo");
    if (object.lost_undo_steps > 0) {
        tooltip_row("dropped", grouped(object.lost_undo_steps) + " older");
    }
}

void changes_tooltip(const Editor&, const PictureFigures&) {
    ImGui::TextUnformatted("Edges split and triangles merged in the last frame of a drag");
}

void triangles_tooltip(const Editor& editor, const PictureFigures&) {
    const ObjectFigures object = editor.workspace().object_figures();
    ImGui::TextUnformatted(object.is_refined ? "Triangles of the object, as drags have refined it"
                                             : "Triangles of the object");
}

std::vector<Figure> figures_of(const Editor& editor, const PictureFigures& figures) {
    const FrameFigures frame = editor.figures();
    const ObjectFigures object = editor.workspace().object_figures();
    return {{.label = "Triangles",
             .text = grouped(object.faces),
             .widest = "8,888,888",
             .tooltip = triangles_tooltip},
            {.label = "Memory",
             .text = megabytes(figures.memory_bytes),
             .widest = "8,888 MB",
             .tooltip = memory_tooltip},
            {.label = "Frame",
             .text = formatted("%.1f ms", 1e3 * frame.seconds),
             .widest = "888.8 ms",
             .tooltip = frame_tooltip},
            {.label = "Split",
             .text = grouped(frame.splits) + ", merged " + grouped(frame.unsplits),
             .widest = "8,888, merged 8,888",
             .tooltip = changes_tooltip}};
}

// What there is to say of the present or the last drag.
std::vector<Figure> notices_of(const Editor& editor) {
    const FrameFigures frame = editor.figures();
    std::vector<Figure> notices;
    const auto add = [&](std::string text, const char* explanation, bool warns) {
        notices.push_back({.label = "",
                           .text = text,
                           .widest = text,
                           .warns = warns,
                           .explanation = explanation});
    };
    if (frame.steps > 1) {
        add(counted(frame.steps, "step", "steps"),
            "The drag is so long that it goes in steps, none of which folds the surface.", false);
    }
    if (frame.degrees != 0.0) add(formatted("twist %.0f°", frame.degrees), "", false);
    if (frame.scale != 1.0) add(formatted("scale %.2f", frame.scale), "", false);
    if (frame.folded > 0) {
        add(counted(frame.folded, "vertex folded", "vertices folded"),
            "The last drag turned the surface inside out there. Undo it, or drag with Fold-free.",
            true);
    }
    const Statistics::Error error = editor.workspace().object_figures().outcome.error;
    if (error.last) {
        add("Error " + formatted("%.2g", *error.last) +
                (error.total ? ", in all " + formatted("%.2g", *error.total) : ""),
            "The object is no farther than this from the exact surface, in its units: by the last "
            "drag, and by all drags together.",
            false);
    }
    if (frame.budget_hit) {
        add("Triangle budget used up",
            "The object has as many triangles as it may get. The budget stands in Detail, "
            "Advanced.",
            true);
    } else if (frame.drag_budget_hit) {
        add("Budget of the drag used up",
            "The last drag has added as many triangles as one drag may. The budget stands in "
            "Detail, Advanced.",
            true);
    } else if (frame.floor_hit) {
        add("Finest detail reached here",
            "Some edges are as short as they may get. The floor stands in Detail, Advanced.",
            false);
    }
    return notices;
}

float width_of(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

float width_of(const Figure& figure, float scale) {
    const float number = std::max(width_of(figure.text), width_of(figure.widest));
    return *figure.label == '\0' ? number : width_of(figure.label) + kLabelGap * scale + number;
}

// Begins a tooltip above the line, so that it stays visible.
void begin_tooltip() {
    const float left = ImGui::GetItemRectMin().x - ImGui::GetStyle().WindowPadding.x;
    const float bottom = ImGui::GetWindowPos().y - 0.25f * ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImVec2(left, bottom), ImGuiCond_Always, ImVec2(0.0f, 1.0f));
    ImGui::BeginTooltip();
}

// Draws a figure whose right edge is at `right`.
void draw_figure(const Figure& figure, float right, const Editor& editor,
                 const PictureFigures& picture, float scale) {
    ImGui::SameLine();
    ImGui::SetCursorPosX(right - width_of(figure, scale));
    ImGui::BeginGroup();
    if (*figure.label != '\0') {
        ImGui::TextDisabled("%s", figure.label);
        ImGui::SameLine(0.0f, kLabelGap * scale);
    }
    const bool is_faint = figure.explanation && !figure.warns;
    ImGui::TextColored(
        figure.warns ? theme_colour(ThemeColour::warning)
                     : ImGui::GetStyleColorVec4(is_faint ? ImGuiCol_TextDisabled : ImGuiCol_Text),
        "%s", figure.text.c_str());
    ImGui::EndGroup();
    const bool has_tooltip = figure.tooltip || (figure.explanation && *figure.explanation != '\0');
    if (!has_tooltip || !ImGui::IsItemHovered()) return;
    begin_tooltip();
    if (figure.tooltip) {
        figure.tooltip(editor, picture);
    } else {
        ImGui::TextUnformatted(figure.explanation);
    }
    ImGui::EndTooltip();
}

// Shortens the text so that it fits: parts after middle dots are left out first. No UTF-8 character
// is split.
std::string shortened(std::string text, float available) {
    for (std::size_t at = 0; width_of(text) > available; text.resize(at)) {
        at = text.rfind(kSeparator);
        if (at == text.npos) break;
    }
    if (width_of(text) <= available) return text;
    std::size_t length = text.size();
    while (length > 0) {
        --length;
        const bool splits = (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80;
        if (!splits && width_of(text.substr(0, length) + "…") <= available) break;
    }
    return text.substr(0, length) + "…";
}

// What the line says on the left.
std::string text_of(const Editor& editor) {
    if (editor.workspace().message_is_confirmation()) return editor.workspace().message();
    return std::string(editor.status_hint());
}

}  // namespace

void StatusLine::draw(const Editor& editor, const PictureFigures& picture, float scale) {
    const float gap = kGap * scale;
    const float text = width_of(text_of(editor));
    const float left = ImGui::GetStyle().WindowPadding.x;
    float right = ImGui::GetContentRegionMax().x;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("");
    const std::vector<Figure> notices = notices_of(editor);
    float for_notices = 0.0f;
    for (const Figure& notice : notices) for_notices += width_of(notice, scale) + gap;
    // The first figure and the notices stay as long as there is some space for the text.
    const float least_text = std::min(text, kLeastTextFraction * right);
    const auto draw_if_it_fits = [&](const Figure& figure, float before) {
        const float begin = right - width_of(figure, scale) - gap;
        if (begin < left + before) return;
        draw_figure(figure, right, editor, picture, scale);
        right = begin;
    };
    float before = least_text + for_notices;
    for (const Figure& figure : figures_of(editor, picture)) {
        draw_if_it_fits(figure, before);
        before = text + for_notices;
    }
    for (const Figure& notice : notices) draw_if_it_fits(notice, least_text);
    draw_text(editor, right);
}

void StatusLine::draw_text(const Editor& editor, float end) {
    const bool is_message = editor.workspace().message_is_confirmation();
    const std::string text = text_of(editor);
    const float left = ImGui::GetStyle().WindowPadding.x;
    const bool fits = width_of(text) <= end - left && text.find('\n') == text.npos;
    shows_message_ = is_message && fits;
    if (text.empty() || (is_message && !fits)) return;
    ImGui::SameLine();
    ImGui::SetCursorPosX(left);
    ImGui::TextColored(ImGui::GetStyleColorVec4(is_message ? ImGuiCol_Text : ImGuiCol_TextDisabled),
                       "%s", shortened(text, end - left).c_str());
}

}  // namespace pectin
