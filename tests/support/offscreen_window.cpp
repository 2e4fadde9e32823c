#include "support/offscreen_window.h"

#include <imgui.h>

#include <cctype>
#include <cmath>
#include <map>
#include <utility>

#include "app/editor_scene.h"
#include "app/object_view.h"
#include "render/imgui_renderer.h"

namespace pectin::test {
namespace {

constexpr int kPullSteps = 6, kSettlingFrames = 4;

std::string utf8(unsigned int code) {
    if (code < 0x80) return {static_cast<char>(code)};
    if (code < 0x800) {
        return {static_cast<char>(0xC0 | (code >> 6)), static_cast<char>(0x80 | (code & 0x3F))};
    }
    return {static_cast<char>(0xE0 | (code >> 12)), static_cast<char>(0x80 | ((code >> 6) & 0x3F)),
            static_cast<char>(0x80 | (code & 0x3F))};
}

// The glyphs of all fonts by the place of their upper left corner in the texture.
struct Letter {
    const ImFont* font;
    const ImFontGlyph* glyph;
};
using Letters = std::map<std::pair<float, float>, Letter>;

Letters letters_of(const ImFontAtlas& atlas) {
    Letters letters;
    for (const ImFont* font : atlas.Fonts) {
        for (const ImFontGlyph& glyph : font->Glyphs) {
            if (glyph.Visible) letters.insert({{glyph.U0, glyph.V0}, {font, &glyph}});
        }
    }
    return letters;
}

// Dear ImGui draws each letter as two triangles over four vertices, the first of which is its upper
// left corner. This reads them back.
class TextReader {
  public:
    explicit TextReader(const ImFontAtlas& atlas) : letters_(letters_of(atlas)) {}

    void read(const ImDrawList& list) {
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.UserCallback) continue;
            const auto* const indices = list.IdxBuffer.Data + command.IdxOffset;
            for (unsigned int i = 0; i + 6 <= command.ElemCount;) {
                const auto first = command.VtxOffset + indices[i];
                i += add_letter(list.VtxBuffer.Data + first, command.ClipRect,
                                static_cast<int>(first) + 3 < list.VtxBuffer.Size)
                         ? 6
                         : 3;
            }
            finish();
        }
        finish();
    }
    std::vector<ScreenText> take() { return std::move(found_); }

  private:
    // Returns whether there is a letter.
    bool add_letter(const ImDrawVert* corner, const ImVec4& clip, bool has_four) {
        if (!has_four) return false;
        const auto letter = letters_.find({corner[0].uv.x, corner[0].uv.y});
        if (letter == letters_.end() || corner[2].uv.x != letter->second.glyph->U1) return false;
        const auto& [font, glyph] = letter->second;
        const float scale = (corner[2].pos.y - corner[0].pos.y) / (glyph->Y1 - glyph->Y0);
        const float pen = corner[0].pos.x - scale * glyph->X0;
        const float top = corner[0].pos.y - scale * glyph->Y0;
        const float x = 0.5f * (corner[0].pos.x + corner[2].pos.x);
        const float y = 0.5f * (corner[0].pos.y + corner[2].pos.y);
        if (x < clip.x || x > clip.z || y < clip.y || y > clip.w) return true;  // not visible
        const float space = scale * font->FindGlyph(' ')->AdvanceX;
        const float gap = pen - pen_;
        const bool goes_on = !line_.text.empty() && std::abs(top - top_) < 0.5f &&
                             gap > -0.5f * space && gap < 2.5f * space;
        if (!goes_on) finish();
        if (goes_on && gap > 0.5f * space) line_.text += ' ';
        if (line_.text.empty()) line_.min = {pen, top};
        line_.text += utf8(glyph->Codepoint);
        pen_ = pen + scale * glyph->AdvanceX;
        top_ = top;
        line_.max = {pen_, top + scale * font->FontSize};
        return true;
    }
    void finish() {
        if (!line_.text.empty()) found_.push_back(line_);
        line_ = {};
    }

    Letters letters_;
    ScreenText line_;
    float pen_ = 0.0f, top_ = 0.0f;  // where the next letter would be
    std::vector<ScreenText> found_;
};

}  // namespace

OffscreenWindow::OffscreenWindow() : OffscreenWindow(Options{}) {}

OffscreenWindow::OffscreenWindow(const Options& options)
    : size_(options.size),
      scale_(options.scale),
      editor_(std::make_unique<Editor>(std::nullopt, options.max_blocking_time)),
      interface_(std::make_unique<Interface>(
          options.scale, Clipboard{.read = [this] { return clipboard_; },
                                   .write = [this](const std::string& t) { clipboard_ = t; }})) {
    resize(options.size);
    editor_->document().new_shape(command::Shape::Kind::sphere, options.resolution);
    editor_->set_symmetry(true);
    settle();
}

