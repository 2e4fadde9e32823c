// The real window with a twin that has no window system and gets the same input. The twin says
// where each control is at the moment, wherever panels are scrolled and whatever is folded.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "support/offscreen_window.h"
#include "window/window_fixture.h"

namespace pectin {

class WindowTwinTest : public WindowTest {
  protected:
    void open_both() {
        open_window();
        if (HasFatalFailure()) return;
        // Both begin with the same object and settings.
        twin_.editor().begin("");
        move({kMiddleX, kMiddleY});
        twin_.settle();
    }
    Editor& editor() { return twin_.editor(); }
    test::OffscreenWindow& twin() { return twin_; }

    // --- Input to both.
    void move(const Vec2& at) {
        twin_.move(at);
        desktop().perform(moved(at));
    }
    void click(const Vec2& at) {
        twin_.click(at);
        desktop().perform(joined(moved(at), {"click", "1"}));
        twin_.settle();
    }
    void key(Key key, const std::string& name) {
        twin_.key(key);
        desktop().key(name);
        twin_.settle();
    }
    void drag(const Vec2& from, const Vec2& to) {
        twin_.drag(from, to);
        desktop().drag(static_cast<int>(from.x), static_cast<int>(from.y), static_cast<int>(to.x),
                       static_cast<int>(to.y));
        twin_.settle();
    }
    void scroll(const Vec2& at, int notches) {
        std::vector<std::string> words = moved(at);
        for (int i = 0; i < std::abs(notches); ++i) {
            twin_.move(at);
            twin_.scroll(at, notches > 0 ? 1.0 : -1.0);
            words = joined(std::move(words), {"click", notches > 0 ? "4" : "5"});
        }
        desktop().perform(words);
        twin_.settle();
    }
    // Types into a number after a click with Ctrl, which does what a double click does however slow
    // the machine is.
    void type_at(const Vec2& at, const std::string& text) {
        const Modifiers control{.control = true};
        twin_.click(at, control);
        twin_.key(Key{'A'}, control);
        twin_.type(text);
        twin_.key(Key::enter);
        desktop().perform(
            joined(moved(at), {"keydown", "ctrl", "click", "1", "keyup", "ctrl", "key", "ctrl+a",
                               "type", "--delay", "5", "--args", "1", text, "key", "Return"}));
        twin_.settle();
    }
    // Opens a list and chooses the entry with this text.
    void choose_at(const Vec2& at, const std::string& entry) {
        click(at);
        const auto place = twin_.find(entry);
        ASSERT_TRUE(place) << "the list has no entry " << entry;
        click(pixel(*place));
    }

    // --- Controls of the panels.
    // The control of this name, the first if `which` is 0; null if there is none.
    const Control* find(const std::string& name, int which = 0) {
        twin_.settle();
        for (const Control& control : twin_.interface().controls().all()) {
            if (control.name == name && which-- == 0) return &control;
        }
        return nullptr;
    }
    // Scrolls the panel until the control can be seen, and returns its middle.
    Vec2 reach(const std::string& name, int which = 0) {
        for (int i = 0; i < 60; ++i) {
            const Control* const control = find(name, which);
            if (!control) break;
            const auto free = twin_.interface().free_area();
            const bool is_above = control->min.y < free.min.y;
            if (!is_above && control->max.y <= free.max.y) {
                return pixel(0.5 * (control->min + control->max));
            }
            scroll(pixel({0.5 * (free.max.x + twin_.size().x), 0.5 * (free.min.y + free.max.y)}),
                   is_above ? 2 : -2);
        }
        ADD_FAILURE() << name << " cannot be reached";
        return {kMiddleX, kMiddleY};
    }

    // Saves a picture and returns the record's line about it, which says what it shows from where.
    std::string picture() {
        const std::string name = "picture" + std::to_string(pictures_++) + ".png";
        desktop().perform({"key", "F3", "type", "--delay", "5", "--args", "1", "Save a picture",
                           "key", "Return", "type", "--delay", "5", "--args", "1", path(name),
                           "key", "Return"});
        EXPECT_TRUE(records(name)) << record();
        return last("screenshot");
    }

    struct Viewpoint {
        Vec3 eye{0.0}, target{0.0};
    };
    Viewpoint viewpoint() {
        const std::string line = picture();
        Viewpoint view;
        const auto read = [&](const std::string& field, Vec3& point) {
            const std::size_t at = line.find("\"" + field + "\": [");
            EXPECT_NE(at, line.npos) << line;
            if (at == line.npos) return;
            const char* const numbers = line.c_str() + at + field.size() + 5;
            EXPECT_EQ(std::sscanf(numbers, "%lf, %lf, %lf", &point.x, &point.y, &point.z), 3);
        };
        read("eye", view.eye);
        read("target", view.target);
        return view;
    }

  private:
    static Vec2 pixel(const Vec2& at) { return glm::floor(at); }
    static std::vector<std::string> moved(const Vec2& at) {
        return {"mousemove", std::to_string(static_cast<int>(at.x)),
                std::to_string(static_cast<int>(at.y))};
    }
    static std::vector<std::string> joined(std::vector<std::string> words,
                                           const std::vector<std::string>& more) {
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }

    test::OffscreenWindow twin_{{.size = {1280, 800}}};
    int pictures_ = 0;
};

}  // namespace pectin
