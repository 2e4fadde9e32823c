#include "app/window.h"

#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <optional>

#include "app/editor.h"
#include "app/editor_scene.h"
#include "app/object_view.h"
#include "app/panels.h"
#include "app/theme.h"
#include "app/window_host.h"
#include "app/window_viewport.h"
#include "render/imgui_renderer.h"

namespace pectin {
namespace {

constexpr IVec2 kFirstSize{1280, 800};
// Frames that panels need to come to rest after an event.
constexpr int kSettlingFrames = 3;
// Seconds to wait for events, where nothing is to be drawn: not for ever, in case the driver, which
// reads from the same connection while drawing, has taken an event from there already.
constexpr double kLongestWait = 0.1;
// And between frames that show how far a file is: what draws faster takes from what works on it.
constexpr double kProgressWait = 1.0 / 15.0;

// Dear ImGui's context, fed by the host's window.
class Interface {
  public:
    explicit Interface(const WindowHost& host) {
        IMGUI_CHECKVERSION();
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.ConfigInputTextCursorBlink = false;  // so that the program may rest
        apply_theme(host.content_scale());
        ImGui_ImplGlfw_InitForOpenGL(host.handle(), true);
    }
    ~Interface() {
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
    }
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;
};

// Of the whole program, as the system sees it; 0 where it does not say.
std::size_t resident_bytes() {
    std::ifstream file("/proc/self/statm");
    std::size_t all = 0, resident = 0;
    file >> all >> resident;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

class Window {
  public:
    explicit Window(const WindowOptions& options)
        : editor_(options.record.empty() ? std::nullopt : std::optional<Recorder>(options.record)),
          host_("pectin", kFirstSize),
          interface_(host_),
          panels_(host_.content_scale()),
          renderer_(host_.gl()),
          panel_renderer_(host_.gl(), *ImGui::GetIO().Fonts),
          object_(host_.gl()),
          viewport_(host_.gl(), renderer_, object_) {
        editor_.workspace().session().set_viewport(&viewport_);
        editor_.handle(event::Resize{host_.size()});
        editor_.begin(options.model);
    }

    void run() {
        while (!editor_.wants_to_end()) {
            take_input();
            if (frames_to_draw_ == 0) continue;
            --frames_to_draw_;
            editor_.advance();
            lay_out_panels();
            follow_object();
            draw();
            host_.show();
        }
    }

  private:
    void take_input() {
        const bool shows_progress = editor_.workspace().file_task() != nullptr;
        const double rest = frames_to_draw_ == 0 ? kLongestWait : 0.0;
        const std::vector<InputEvent> events =
            host_.take_events(shows_progress ? kProgressWait : rest);
        if (!events.empty() || shows_progress) frames_to_draw_ = kSettlingFrames;
        for (const InputEvent& event : events) {
            if (const auto* move = std::get_if<event::Move>(&event)) cursor_ = move->at;
            editor_.handle(event, panels_.claims(cursor_));
        }
    }

    void lay_out_panels() {
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        figures_.memory_bytes = resident_bytes();
        panels_.draw(editor_, figures_);
        ImGui::Render();
        const Workspace& workspace = editor_.workspace();
        host_.set_title((workspace.is_modified() ? "*" : "") + workspace.object_name() +
                        " — pectin");
    }

    void follow_object() {
        const GpuMesh::Upload upload = object_.follow(editor_.workspace().session());
        if (upload.bytes == 0) return;
        figures_.uploaded_bytes = upload.bytes;
        figures_.uploaded_ranges = upload.ranges;
    }

    void draw() {
        const IVec2 size = host_.framebuffer_size();
        if (size.x <= 0 || size.y <= 0) return;
        if (!canvas_ || canvas_->size() != size) {
            canvas_.reset();
            canvas_ = std::make_unique<Canvas>(host_.gl(), size);
        }
        renderer_.draw(object_.mesh(), editor_scene(editor_, pixel_scale()), *canvas_);
        panel_renderer_.draw(*ImGui::GetDrawData(), *canvas_);
        canvas_->resolve();
        canvas_->blit_to(0);
    }

    float pixel_scale() const {
        const auto ratio = static_cast<float>(host_.framebuffer_size().x) /
                           static_cast<float>(std::max(host_.size().x, 1));
        return ratio * host_.content_scale();
    }

    // Before the host, so that a record that cannot be written opens no window.
    Editor editor_;
    WindowHost host_;
    Interface interface_;
    Panels panels_;
    Renderer renderer_;
    ImGuiRenderer panel_renderer_;
    ObjectView object_;
    WindowViewport viewport_;
    std::unique_ptr<Canvas> canvas_;  // as large as the window
    PictureFigures figures_;
    Vec2 cursor_{-1.0};
    int frames_to_draw_ = kSettlingFrames;
};

}  // namespace

void run_window(const WindowOptions& options) { Window(options).run(); }

}  // namespace pectin
