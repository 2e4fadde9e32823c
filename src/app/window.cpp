#include "app/window.h"

#include <imgui.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <iostream>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/editor.h"
#include "app/editor_scene.h"
#include "app/host/window_host.h"
#include "app/object_view.h"
#include "app/ui/interface.h"
#include "app/window_viewport.h"
#include "io/printable.h"
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

// Of the whole program, as the system sees it; 0 where it does not say.
std::size_t resident_bytes() {
    std::ifstream file("/proc/self/statm");
    std::size_t all = 0, resident = 0;
    file >> all >> resident;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

class Window {
  public:
    Window(const WindowOptions& options, TerminationWatch& termination)
        : editor_(options.record.empty() ? std::nullopt : std::optional<Recorder>(options.record)),
          host_("pectin", kFirstSize),
          interface_(host_.content_scale(),
                     {.read = [this] { return host_.clipboard_text(); },
                      .write = [this](const std::string& t) { host_.set_clipboard_text(t); }}),
          renderer_(host_.gl()),
          panel_renderer_(host_.gl(), *ImGui::GetIO().Fonts),
          object_(host_.gl()),
          viewport_(host_.gl(), renderer_, object_) {
        editor_.workspace().set_viewport(&viewport_);
        interface_.set_size(host_.size(), host_.framebuffer_size());
        editor_.handle(event::Resize{host_.size()});
        std::vector<LostSession> lost_sessions = begin_recovery(termination);
        tell_of_record(options.record);
        editor_.begin(options.model);
        editor_.offer(std::move(lost_sessions));
    }

    void run() {
        while (!editor_.wants_to_end()) {
            attempt([this] { take_input(); });
            *is_kept_ = editor_.workspace().has_recovery();
            if (frames_to_draw_ == 0) continue;
            --frames_to_draw_;
            attempt([this] { editor_.advance(); });
            *is_kept_ = editor_.workspace().has_recovery();
            const bool is_laid_out = attempt([this] { lay_out_panels(); });
            attempt([this] { update_object(); });
            if (is_laid_out && attempt([this] { draw(); })) host_.show();
        }
        editor_.workspace().end_recovery();
    }

  private:
    // What takes memory by the size of the object may find none. Returns whether there was enough.
    template <typename Part>
    bool attempt(Part part) {
        try {
            part();
            return true;
        } catch (const std::bad_alloc&) {
            editor_.give_up_for_memory("frame");
            return false;
        }
    }

    // Keeps this session for recovery and returns those that are to be offered.
    std::vector<LostSession> begin_recovery(TerminationWatch& termination) {
        LostSessions lost;
        Workspace& workspace = editor_.workspace();
        const std::string folder = recovery_folder();
        if (!folder.empty()) {
            lost = find_lost_sessions(folder);
            workspace.begin_recovery(folder);
        }
        for (const std::string& file : lost.damaged) {
            workspace.add_notice(
                "A session that ended unexpectedly cannot be restored: its "
                "script is damaged. It is in " +
                file + ".");
        }
        *is_kept_ = workspace.has_recovery();
        termination.set_farewell([is_kept = is_kept_](const char* signal) {
            return std::string("pectin: ended by ") + signal +
                   (*is_kept ? "; changes that were not saved are offered at the next start" : "");
        });
        return std::move(lost.sessions);
    }

    // A record that was there already stays, and this one has another name.
    void tell_of_record(const std::string& wanted) {
        const std::string path = editor_.workspace().record_path();
        if (path == wanted) return;
        const std::string message =
            wanted + " holds an earlier record, which stays; this one is in " + path;
        editor_.workspace().add_notice(message);
        std::cerr << "pectin: " << printable(message) << '\n';
    }

    // Handles all that has been done before the next frame is drawn, however slow the last one was.
    void take_input() {
        const bool shows_progress = editor_.is_working();
        const bool rests = frames_to_draw_ == 0;
        // Restoring is done between the frames, and files in the background.
        const double progress_rest = editor_.restoration() ? 0.0 : kProgressWait;
        const std::span<const InputEvent> events = host_.take_events(shows_progress ? progress_rest
                                                                     : rests        ? kLongestWait
                                                                                    : 0.0);
        if (!events.empty() || shows_progress) frames_to_draw_ = kSettlingFrames;
        for (const InputEvent& event : events) {
            if (editor_.wants_to_end()) return;
            // An event for which there is no memory must not take those behind it along.
            attempt([&] { interface_.handle(editor_, event); });
        }
    }

    void lay_out_panels() {
        interface_.set_size(host_.size(), host_.framebuffer_size());
        figures_.memory_bytes = resident_bytes();
        interface_.lay_out(editor_, figures_);
        host_.set_cursor(interface_.cursor_shape());
        const Workspace& workspace = editor_.workspace();
        host_.set_title((workspace.is_modified() ? "*" : "") + workspace.object_name() +
                        " — pectin");
    }

    void update_object() {
        const GpuMesh::Upload upload = object_.update(editor_.workspace().session());
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
        panel_renderer_.draw(interface_.draw_data(), *canvas_);
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
    Renderer renderer_;
    ImGuiRenderer panel_renderer_;
    ObjectView object_;
    WindowViewport viewport_;
    std::unique_ptr<Canvas> canvas_;  // as large as the window
    PictureFigures figures_;
    // Whether all that is done is kept for recovery. Shared with the thread that waits for signals,
    // which may outlive the window.
    std::shared_ptr<std::atomic<bool>> is_kept_ = std::make_shared<std::atomic<bool>>(false);
    int frames_to_draw_ = kSettlingFrames;
};

}  // namespace

void run_window(const WindowOptions& options, TerminationWatch& termination) {
    Window(options, termination).run();
}

}  // namespace pectin
