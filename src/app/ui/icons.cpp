#include "app/ui/icons.h"

#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <span>

namespace pectin {
namespace {

// Icons are described in a square of 24 units, with y downwards.
constexpr float kUnits = 24.0f;
constexpr float kStroke = 1.7f;  // width of a line

struct Point {
    float x, y;
};

// Draws in units of the icon.
class Pen {
  public:
    Pen(ImDrawList& list, const ImVec2& centre, float size, ImU32 colour)
        : list_(list),
          left_(centre.x - 0.5f * size),
          top_(centre.y - 0.5f * size),
          unit_(size / kUnits),
          colour_(colour) {}

    void lines(std::initializer_list<Point> points, bool is_closed = false) const {
        for (const Point& p : points) list_.PathLineTo(at(p));
        stroke(is_closed);
    }
    void shape(std::initializer_list<Point> points) const {  // convex
        for (const Point& p : points) list_.PathLineTo(at(p));
        list_.PathFillConvex(colour_);
    }
    void curve(const Point& a, const Point& b, const Point& c, const Point& d) const {
        list_.PathLineTo(at(a));
        list_.PathBezierCubicCurveTo(at(b), at(c), at(d));
        stroke(false);
    }
    void circle(const Point& centre, float radius) const {
        list_.AddCircle(at(centre), radius * unit_, colour_, 0, width());
    }
    void disc(const Point& centre, float radius) const {
        list_.AddCircleFilled(at(centre), radius * unit_, colour_);
    }
    // From and to in degrees, clockwise from the right.
    void arc(const Point& centre, float radius, float from, float to) const {
        constexpr float kDegree = std::numbers::pi_v<float> / 180.0f;
        list_.PathArcTo(at(centre), radius * unit_, from * kDegree, to * kDegree);
        stroke(false);
    }
    // The same with a fraction of the opacity.
    Pen faint(float opacity) const {
        Pen pen = *this;
        ImVec4 colour = ImGui::ColorConvertU32ToFloat4(colour_);
        colour.w *= opacity;
        pen.colour_ = ImGui::ColorConvertFloat4ToU32(colour);
        return pen;
    }

  private:
    ImVec2 at(const Point& p) const { return {left_ + p.x * unit_, top_ + p.y * unit_}; }
    float width() const { return kStroke * unit_; }
    void stroke(bool is_closed) const {
        list_.PathStroke(colour_, is_closed ? ImDrawFlags_Closed : ImDrawFlags_None, width());
    }

