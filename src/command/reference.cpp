#include "command/reference.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>

#include "command/schema.h"

namespace pectin {
namespace {

// What a field has to be in words, the fields of objects in it, and what its words mean.
struct Described {
    std::string right;
    std::vector<FieldReference> nested{};
    std::string words{};
};

class Describer {
  public:
    template <typename Owner>
    static std::vector<FieldReference> all_fields() {
        std::vector<FieldReference> fields;
        for_each_field<Owner>([&](const auto& field) {
            Described described = describe(field.type, field.any_value());
            fields.push_back({.name = field.name,
                              .right = std::move(described.right),
                              .initial = field.is_required()
                                             ? std::nullopt
                                             : std::optional<std::string>(field.initial),
                              .meaning = field.meaning + described.words,
                              .nested = std::move(described.nested)});
        });
        return fields;
    }

  private:
    template <typename Type, typename T>
    static Described describe(const Type& type, const T&) {
        return {right(type)};
    }
    template <glm::length_t N>
    static Described describe(const field::Counts& type, const glm::vec<N, int>&) {
        return {right(type, static_cast<std::size_t>(N))};
    }
    template <typename T, typename Element>
    static Described describe(const field::List<Element>& type, const std::vector<T>&) {
        const std::string count = type.may_be_empty ? "" : "one or more ";
        return {"an array of " + count + plural(type.element),
                std::move(describe(type.element, T{}).nested)};
    }
    static const char* plural(const field::Point&) { return "points"; }
    static const char* plural(const field::Object&) { return "objects"; }
    template <typename T>
    static Described describe(const field::Object&, const T&) {
        return {"an object", all_fields<T>()};
    }
    template <typename T>
    static Described describe(const field::ObjectOr& type, const std::optional<T>&) {
        return {'"' + std::string(type.word) + "\" or an object", all_fields<T>()};
    }
    template <typename T>
    static Described describe(const field::Names&, const T&) {
        std::vector<std::string> words;
        std::string meanings;
        for (const FieldReference& name : all_fields<T>()) {
            words.push_back('"' + name.name + '"');
            meanings += " " + words.back() + ": " + name.meaning;
        }
        return {.right = "an array of any of " + field::listed(words, "and"), .words = meanings};
    }
};

template <std::size_t... I>
std::vector<CommandReference> make_reference(std::index_sequence<I...>) {
    return {[] {
        using C = std::variant_alternative_t<I, Command>;
        return CommandReference{Schema<C>::kName, Schema<C>::kMeaning, Describer::all_fields<C>()};
    }()...};
}

// --- Text.

constexpr std::size_t kColumns = 80;

// The text in lines that begin with `indent` spaces, the first of them excepted.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t column) {
    std::string lines;
    for (std::size_t first = 0; first < text.size();) {
        const std::size_t end = std::min(text.find(' ', first), text.size());
        const std::string word = text.substr(first, end - first);
        if (column + word.size() + 1 > kColumns) {
            lines += '\n' + std::string(indent, ' ');
            column = indent;
        } else if (first > 0) {
            lines += ' ';
            ++column;
        }
        lines += word;
        column += word.size();
        first = end + 1;
    }
    return lines;
}

std::string right_and_default(const FieldReference& field) {
    if (!field.initial) return field.right;
    return field.right + " (" + *field.initial + ")";
}

void append_help(const FieldReference& field, const std::string& prefix, std::string& text) {
    const std::string name = prefix + field.name;
    text += "    " + name + "\n        ";
    text += wrapped(right_and_default(field) + ". " + field.meaning, 8, 8) + "\n";
    for (const FieldReference& nested : field.nested) append_help(nested, name + ".", text);
}

// `|` would end a cell.
std::string cell(std::string text) {
    for (std::size_t at = 0; (at = text.find('|', at)) != text.npos; at += 2) text.insert(at, "\\");
    return text;
}

void append_rows(const FieldReference& field, const std::string& prefix, std::string& table) {
    const std::string name = prefix + field.name;
    table += "| | `" + name + "` | " + cell(field.right) + " | " +
             cell(field.initial.value_or("required")) + " | " + cell(field.meaning) + " |\n";
    for (const FieldReference& nested : field.nested) append_rows(nested, name + ".", table);
}

}  // namespace

std::span<const CommandReference> command_reference() {
    static const std::vector<CommandReference> kReference =
        make_reference(std::make_index_sequence<std::variant_size_v<Command>>());
    return kReference;
}

const CommandReference* find_command(std::string_view name) {
    const auto all = command_reference();
    const auto found = std::ranges::find(all, name, &CommandReference::name);
    return found == all.end() ? nullptr : &*found;
}

std::string help_text(const CommandReference& command) {
    std::string text = command.name + "  " +
                       wrapped(command.meaning, command.name.size() + 2, command.name.size() + 2) +
                       "\n";
    for (const FieldReference& field : command.fields) append_help(field, "", text);
    return text;
}

std::string reference_table() {
    std::string table =
        "| cmd | field | value | default | meaning |\n"
        "|---|---|---|---|---|\n";
    for (const CommandReference& command : command_reference()) {
        table += "| `" + command.name + "` | | | | " + cell(command.meaning) + " |\n";
        for (const FieldReference& field : command.fields) append_rows(field, "", table);
    }
    return table;
}

}  // namespace pectin
