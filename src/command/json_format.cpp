#include <string>
#include <vector>

#include "command/json.h"
#include "command/json_writer.h"
#include "command/schema.h"

namespace pectin {

namespace {

using command_json::JsonWriter;

// Writes the fields of an object that have to be there, and those that differ from their default.
class FieldWriter {
  public:
    explicit FieldWriter(JsonWriter& json) : json_(json) {}

    template <typename Owner>
    void write_all(const Owner& owner) {
        const Owner initial{};
        for_each_field<Owner>([&](const auto& field) {
            if (!field.is_required() && owner.*field.member == initial.*field.member) return;
            json_.key(field.name);
            write(*field.value_in(owner), field.type);
        });
    }

  private:
    template <typename T, typename Type>
    void write(const T& value, const Type&) {
        json_.value(value);
    }
    template <typename Enumeration, std::size_t N>
    void write(Enumeration value, const field::Choice<N>& type) {
        json_.value(type.words[static_cast<std::size_t>(value)]);
    }
    template <typename Enumeration, std::size_t N>
    void write(const std::optional<Enumeration>& value, const field::ChoiceOrNull<N>& type) {
        if (value) {
            json_.value(type.words[static_cast<std::size_t>(*value)]);
        } else {
            json_.null();
        }
    }
    template <typename T, typename Element>
    void write(const std::vector<T>& values, const field::List<Element>& type) {
        json_.open('[');
        for (const T& value : values) {
            json_.next();
            write(value, type.element);
        }
        json_.close(']');
    }
    template <typename T>
    void write(const T& object, const field::Object&) {
        json_.open('{');
        write_all(object);
        json_.close('}');
    }
    template <typename T>
    void write(const std::optional<T>& object, const field::ObjectOr& type) {
        if (object) {
            write(*object, field::Object{});
        } else {
            json_.value(type.word);
        }
    }
    template <typename T>
    void write(const T& flags, const field::Names&) {
        json_.open('[');
        for_each_field<T>([&](const auto& field) {
            if (!(flags.*field.member)) return;
            json_.next();
            json_.value(field.name);
        });
        json_.close(']');
    }

    JsonWriter& json_;
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

void write_error(JsonWriter& json, const Statistics::Error& error) {
    const auto write = [&](const char* name, const std::optional<double>& value) {
        json.key(name);
        if (value) {
            json.value(*value);
        } else {
            json.null();
        }
    };
    json.key("error");
    json.open('{');
    write("last", error.last);
    write("total", error.total);
    json.close('}');
}

}  // namespace

std::string format_command(const Command& command) {
    JsonWriter json(JsonWriter::Layout::line);
    json.open('{');
    json.field("cmd", name(command));
    std::visit([&](const auto& c) { FieldWriter(json).write_all(c); }, command);
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
    write_error(json, statistics.error);
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