    ImDrawList& list_;
    float left_, top_, unit_;
    ImU32 colour_;
};

// A surface whose middle is pulled up.
void draw_sculpt(const Pen& pen) {
    pen.curve({2.0f, 19.5f}, {8.5f, 19.5f}, {8.0f, 10.0f}, {12.0f, 10.0f});
    pen.curve({12.0f, 10.0f}, {16.0f, 10.0f}, {15.5f, 19.5f}, {22.0f, 19.5f});
    pen.lines({{12.0f, 9.0f}, {12.0f, 4.5f}});
    pen.shape({{12.0f, 1.5f}, {15.2f, 6.0f}, {8.8f, 6.0f}});
}

// A box with control points at its corners.
void draw_cage(const Pen& pen) {
    const Pen back = pen.faint(0.5f);
    back.lines({{8.0f, 4.0f}, {8.0f, 15.0f}, {20.0f, 15.0f}});
    back.lines({{8.0f, 15.0f}, {4.0f, 20.0f}});
    pen.lines({{4.0f, 9.0f}, {16.0f, 9.0f}, {16.0f, 20.0f}, {4.0f, 20.0f}}, true);
    pen.lines({{4.0f, 9.0f}, {8.0f, 4.0f}, {20.0f, 4.0f}, {16.0f, 9.0f}});
    pen.lines({{20.0f, 4.0f}, {20.0f, 15.0f}, {16.0f, 20.0f}});
    for (const Point& p : {Point{4.0f, 9.0f}, Point{16.0f, 9.0f}, Point{16.0f, 20.0f},
                           Point{4.0f, 20.0f}, Point{20.0f, 4.0f}, Point{8.0f, 4.0f}}) {
        pen.disc(p, 2.0f);
    }
}

// A pin with its point at the lower left.
void draw_pin(const Pen& pen) {
    pen.shape({{13.0f, 3.0f}, {21.0f, 11.0f}, {18.6f, 12.2f}, {11.8f, 5.4f}});
    pen.lines({{13.2f, 6.8f}, {9.8f, 11.0f}});
    pen.lines({{17.2f, 10.8f}, {13.0f, 14.2f}});
    pen.lines({{5.8f, 10.0f}, {14.0f, 18.2f}});
    pen.lines({{6.2f, 10.4f}, {9.8f, 10.8f}, {13.2f, 14.2f}, {13.6f, 17.8f}});
    pen.lines({{9.6f, 14.4f}, {3.0f, 21.0f}});
}

// Two shapes, mirrored in a dashed line.
void draw_symmetry(const Pen& pen) {
    for (const float y : {2.0f, 7.6f, 13.2f, 18.8f}) {
        pen.lines({{12.0f, y}, {12.0f, y + 3.2f}});
    }
    pen.shape({{9.0f, 5.5f}, {9.0f, 18.5f}, {2.0f, 18.5f}});
    pen.lines({{15.0f, 5.5f}, {15.0f, 18.5f}, {22.0f, 18.5f}}, true);
}

// Two joined dots, and one apart.
void draw_connected(const Pen& pen) {
    pen.lines({{6.0f, 17.0f}, {13.0f, 8.0f}});
    pen.disc({6.0f, 17.0f}, 4.0f);
    pen.disc({13.0f, 7.5f}, 4.0f);
    pen.faint(0.75f).circle({19.0f, 18.0f}, 3.0f);
}

// Layers that bend together and never touch.
void draw_fold_free(const Pen& pen) {
    for (const float y : {0.0f, 5.2f, 10.4f}) {
        pen.curve({2.0f, 9.5f + y}, {8.0f, 9.5f + y}, {8.0f, 2.5f + y}, {12.0f, 2.5f + y});
        pen.curve({12.0f, 2.5f + y}, {16.0f, 2.5f + y}, {16.0f, 9.5f + y}, {22.0f, 9.5f + y});
    }
}

void draw_wireframe(const Pen& pen) {
    pen.lines({{2.5f, 19.5f}, {12.0f, 3.5f}, {21.5f, 19.5f}}, true);
    pen.lines({{7.25f, 11.5f}, {16.75f, 11.5f}, {12.0f, 19.5f}}, true);
}

// A square that is divided again and again.
void draw_levels(const Pen& pen) {
    pen.lines({{3.0f, 3.0f}, {21.0f, 3.0f}, {21.0f, 21.0f}, {3.0f, 21.0f}}, true);
    pen.lines({{12.0f, 3.0f}, {12.0f, 21.0f}});
    pen.lines({{3.0f, 12.0f}, {21.0f, 12.0f}});
    pen.faint(0.6f).shape({{12.0f, 12.0f}, {21.0f, 12.0f}, {21.0f, 21.0f}, {12.0f, 21.0f}});
    pen.lines({{16.5f, 12.0f}, {16.5f, 21.0f}});
    pen.lines({{12.0f, 16.5f}, {21.0f, 16.5f}});
}

// An object between the corners of a frame.
void draw_frame_all(const Pen& pen) {
    pen.lines({{3.0f, 8.0f}, {3.0f, 3.0f}, {8.0f, 3.0f}});
    pen.lines({{16.0f, 3.0f}, {21.0f, 3.0f}, {21.0f, 8.0f}});
    pen.lines({{21.0f, 16.0f}, {21.0f, 21.0f}, {16.0f, 21.0f}});
    pen.lines({{8.0f, 21.0f}, {3.0f, 21.0f}, {3.0f, 16.0f}});
    pen.disc({12.0f, 12.0f}, 4.2f);
}

// towards: -1 to the left (undo), 1 to the right.
void draw_turning_arrow(const Pen& pen, float towards) {
    const auto x = [towards](float right) { return 12.0f + towards * right; };
    pen.lines({{x(8.0f), 8.5f}, {x(-3.0f), 8.5f}});
    if (towards > 0.0f) {
        pen.arc({x(-3.0f), 13.75f}, 5.25f, 90.0f, 270.0f);
    } else {
        pen.arc({x(-3.0f), 13.75f}, 5.25f, -90.0f, 90.0f);
    }
    pen.lines({{x(-3.0f), 19.0f}, {x(3.0f), 19.0f}});
    pen.lines({{x(4.5f), 4.0f}, {x(9.0f), 8.5f}, {x(4.5f), 13.0f}});
}

void draw_help(const Pen& pen) {
    pen.circle({12.0f, 12.0f}, 9.5f);
    pen.arc({12.0f, 9.6f}, 3.1f, -180.0f, 35.0f);
    pen.curve({14.5f, 11.4f}, {12.6f, 12.9f}, {12.0f, 13.0f}, {12.0f, 14.6f});
    pen.disc({12.0f, 17.4f}, 1.25f);
}

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, const ImVec2& centre, float size, ImU32 colour) {
    const Pen pen(list, centre, size, colour);
    switch (icon) {
        case Icon::sculpt:
            return draw_sculpt(pen);
        case Icon::cage:
            return draw_cage(pen);
        case Icon::pin:
            return draw_pin(pen);
        case Icon::symmetry:
            return draw_symmetry(pen);
        case Icon::connected:
            return draw_connected(pen);
        case Icon::fold_free:
            return draw_fold_free(pen);
        case Icon::wireframe:
            return draw_wireframe(pen);
        case Icon::levels:
            return draw_levels(pen);
        case Icon::frame_all:
            return draw_frame_all(pen);
        case Icon::undo:
            return draw_turning_arrow(pen, -1.0f);
        case Icon::redo:
            return draw_turning_arrow(pen, 1.0f);
        case Icon::help:
            return draw_help(pen);
    }
}

}  // namespace pectin
