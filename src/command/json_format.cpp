#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <vector>

#include "command/json.h"

namespace pectin {

namespace {

// Writes JSON text, either on one line or with one field on each line.
class JsonWriter {
  public:
    enum class Layout { line, indented };
    explicit JsonWriter(Layout layout) : layout_(layout) {}

    void open(char bracket) {
        text_ += bracket;
        ++depth_;
        is_first_ = true;
    }
    void close(char bracket) {
        --depth_;
        if (layout_ == Layout::indented) break_line();
        text_ += bracket;
        is_first_ = false;
    }
    // Writes what separates two fields or elements. Called before each of them.
    void next() {
        if (!is_first_) text_ += layout_ == Layout::line ? ", " : ",";
        if (layout_ == Layout::indented) break_line();
        is_first_ = false;
    }
    void key(std::string_view name) {
        next();
        value(name);
        text_ += ": ";
    }
    template <class T>
    void field(std::string_view name, const T& what) {
        key(name);
        value(what);
    }
    template <class T>
    void field(std::string_view name, const std::optional<T>& what) {
        if (what) field(name, *what);
    }
    void null_field(std::string_view name) {
        key(name);
        text_ += "null";
    }
    template <class T>
    void array(std::string_view name, const T& elements) {
        key(name);
        open('[');
        for (const auto& element : elements) {
            next();
            value(element);
        }
        close(']');
    }

    void value(bool truth) { text_ += truth ? "true" : "false"; }
    void value(std::integral auto number) { append_number(number); }
    void value(double number) {
        if (!std::isfinite(number)) {
            text_ += "null";
        } else if (number == 0.0 && std::signbit(number)) {
            text_ += "-0.0";  // "-0" would be read as the whole number 0
        } else {
            append_number(number);
        }
    }
    void value(std::string_view text);
    void value(const char* text) { value(std::string_view(text)); }
    void value(const Setting& setting) {
        if (setting.is_automatic()) value("auto");
        if (setting.is_off()) text_ += "null";
        if (setting.kind == Setting::Kind::value) value(setting.value);
    }
    template <class T, glm::qualifier Q>
    void value(const glm::vec<3, T, Q>& vector) {
        open('[');
        for (int axis = 0; axis < 3; ++axis) {
            next();
            value(vector[axis]);
        }
        close(']');
    }
    void value(const command::Drag::Move& move) {
        open('{');
        field("from", move.from);
        field("to", move.to);
        if (move.twist) {
            key("twist");
            open('{');
            field("axis", move.twist->axis);
            field("degrees", move.twist->degrees);
            close('}');
        }
        if (move.scale != 1.0) field("scale", move.scale);
        close('}');
    }
    void value(const command::Control::Point& point) {
        open('{');
        field("index", point.index);
        field("to", point.to);
        close('}');
    }

    std::string take() { return std::move(text_); }

  private:
    void break_line() { text_ += '\n' + std::string(2 * depth_, ' '); }
    void append_number(auto number) {
        std::array<char, 32> digits;
        const auto end = std::to_chars(digits.begin(), digits.end(), number).ptr;
        text_.append(digits.begin(), end);
    }

    Layout layout_;
    std::string text_;
    std::size_t depth_ = 0;
    bool is_first_ = true;
};

void JsonWriter::value(std::string_view text) {
    constexpr std::string_view kHexDigits = "0123456789abcdef";
    text_ += '"';
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            text_ += '\\';
            text_ += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            text_ += "\\u00";
            text_ += kHexDigits[static_cast<unsigned char>(c) >> 4];
            text_ += kHexDigits[static_cast<unsigned char>(c) & 15];
        } else {
            text_ += c;
        }
    }
    text_ += '"';
}

struct FieldWriter {
    JsonWriter& json;

