// The JSON Schema of a line of a script, from the schema of the commands.
//
// Source: A. Wright, H. Andrews, B. Hutton, G. Dennis. JSON Schema: A Media Type for Describing
// JSON Documents. Draft 2020-12.
#include <cctype>
#include <string>
#include <utility>
#include <variant>

#include "command/json_values.h"
#include "command/reference.h"
#include "command/schema.h"

namespace pectin {
namespace {

using command_json::json;
using Node = nlohmann::ordered_json;

class SchemaWriter {
  public:
    // An object with the fields of Owner, and no others.
    template <typename Owner>
    static Node object() {
        Node node{{"type", "object"}, {"description", Schema<Owner>::kMeaning}};
        Node& properties = node["properties"] = Node::object();
        Node required = Node::array();
        for_each_field<Owner>([&](const auto& field) {
            Node property = value_of(field.type, field.any_value());
            property["description"] = describe(field);
            if (has_default(field)) property["default"] = Node::parse(field.initial);
            properties[field.name] = std::move(property);
            if (field.is_required()) required.push_back(field.name);
        });
        if (!required.empty()) node["required"] = std::move(required);
        node["additionalProperties"] = false;
        return node;
    }

  private:
    // A setting that is left out does not change, so its initial value is no default.
    template <typename Owner, typename Member, typename Type>
    static bool has_default(const Field<Owner, Member, Type>& field) {
        return !kIsLeftOutIfEmpty<Member, Type> && field.initial && json::accept(field.initial);
    }
    template <typename AnyField>
    static std::string describe(const AnyField& field) {
        if (!field.initial || has_default(field)) return field.meaning;
        return std::string(field.meaning) + " At the start: " + field.initial + ".";
    }

    static Node number(const field::Limits& limits, bool is_whole) {
        constexpr field::Limits kNone{};
        Node node{{"type", is_whole ? "integer" : "number"}};
        if (limits.least != kNone.least)
            node[limits.includes_least ? "minimum" : "exclusiveMinimum"] = limits.least;
        if (limits.most != kNone.most)
            node[limits.includes_most ? "maximum" : "exclusiveMaximum"] = limits.most;
        return node;
    }
    static Node array(Node items, std::size_t count) {
        return {{"type", "array"},
                {"items", std::move(items)},
                {"minItems", count},
                {"maxItems", count}};
    }

