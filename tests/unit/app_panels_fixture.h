// The panels with simulated mouse and keyboard input. Controls are found by their names.
#pragma once

#include <cctype>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "app/ui/interface.h"
#include "unit/app_editor_fixture.h"

namespace pectin {

class PanelsTest : public EditorTest {
  protected:
    void SetUp() override { show(kSize, 1.0f); }

    // Makes the window anew, with this size and this scale of the screen.
    void show(const IVec2& size, float scale) {
        interface_.reset();  // only one may exist
        editor_.reset(new PreparedEditor(editor()));
        size_ = size;
        interface_ = std::make_unique<Interface>(scale);
        interface_->set_size(size, size);
        editor_->handle(event::Resize{size});
        lay_out();
    }
    void lay_out() {
        for (int i = 0; i < 3; ++i) interface_->lay_out(*editor_, {});
    }

    // --- Input.
    void give(const InputEvent& input) { interface_->handle(*editor_, input); }
    void press_key(Key key, Modifiers modifiers = {}) {
        give(event::KeyDown{key, modifiers});
        give(event::KeyUp{key});
    }
    void type(const std::string& text) {
        for (const char c : text) {
            const int capital = std::toupper(static_cast<unsigned char>(c));
            give(event::KeyDown{Key{capital}});
            give(event::Character{static_cast<unsigned char>(c)});
            give(event::KeyUp{Key{capital}});
        }
    }
    void click(const Vec2& at) {
        give(event::MouseMove{at});
        give(event::Press{MouseButton::left, at});
        give(event::Release{MouseButton::left, at});
    }

    // --- Controls. They are scrolled into view first.
    const Control* find(const std::string& name) {
        lay_out();
        return interface_->controls().find(name);
    }
    static Vec2 middle(const Control& control) { return 0.5 * (control.min + control.max); }
    bool is_visible(const Control& control) const {
        const auto& free = interface_->free_area();
        const double top = free.min.y, bottom = free.max.y;
        return control.min.y >= top && control.max.y <= bottom;
    }
    // The middle of a control that is visible now.
    Vec2 reach(const std::string& name) {
        for (int i = 0; i < 60; ++i) {
            const Control* const control = find(name);
            if (!control) break;
            if (is_visible(*control)) return middle(*control);
            const auto& free = interface_->free_area();
            const double towards = control->min.y < free.min.y ? 1.0 : -1.0;
            const Vec2 panel{0.5 * (free.max.x + size_.x), 0.5 * (free.min.y + free.max.y)};
            give(event::MouseMove{panel});
            give(event::Scroll{towards, panel});
        }
        ADD_FAILURE() << name << " cannot be reached";
        return {};
    }
    void click(const std::string& name) { click(reach(name)); }
    void drag_control(const std::string& name, double by) {
        const Vec2 from = reach(name);
        // A press soon after another one would be a double click.
        std::this_thread::sleep_for(std::chrono::milliseconds(320));
        give(event::MouseMove{from});
        give(event::Press{MouseButton::left, from});
        give(event::MouseMove{from + Vec2{by, 0.0}});
        give(event::Release{MouseButton::left, from + Vec2{by, 0.0}});
    }
    void type_into(const std::string& name, const std::string& text) {
        const Vec2 at = reach(name);
        click(at);
        click(at);
        press_key(Key{'A'}, {.control = true});
        type(text);
        press_key(Key::enter);
        lay_out();
    }
    // Opens what is folded at first.
    void open_advanced() {
        if (!find("θ max")) click("Advanced");
        ASSERT_TRUE(find("θ max"));
    }

    IVec2 size_{0};
    std::unique_ptr<PreparedEditor> editor_;
    std::unique_ptr<Interface> interface_;
};

}  // namespace pectin