    void operator()(const command::Open& open) const {
        json.field("path", open.path);
        json.field("crease_angle", open.crease_angle);
    }
    void operator()(const command::Shape& shape) const {
        constexpr std::array kNames{"sphere", "cube", "plane", "torus", "cylinder"};
        json.field("kind", kNames[static_cast<std::size_t>(shape.kind)]);
        json.field("resolution", shape.resolution);
    }
    void operator()(const command::Adapt& adapt) const {
        json.field("enabled", adapt.enabled);
        json.field("theta_max", adapt.theta_max);
        json.field("theta_min", adapt.theta_min);
        json.field("l_max", adapt.l_max);
        json.field("flatness", adapt.flatness);
        json.field("floor", adapt.floor);
        json.field("budget", adapt.budget);
        json.field("drag_budget", adapt.drag_budget);
        json.field("propagation", adapt.propagation);
    }
    void operator()(const command::Brush& brush) const {
        json.field("radius", brush.radius);
        json.field("span", brush.span);
    }
    void operator()(const command::Cage& cage) const {
        if (const auto* grid = std::get_if<command::Cage::Grid>(&cage.lattice)) {
            json.field("origin", grid->origin);
            json.field("cell", grid->cell);
            json.field("deformable", grid->deformable);
            if (grid->margin != IVec3{0}) json.field("margin", grid->margin);
        } else {
            json.field("fit", std::get<command::Cage::Fit>(cage.lattice).deformable);
        }
    }
    void operator()(const command::Symmetry& symmetry) const {
        constexpr std::array kNames{"x", "y", "z"};
        if (symmetry.plane) {
            json.field("plane", kNames[static_cast<std::size_t>(*symmetry.plane)]);
        } else {
            json.null_field("plane");
        }
        if (symmetry.through != Vec3{0.0}) json.field("through", symmetry.through);
    }
    void operator()(const command::Drag& drag) const {
        json.array("moves", drag.moves);
        if (!drag.pins.empty()) json.array("pins", drag.pins);
        if (drag.connected) json.field("connected", true);
        if (drag.fold_free) json.field("fold_free", true);
        if (!drag.via.empty()) json.array("via", drag.via);
    }
    void operator()(const command::Control& control) const { json.array("points", control.points); }
    void operator()(const command::Undo& undo) const { json.field("count", undo.count); }
    void operator()(const command::Redo& redo) const { json.field("count", redo.count); }
    void operator()(const command::History& history) const {
        json.field("megabytes", history.megabytes);
    }
    void operator()(const command::Readapt&) const {}
    void operator()(const command::Bake&) const {}
    void operator()(const command::Save& save) const { json.field("path", save.path); }
    void operator()(const command::Stats& stats) const { json.field("path", stats.path); }
    void operator()(const command::Screenshot& screenshot) const {
        json.field("path", screenshot.path);
        json.array("size", std::array{screenshot.width, screenshot.height});
        if (const std::optional<Camera>& camera = screenshot.camera) {
            json.key("camera");
            json.open('{');
            json.field("eye", camera->eye);
            json.field("target", camera->target);
            json.field("up", camera->up);
            json.field("fov", camera->fov);
            json.close('}');
        }
        std::vector<const char*> shown;
        if (screenshot.show.wireframe) shown.push_back("wireframe");
        if (screenshot.show.lattice) shown.push_back("lattice");
        if (screenshot.show.levels) shown.push_back("levels");
        if (screenshot.show.ui) shown.push_back("ui");
        if (!shown.empty()) json.array("show", shown);
    }
};

void write_input(JsonWriter& json, const std::vector<Statistics::Count>& input) {
    json.key("input");
    json.open('{');
    for (const Statistics::Count& count : input) json.field(count.name, count.count);
    json.close('}');
}

void write_last(JsonWriter& json, const Statistics::Last& last) {
    json.key("last");
    json.open('{');
    json.field("splits", last.splits);
    json.field("unsplits", last.unsplits);
    json.field("influenced_vertices", last.influenced_vertices);
    json.field("steps", last.steps);
    json.key("seconds");
    json.open('{');
    json.field("begin", last.seconds.begin);
    json.field("solve", last.seconds.solve);
    json.field("deform", last.seconds.deform);
    json.field("refine", last.seconds.refine);
    json.field("decimate", last.seconds.decimate);
    json.field("commit", last.seconds.commit);
    json.close('}');
    json.close('}');
}

}  // namespace

std::string format_command(const Command& command) {
    JsonWriter json(JsonWriter::Layout::line);
    json.open('{');
    json.field("cmd", name(command));
    std::visit(FieldWriter{json}, command);
    json.close('}');
    return json.take();
}

std::string format_statistics(const Statistics& statistics) {
    JsonWriter json(JsonWriter::Layout::indented);
    json.open('{');
    json.field("vertices", statistics.vertices);
    json.field("faces", statistics.faces);
    json.field("base_vertices", statistics.base_vertices);
    json.field("base_faces", statistics.base_faces);
    json.field("max_level", statistics.max_level);
    write_input(json, statistics.input);
    write_last(json, statistics.last);
    json.field("edge_max", statistics.edge_max);
    json.field("angle_min_deg", statistics.angle_min_deg);
    json.field("divergence_max_deg", statistics.divergence_max_deg);
    json.field("needing_refinement", statistics.needing_refinement);
    json.field("held_back", statistics.held_back);
    json.field("floor_hit", statistics.floor_hit);
    json.field("budget_hit", statistics.budget_hit);
    json.field("drag_budget_hit", statistics.drag_budget_hit);
    json.field("folded_vertices", statistics.folded_vertices);
    json.field("memory_bytes", statistics.memory_bytes);
    json.field("undo_steps", statistics.undo_steps);
    json.field("undo_bytes", statistics.undo_bytes);
    json.close('}');
    return json.take() + "\n";
}

}  // namespace pectin