    template <typename T>
    static Node value_of(const field::Number& type, const T&) {
        return number(type.limits, false);
    }
    template <typename T>
    static Node value_of(const field::Whole& type, const T&) {
        return number(field::between(type.least, type.most), true);
    }
    template <typename T>
    static Node value_of(const field::NumberOr& type, const T&) {
        Node any = Node::array({number(type.limits, type.is_whole)});
        if (type.may_be_auto) any.push_back({{"const", "auto"}});
        if (type.may_be_null) any.push_back({{"type", "null"}});
        return {{"anyOf", std::move(any)}};
    }
    template <typename T>
    static Node value_of(const field::Flag&, const T&) {
        return {{"type", "boolean"}};
    }
    template <typename T, std::size_t N>
    static Node value_of(const field::Choice<N>& type, const T&) {
        return {{"enum", type.words}};
    }
    template <typename T, std::size_t N>
    static Node value_of(const field::ChoiceOrNull<N>& type, const std::optional<T>&) {
        Node words = type.words;
        words.push_back(nullptr);
        return {{"enum", std::move(words)}};
    }
    template <typename T>
    static Node value_of(const field::Path& type, const T&) {
        Node node{{"type", "string"}, {"minLength", 1}};
        if (type.extension) node["pattern"] = pattern_of(type.extension);
        return node;
    }
    // Of paths that end so, in capitals or not.
    static std::string pattern_of(const std::string& extension) {
        std::string pattern = "\\.";
        for (const char c : extension.substr(1)) {
            pattern +=
                {'[', c, static_cast<char>(std::toupper(static_cast<unsigned char>(c))), ']'};
        }
        return pattern + '$';
    }
    template <typename T>
    static Node value_of(const field::Point& type, const T&) {
        return array(number(type.limits, false), 3);
    }
    template <glm::length_t N>
    static Node value_of(const field::Counts& type, const glm::vec<N, int>&) {
        return array(number(field::between(type.least, type.most), true),
                     static_cast<std::size_t>(N));
    }
    template <typename T, typename Element>
    static Node value_of(const field::List<Element>& type, const std::vector<T>&) {
        Node node{{"type", "array"}, {"items", value_of(type.element, T{})}};
        if (!type.may_be_empty) node["minItems"] = 1;
        return node;
    }
    template <typename T>
    static Node value_of(const field::Object&, const T&) {
        return object<T>();
    }
    template <typename T>
    static Node value_of(const field::ObjectOr& type, const std::optional<T>&) {
        return {{"anyOf", Node::array({Node{{"const", type.word}}, object<T>()})}};
    }
    template <typename T>
    static Node value_of(const field::Names&, const T&) {
        Node names = Node::array();
        for_each_field<T>([&](const auto& field) {
            names.push_back(Node{{"const", field.name}, {"description", field.meaning}});
        });
        return {{"type", "array"}, {"items", {{"anyOf", std::move(names)}}}};
    }
};

template <typename C>
Node command_node() {
    Node node = SchemaWriter::object<C>();
    Node properties{{"cmd", {{"const", Schema<C>::kName}}}};
    properties.update(node["properties"]);
    node["properties"] = std::move(properties);
    Node required = Node::array({"cmd"});
    if (node.contains("required")) {
        for (const Node& name : node["required"]) required.push_back(name);
    }
    node["required"] = std::move(required);
    return node;
}

// What check() demands beside the schema of the fields.
void add_forms_of_cage(Node& cage) {
    const Node none{{"const", {0, 0, 0}}};
    const Node any_of_grid =
        Node::array({Node{{"required", {"origin"}}}, Node{{"required", {"cell"}}},
                     Node{{"required", {"deformable"}}}});
    const Node fitted{{"required", {"fit"}},
                      {"properties", {{"margin", none}}},
                      {"not", {{"anyOf", any_of_grid}}}};
    const Node grid{{"required", {"origin", "cell", "deformable"}},
                    {"not", {{"required", {"fit"}}}}};
    cage["oneOf"] = Node::array({grid, fitted});
}

void add_resolutions_of_shape(Node& shape) {
    const auto& words = std::get<0>(Schema<command::Shape>::kFields).type.words;
    Node rules = Node::array();
    for (std::size_t kind = 0; kind < words.size(); ++kind) {
        const Node limits{{"minimum", kind == 0 ? 0 : 1}, {"maximum", kMostResolutions[kind]}};
        rules.push_back({{"if", {{"properties", {{"kind", {{"const", words[kind]}}}}}}},
                         {"then", {{"properties", {{"resolution", limits}}}}}});
    }
    shape["allOf"] = std::move(rules);
}

Node header_node() {
    return {{"type", "object"},
            {"description", "The first line of a script."},
            {"properties", {{"pectin", {{"const", 1}}}}},
            {"required", {"pectin"}},
            {"additionalProperties", false}};
}

}  // namespace

std::string json_schema() {
    Node lines = Node::array({header_node()});
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (lines.push_back(command_node<std::variant_alternative_t<I, Command>>()), ...);
    }
    (std::make_index_sequence<std::variant_size_v<Command>>());
    for (Node& line : lines) {
        if (line["properties"].contains("fit")) add_forms_of_cage(line);
        if (line["properties"].contains("resolution")) add_resolutions_of_shape(line);
    }
    const Node schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                      {"title", "A line of a pectin script"},
                      {"description", "Lengths are in the model's units, angles in degrees."},
                      {"oneOf", std::move(lines)}};
    return schema.dump(2) + "\n";
}

}  // namespace pectin
