#include "app/window.h"

#include <imgui.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
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
#include "app/recovery_paths.h"
#include "app/ui/interface.h"
#include "app/window_viewport.h"
#include "app/words.h"
#include "io/printable.h"
#include "render/imgui_renderer.h"

namespace pectin {
namespace {

constexpr IVec2 kFirstSize{1280, 800};
// Number of frames after an event until the panels no longer change.
constexpr int kSettlingFrames = 3;
// How long adaptive meshing of one frame of a drag may take. The frame also deforms, uploads and
// draws, and should take no more than 16 ms in all.
constexpr std::chrono::milliseconds kFrameTime{8};
// How long the release of a drag or a command may block the window. Longer ones continue in the
// background, and the window keeps showing the last picture of the object.
constexpr std::chrono::milliseconds kEditTime{100};
// Seconds to wait for events when nothing has to be drawn. The wait is limited, because the driver
// reads from the same connection while drawing and may already have taken an event from there.
constexpr double kLongestWait = 0.1;
// Seconds between frames that show the progress of work in the background. Drawing more often would
// slow the work down.
constexpr double kProgressWait = 1.0 / 15.0;

// Seconds between the frames of an example's motion.
constexpr double kMotionWait = 1.0 / 60.0;

// Memory used by the whole program, as the system reports it; 0 if it does not.
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
          font_version_(interface_.font_version()),
          object_(host_.gl()),
          viewport_(host_.gl(), renderer_, object_) {
        interface_.set_renderer(description_of(host_.gl()));
        editor_.workspace().set_viewport(&viewport_);
        editor_.workspace().set_frame_time(kFrameTime);
        editor_.workspace().set_max_edit_time(kEditTime);
        interface_.set_size(host_.size(), host_.framebuffer_size());
        editor_.handle(event::Resize{host_.size()});
        load_preferences();
        std::vector<LostSession> lost_sessions = begin_recovery();
        set_exit_message(termination);
        report_record_path(options.record);
        editor_.begin(options.model);
        editor_.document().offer(std::move(lost_sessions));
    }

    void run() {
        while (!editor_.document().wants_to_end()) {
            attempt([this] { take_input(); });
            attempt([this] { save_preferences(); });
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
    // Runs a part of a frame, for which there may not be enough memory. Returns whether there was.
    template <typename Part>
    bool attempt(Part part) {
        try {
            part();
            return true;
        } catch (const std::bad_alloc&) {
            editor_.handle_out_of_memory("frame");
            return false;
        }
    }

    void load_preferences() {
        const PreferencesFile::Loaded loaded = preferences_file_.load();
        editor_.preferences = loaded.preferences;
        if (!loaded.notice.empty()) editor_.workspace().add_notice(loaded.notice);
    }

    // Keeps what the user has changed for the next session.
    void save_preferences() {
        try {
            preferences_file_.save(editor_.preferences);
        } catch (const std::exception& error) {
            editor_.workspace().add_notice("The preferences are not kept for the next session. " +
                                           words_of(error));
        }
    }

    // Begins to keep this session for recovery. Returns the sessions to be offered.
    std::vector<LostSession> begin_recovery() {
        const std::string folder = recovery_folder();
        if (folder.empty()) return {};
        LostSessions lost = find_lost_sessions(folder);
        Workspace& workspace = editor_.workspace();
        workspace.begin_recovery(folder);
        for (const std::string& file : lost.damaged) {
            workspace.add_notice(
                "A session that ended unexpectedly cannot be restored, because its script is "
                "damaged. The script is kept in " +
                file + ".");
        }
        return std::move(lost.sessions);
    }

    void set_exit_message(TerminationWatch& termination) {
        *is_kept_ = editor_.workspace().has_recovery();
        termination.set_exit_message([is_kept = is_kept_](const char* signal) {
            return std::string("pectin: ended by ") + signal +
                   (*is_kept ? "; unsaved changes will be offered at the next start" : "");
        });
    }

    // Tells the user if the record has another path than wanted, because of an earlier record.
    void report_record_path(const std::string& wanted) {
        const std::string path = editor_.workspace().record_path();
        if (path == wanted) return;
        const auto message = [](const std::string& earlier, const std::string& present) {
            return earlier + " holds an earlier record, so this session is recorded in " + present;
        };
        const auto name = [](const std::string& file) {
            return std::filesystem::path(file).filename().string();
        };
        editor_.workspace().add_notice(message(name(wanted), name(path)) + ".");
        std::cerr << "pectin: " << printable(message(wanted, path)) << '\n';
    }

    // Returns the seconds for which take_input() may wait. Restoring runs between the frames, while
    // work on files runs in the background.
    double input_wait() const {
        if (editor_.example().is_moving()) return kMotionWait;
        if (editor_.document().restoration() || editor_.has_unfinished_frame()) return 0.0;
        if (editor_.is_working()) return kProgressWait;
        return frames_to_draw_ == 0 ? kLongestWait : 0.0;
    }

    // Handles all events before the next frame is drawn, however long the last frame took.
    void take_input() {
        const bool shows_progress = editor_.is_working() || editor_.has_unfinished_frame();
        const std::span<const InputEvent> events = host_.take_events(input_wait());
        if (!events.empty() || shows_progress) frames_to_draw_ = kSettlingFrames;
        for (const InputEvent& event : events) {
            if (editor_.document().wants_to_end()) return;
            // If there is no memory for one event, the events after it are still handled.
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
        if (editor_.workspace().edit_task()) return;  // the mesh is in use
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
        if (std::exchange(font_version_, interface_.font_version()) != interface_.font_version()) {
            panel_renderer_.upload_font(*ImGui::GetIO().Fonts);
        }
        panel_renderer_.draw(interface_.draw_data(), *canvas_);
        canvas_->resolve();
        canvas_->blit_to(0);
    }

    float pixel_scale() const {
        const auto ratio = static_cast<float>(host_.framebuffer_size().x) /
                           static_cast<float>(std::max(host_.size().x, 1));
        return ratio * host_.content_scale();
    }

    PreferencesFile preferences_file_{preferences_path()};
    // Declared before the host, so that no window opens if the record cannot be written.
    Editor editor_;
    WindowHost host_;
    Interface interface_;
    Renderer renderer_;
    ImGuiRenderer panel_renderer_;
    int font_version_;  // of the texture that the renderer has
    ObjectView object_;
    WindowViewport viewport_;
    std::unique_ptr<Canvas> canvas_;  // has the window's size in pixels
    PictureFigures figures_;
    // Whether all commands are kept for recovery. Shared with the thread that waits for signals,
    // which may run longer than the window.
    std::shared_ptr<std::atomic<bool>> is_kept_ = std::make_shared<std::atomic<bool>>(false);
    int frames_to_draw_ = kSettlingFrames;
};

}  // namespace

void run_window(const WindowOptions& options, TerminationWatch& termination) {
    Window(options, termination).run();
}

}  // namespace pectin