OffscreenWindow::~OffscreenWindow() = default;

void OffscreenWindow::give(const InputEvent& input) {
    interface_->handle(*editor_, input);
    frame();
}

void OffscreenWindow::move(const Vec2& at, Modifiers modifiers) {
    give(event::MouseMove{at, modifiers});
}
void OffscreenWindow::press(const Vec2& at, Modifiers modifiers, MouseButton button) {
    move(at, modifiers);
    give(event::Press{button, at, modifiers});
}
void OffscreenWindow::release(const Vec2& at, Modifiers modifiers, MouseButton button) {
    give(event::Release{button, at, modifiers});
}
void OffscreenWindow::click(const Vec2& at, Modifiers modifiers) {
    press(at, modifiers);
    release(at, modifiers);
}
void OffscreenWindow::pull(const Vec2& from, const Vec2& to, Modifiers modifiers,
                           MouseButton button) {
    press(from, modifiers, button);
    for (int i = 1; i <= kPullSteps; ++i) {
        move(glm::mix(from, to, static_cast<double>(i) / kPullSteps), modifiers);
    }
}
void OffscreenWindow::drag(const Vec2& from, const Vec2& to, Modifiers modifiers,
                           MouseButton button) {
    pull(from, to, modifiers, button);
    release(to, modifiers, button);
}
void OffscreenWindow::scroll(const Vec2& at, double notches) { give(event::Scroll{notches, at}); }

void OffscreenWindow::key(Key key, Modifiers modifiers) {
    give(event::KeyDown{key, modifiers});
    give(event::KeyUp{key});
}

void OffscreenWindow::type(const std::string& text) {
    for (const char c : text) {
        const Key key{std::toupper(static_cast<unsigned char>(c))};
        give(event::KeyDown{key});
        give(event::Character{static_cast<unsigned char>(c)});
        give(event::KeyUp{key});
    }
}

void OffscreenWindow::resize(const IVec2& size) {
    size_ = size;
    interface_->set_size(size, size);
    interface_->handle(*editor_, event::Resize{size});
    frame();
}

void OffscreenWindow::frame() {
    if (editor_->document().wants_to_end()) return;
    editor_->advance();
    interface_->set_size(size_, size_);
    interface_->lay_out(*editor_, {});
}

void OffscreenWindow::settle() {
    for (int i = 0; i < kSettlingFrames; ++i) frame();
}

std::vector<ScreenText> OffscreenWindow::texts() const {
    TextReader reader(*ImGui::GetIO().Fonts);
    const ImDrawData& data = interface_->draw_data();
    for (int i = 0; i < data.CmdListsCount; ++i) reader.read(*data.CmdLists[i]);
    return reader.take();
}

std::optional<Vec2> OffscreenWindow::find(const std::string& text) const {
    std::optional<Vec2> whole, part;
    for (const ScreenText& found : texts()) {
        if (found.text == text) whole = found.centre();
        if (found.text.find(text) != std::string::npos) part = found.centre();
    }
    return whole ? whole : part;
}

bool OffscreenWindow::click(const std::string& text) {
    const std::optional<Vec2> at = find(text);
    if (at) click(*at);
    if (at) settle();
    return at.has_value();
}

bool OffscreenWindow::hover(const std::string& text) {
    const std::optional<Vec2> at = find(text);
    if (at) move(*at);
    if (at) settle();
    return at.has_value();
}

// --- Pictures.

struct WindowPainter::Parts {
    explicit Parts(const Gl& context)
        : gl(&context),
          renderer(context),
          panels(context, *ImGui::GetIO().Fonts),
          object(context) {}

    const Gl* gl;
    Renderer renderer;
    ImGuiRenderer panels;
    ObjectView object;
};

WindowPainter::WindowPainter(const Gl& gl, OffscreenWindow& window)
    : window_(window), parts_(std::make_unique<Parts>(gl)) {}
WindowPainter::~WindowPainter() = default;

Image WindowPainter::draw() {
    Editor& editor = window_.editor();
    const bool can_read = !editor.workspace().edit_task();
    if (can_read) parts_->object.update(editor.workspace().session());
    const Canvas canvas(*parts_->gl, window_.size());
    parts_->renderer.draw(parts_->object.mesh(), editor_scene(editor, window_.scale()), canvas);
    parts_->panels.draw(window_.interface().draw_data(), canvas);
    canvas.resolve();
    return canvas.read();
}

}  // namespace pectin::test
