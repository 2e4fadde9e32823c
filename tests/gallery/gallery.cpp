// Draws the window in many states, as pictures to look at: pectin_gallery FOLDER [NAME…].
// scripts/gallery builds and runs it.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "app/host/offscreen_host.h"
#include "app/picture.h"
#include "io/obj_writer.h"
#include "mesh/build_mesh.h"
#include "mesh/shapes.h"
#include "support/offscreen_window.h"

namespace pectin {
namespace {

namespace fs = std::filesystem;
using test::OffscreenWindow;

Vec2 middle(const OffscreenWindow& window) { return 0.5 * Vec2(window.size()); }

Vec2 beside_object(const OffscreenWindow& window) { return Vec2(window.size()) * Vec2{0.32, 0.86}; }

void make(OffscreenWindow& window, Example example) {
    for (const ExampleStep& step : read_example(example, example_folders())) {
        for (const Command& command : step.commands) window.editor().execute(command);
    }
    window.editor().view_control().frame_all();
    window.settle();
}

// Performs the action of that name, whatever it is called in the code. Returns whether there is
// one.
bool perform(OffscreenWindow& window, const std::string& name) {
    const auto actions = all_actions();
    const auto found = std::ranges::find_if(actions, [&](const ActionInfo& info) {
        return std::string(info.name).find(name) != std::string::npos;
    });
    if (found == actions.end()) return false;
    window.editor().perform(found->action);
    window.settle();
    return true;
}

void begin_drag(OffscreenWindow& window) {
    const Vec2 from = middle(window) + Vec2{40, -30};
    window.pull(from, from + Vec2{110, -90});
    window.settle();
}

void show_cage(OffscreenWindow& window) {
    make(window, Example::nose);
    window.editor().set_cage(window.editor().workspace().box(), IVec3{4});
    window.editor().display.lattice = true;
    window.settle();
    const Vec2 size(window.size());
    window.drag(size * Vec2{0.3, 0.16}, size * Vec2{0.7, 0.36}, {.control = true});
    window.settle();
}

void set_pins(OffscreenWindow& window) {
    for (const Vec2& offset : {Vec2{60, 60}, Vec2{90, -20}, Vec2{20, 90}, Vec2{-40, 40}}) {
        window.move(middle(window) + offset);
        window.key(Key{'P'});
    }
    window.move(beside_object(window));
    window.settle();
}

fs::path g_folder;  // where the pictures go

std::string ball(int resolution) {
    return format_obj(build_mesh(make_shape(ShapeKind::sphere, resolution)).mesh);
}

void show_browser(OffscreenWindow& window) {
    const fs::path models = g_folder / "models";
    fs::create_directories(models / "heads");
    fs::create_directories(models / "animals");
    for (const int resolution : {1, 3, 4}) {
        std::ofstream(models / ("ball-" + std::to_string(resolution) + ".obj")) << ball(resolution);
    }
    window.key(Key{'O'}, {.control = true});
    window.editor().document().browser()->open_folder(models.string());
    window.settle();
}

// Opens a model that takes seconds to read, and waits until about half of it is read.
void show_progress(OffscreenWindow& window) {
    const fs::path model = g_folder / "models" / "million.obj";
    fs::create_directories(model.parent_path());
    std::ofstream(model) << ball(8);
    window.give(event::Drop{{model.string()}});
    const auto half_read = [&] {
        const FileTask* const task = window.editor().workspace().file_task();
        return !task || task->work.fraction() > 0.4;
    };
    while (!half_read()) window.frame();
    window.settle();
    window.editor().document().cancel_work();
}

struct State {
    const char* name;
    void (*prepare)(OffscreenWindow&);
    OffscreenWindow::Options options{};
};

const std::vector<State>& states() {
    using Window = OffscreenWindow;
    static const std::vector<State> kStates{
        {"01_first_start", [](Window& window) { window.settle(); }},
        {"02_orbit",
         [](Window& window) {
             const Vec2 from = beside_object(window);
             make(window, Example::nose);
             window.pull(from, from + Vec2{160, -40}, {}, MouseButton::middle);
         }},
        {"03_drag", begin_drag},
        {"04_wireframe",
         [](Window& window) {
             make(window, Example::elephant);
             window.key(Key{'W'});
             window.settle();
         }},
        {"05_levels",
         [](Window& window) {
             make(window, Example::elephant);
             window.key(Key{'V'});
             window.settle();
         }},
        {"06_cage", show_cage},
        {"07_tool_brush",
         [](Window& window) {
             make(window, Example::nose);
             window.move(middle(window) + Vec2{60, 20});
             window.settle();
         }},
        {"07_tool_radius",
         [](Window& window) {
             window.move(middle(window));
             window.give(event::KeyDown{Key{'F'}});
             window.move(middle(window) + Vec2{70, 0});
             window.settle();
         }},
        {"07_tool_pin",
         [](Window& window) {
             window.editor().sets_pins = true;
             window.move(middle(window) + Vec2{40, 0});
             window.settle();
         }},
        {"07_tool_cage",
         [](Window& window) {
             show_cage(window);
             window.move(middle(window) + Vec2{0, 0});
             window.give(event::MouseMove{middle(window), {.control = true}});
             window.settle();
         }},
        {"08_pins", set_pins},
        {"09_file_browser", show_browser},
        {"10_loading", show_progress, {.max_blocking_time = std::chrono::milliseconds(0)}},
        {"11_palette",
         [](Window& window) {
             window.key(Key::f3);
             window.type("sy");
             window.settle();
         }},
        {"12_keys",
         [](Window& window) {
             window.key(Key::f1);
             window.settle();
         }},
        {"13_light_theme",
         [](Window& window) {
             make(window, Example::nose);
             if (!perform(window, "Light")) std::printf("  there is no light theme\n");
         }},
        {"14_example",
         [](Window& window) {
             window.editor().perform(Action::example_nose);
             for (int i = 0; i < 5; ++i) {
                 window.editor().example().next();
                 window.editor().example().next();
                 window.frame();
             }
             window.settle();
         }},
        {"15_reference",
         [](Window& window) { window.editor().perform(Action::show_reference), window.settle(); }},
        {"16_about",
         [](Window& window) { window.editor().perform(Action::show_about), window.settle(); }},
        {"17_small",
         [](Window& window) {
             window.key(Key::f1);
             window.settle();
         },
         {.size = {800, 600}}},
        {"18_scale_2", begin_drag, {.size = {2560, 1440}, .scale = 2.0f}},
    };
    return kStates;
}

void draw(const State& state, const Gl& gl) {
    OffscreenWindow window(state.options);
    test::WindowPainter painter(gl, window);
    state.prepare(window);
    const fs::path path = g_folder / (std::string(state.name) + ".png");
    write_image(painter.draw(), path.string());
    std::printf("%s\n", path.c_str());
}

int run(const std::vector<std::string>& words) {
    g_folder = fs::absolute(words.front());
    fs::create_directories(g_folder);
    const std::unique_ptr<OffscreenHost> host = make_offscreen_host();
    for (const State& state : states()) {
        const bool is_wanted =
            words.size() == 1 || std::any_of(words.begin() + 1, words.end(), [&](const auto& word) {
                return std::string(state.name).find(word) != std::string::npos;
            });
        if (is_wanted) draw(state, host->gl());
    }
    fs::remove_all(g_folder / "models");
    return 0;
}

}  // namespace
}  // namespace pectin

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: pectin_gallery FOLDER [NAME…]\n");
        return 2;
    }
    try {
        return pectin::run({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        std::fprintf(stderr, "pectin_gallery: %s\n", error.what());
        return 1;
    }
}
