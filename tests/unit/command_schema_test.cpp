// The schema of the commands, and everything that follows from it: defaults, limits, help, JSON
// Schema and the table in the README.
#include "command/schema.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "command/check.h"
#include "command/json.h"
#include "command/reference.h"
#include "ffd/handle.h"
#include "ffd/lattice.h"
#include "mesh/shapes.h"
#include "session/session.h"
#include "support/expect_done.h"
#include "support/paths.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

std::string text_of(const std::string& path) {
    std::ifstream file(path);
    EXPECT_TRUE(file) << path;
    return {std::istreambuf_iterator<char>(file), {}};
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != text.npos;
}

// --- What is printed.

void expect_named(const FieldReference& field, const std::string& prefix, const std::string& text) {
    EXPECT_TRUE(contains(text, prefix + field.name)) << prefix + field.name;
    for (const FieldReference& nested : field.nested) {
        expect_named(nested, prefix + field.name + ".", text);
    }
}

TEST(Schema, IsWhatTheHelpOfEachCommandSays) {
    for (const CommandReference& command : command_reference()) {
        const std::string help = help_text(command);
        EXPECT_TRUE(help.starts_with(command.name + "  ")) << help;
        for (const FieldReference& field : command.fields) expect_named(field, "", help);
        for (std::size_t first = 0; first < help.size(); first = help.find('\n', first) + 1) {
            EXPECT_LE(help.find('\n', first) - first, 80u) << help.substr(first, 90);
        }
    }
}

TEST(Schema, IsTheTableInTheReadme) {
    const std::string readme = text_of(test::source_path("README.md"));
    const std::string table = reference_table();
    const std::size_t first = readme.find(table.substr(0, table.find('\n') + 1));
    ASSERT_NE(first, readme.npos) << "the README has no table of the commands";
    const std::string in_readme = readme.substr(first, readme.find("\n\n", first) + 1 - first);
    EXPECT_EQ(in_readme, table) << "paste what `pectin help --table` prints into the README";
    for (const CommandReference& command : command_reference()) {
        EXPECT_TRUE(contains(table, "`" + command.name + "`"));
        for (const FieldReference& field : command.fields) expect_named(field, "", table);
    }
}

void expect_described(const std::vector<FieldReference>& fields, const nlohmann::json& node) {
    for (const FieldReference& field : fields) {
        ASSERT_TRUE(node["properties"].contains(field.name)) << field.name;
        const nlohmann::json& property = node["properties"][field.name];
        // Words that may be listed have descriptions of their own.
        const std::string description = property["description"];
        EXPECT_TRUE(contains(description, field.meaning) || field.meaning.starts_with(description))
            << property;
        const nlohmann::json required = node.value("required", nlohmann::json::array());
        const bool is_required =
            std::find(required.begin(), required.end(), field.name) != required.end();
        EXPECT_EQ(is_required, !field.initial.has_value()) << field.name;
        if (field.nested.empty()) continue;
        const nlohmann::json& object = property.contains("items")   ? property["items"]
                                       : property.contains("anyOf") ? property["anyOf"][1]
                                                                    : property;
        expect_described(field.nested, object);
    }
}

TEST(Schema, IsWhatTheJsonSchemaDescribes) {
    const nlohmann::json schema = nlohmann::json::parse(json_schema());
    std::size_t described = 0;
    for (const nlohmann::json& line : schema["oneOf"]) {
        if (!line["properties"].contains("cmd")) continue;
        EXPECT_EQ(line["additionalProperties"], false);
        const CommandReference* const command =
            find_command(line["properties"]["cmd"]["const"].get<std::string>());
        ASSERT_TRUE(command) << line;
        expect_described(command->fields, line);
        EXPECT_EQ(line["properties"].size(), command->fields.size() + 1);
        ++described;
    }
    EXPECT_EQ(described, command_reference().size());
}

// --- Defaults.

// Reading a command with a default written out gives the command that has the default.
template <typename C>
void expect_true_defaults() {
    for_each_field<C>([](const auto& field) {
        if (field.is_required() || !is_json(field.initial)) return;
        using Member = std::remove_cvref_t<decltype(C{}.*field.member)>;
        using Type = std::remove_cvref_t<decltype(field.type)>;
        if constexpr (!kIsLeftOutIfEmpty<Member, Type>) {
            C changed{};
            if constexpr (requires { changed.path; }) changed.path = "a.png";
            if constexpr (std::is_same_v<C, command::Drag>) changed.moves.resize(1);
            if constexpr (std::is_same_v<C, command::Cage>) changed.fit = IVec3{2};
            std::string line = format_command(changed);
            line.insert(line.size() - 1, ", \"" + std::string(field.name) + "\": " + field.initial);
            const auto read = parse_command(line);
            ASSERT_TRUE(std::holds_alternative<Command>(read))
                << line << ": " << std::get<CommandError>(read).what;
            EXPECT_TRUE(std::get<Command>(read) == Command{changed}) << line;
        }
    });
}

TEST(Schema, HasTheDefaultsOfTheCommands) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (expect_true_defaults<std::variant_alternative_t<I, Command>>(), ...);
    }
    (std::make_index_sequence<std::variant_size_v<Command>>());
}

// The defaults of settings are those of a new session.
TEST(Schema, HasTheDefaultsOfSettings) {
    for (const char* name : {"adapt", "brush", "history"}) {
        std::string line = R"({"cmd": ")" + std::string(name) + '"';
        for (const FieldReference& field : find_command(name)->fields) {
            if (field.initial && is_json(*field.initial)) {
                line += ", \"" + field.name + "\": " + *field.initial;
            }
        }
        const auto read = parse_command(line + '}');
        ASSERT_TRUE(std::holds_alternative<Command>(read)) << line;
        Session changed, fresh;
        test::expect_done(changed, std::get<Command>(read));
        const AdaptSettings &a = changed.adapt_settings(), &b = fresh.adapt_settings();
        EXPECT_TRUE(a == b) << line;
        EXPECT_EQ(changed.lattice_settings().span, fresh.lattice_settings().span);
        EXPECT_EQ(changed.history().limit(), fresh.history().limit());
    }
    EXPECT_STREQ(std::get<2>(Schema<command::Adapt>::kFields).initial, "180/7");
    EXPECT_EQ(Session().adapt_settings().theta_max, Setting::of(180.0 / 7.0));
}

// --- Limits.

TEST(Schema, HasTheLimitsOfWhatTheCommandsUse) {
    const auto& twist = std::get<1>(Schema<Twist>::kFields);
    EXPECT_EQ(twist.type.limits.most, kMostDegrees);
    EXPECT_EQ(twist.type.limits.least, -kMostDegrees);
    const auto& scale = std::get<3>(Schema<Move>::kFields);
    EXPECT_EQ(scale.type.limits.most, kMostScale);
    EXPECT_EQ(scale.type.limits.least, 1.0 / kMostScale);
    for (std::size_t kind = 0; kind < kMostResolutions.size(); ++kind) {
        EXPECT_EQ(kMostResolutions[kind], max_resolution(static_cast<ShapeKind>(kind)));
    }
    EXPECT_LE(std::get<1>(Schema<command::Brush>::kFields).type.most, kMaxDeformable);
    EXPECT_EQ(std::get<2>(Schema<command::Cage>::kFields).type.most, kMaxDeformable);
    EXPECT_EQ(std::get<4>(Schema<command::Cage>::kFields).type.most, kMaxFitted);
}

// Values beyond the limits of a field, and on the wrong side of an excluded one.
class WrongValues {
  public:
    explicit WrongValues(test::Random& random) : random_(random) {}

    void spoil(double& value, const field::Number& type) { value = outside(type.limits); }
    template <typename Integer>
    void spoil(Integer& value, const field::Whole& type) {
        value = type.least > 0.0 ? Integer{0} : static_cast<Integer>(-1);
        if (random_.chance(0.5) && type.most < 1e9) value = static_cast<Integer>(type.most + 1.0);
    }
    void spoil(Setting& value, const field::NumberOr& type) {
        value = Setting::of(outside(type.limits));
        if (!type.may_be_null && random_.chance(0.3)) value = Setting::off();
        if (!type.may_be_auto && random_.chance(0.3)) value = Setting::automatic();
        if (type.is_whole && random_.chance(0.3)) value = Setting::of(1.5);
    }
    void spoil(std::string& value, const field::Path&) { value.clear(); }
    void spoil(Vec3& value, const field::Point& type) {
        if (has_limits(type.limits)) value[random_.integer(0, 2)] = outside(type.limits);
    }
    template <glm::length_t N>
    void spoil(glm::vec<N, int>& value, const field::Counts& type) {
        value[random_.integer(0, static_cast<int>(N) - 1)] =
            random_.chance(0.5) ? type.least - 1 : type.most + 1;
    }
    template <typename T, typename Element>
    void spoil(std::vector<T>& values, const field::List<Element>& type) {
        if (values.empty()) return;
        if (!type.may_be_empty && random_.chance(0.2)) return values.clear();
        spoil(values.back(), type.element);
    }
    template <typename T>
    void spoil(T& object, const field::Object&) {
        spoil_some_field(object);
    }
    template <typename T, typename Type>
    void spoil(T&, const Type&) {}  // no value of this type is wrong

    // Spoils the field with the given number.
    template <typename Owner>
    void spoil_field(Owner& owner, int number) {
        int i = 0;
        for_each_field<Owner>([&](const auto& field) {
            if (i++ == number) spoil(field.add_to(owner), field.type);
        });
    }
    template <typename Owner>
    void spoil_some_field(Owner& owner) {
        constexpr int kFields = std::tuple_size_v<decltype(Schema<Owner>::kFields)>;
        if constexpr (kFields > 0) spoil_field(owner, random_.integer(0, kFields - 1));
    }

  private:
    static bool has_limits(const field::Limits& limits) {
        return limits.least != field::Limits{}.least || limits.most != field::Limits{}.most;
    }
    double outside(const field::Limits& limits) {
        const bool below = limits.least != field::Limits{}.least;
        const bool above = limits.most != field::Limits{}.most;
        if (above && (!below || random_.chance(0.5))) {
            return limits.includes_most ? limits.most + 1.0 : limits.most;
        }
        return limits.includes_least ? limits.least - random_.uniform(0.001, 9.0) : limits.least;
    }

    test::Random& random_;
};

// A command with all fields that may be there together.
template <typename C>
C complete() {
    return C{};
}
template <>
command::Open complete() {
    return {.path = "a.obj"};
}
template <>
command::Shape complete() {
    return {command::Shape::Kind::cube, 2};
}
template <>
command::Drag complete() {
    return {.moves = {{.from = {0, 0, 1}, .to = {0, 0, 2}, .twist = Twist{{0, 0, 1}, 5.0}}},
            .pins = {{1, 0, 0}},
            .via = {{0, 0, 1.5}}};
}
template <>
command::Control complete() {
    return {{{IVec3{0}, Vec3{0.0}}}};
}
template <>
command::Cage complete() {
    return {.origin = Vec3{0.0}, .cell = Vec3{1.0}, .deformable = IVec3{2}};
}
template <>
command::Save complete() {
    return {"a.obj"};
}
template <>
command::Stats complete() {
    return {"a.json"};
}
template <>
command::Screenshot complete() {
    return {.path = "a.png"};
}

// A wrong value is refused by a script and by the session, with the same words, which name the
// field.
template <typename C>
int expect_same_refusals(test::Random& random) {
    int refused = 0;
    constexpr int kFields = std::tuple_size_v<decltype(Schema<C>::kFields)>;
    for (int number = 0; number < kFields; ++number) {
        C command = complete<C>();
        WrongValues(random).spoil_field(command, number);
        const Done checked = check(command);
        if (checked) continue;  // no value of this field is wrong
        ++refused;
        const std::string line = format_command(command);
        const auto read = parse_command(line);
        if (!std::holds_alternative<CommandError>(read)) {
            ADD_FAILURE() << line;
            continue;
        }
        const CommandError& error = std::get<CommandError>(read);
        EXPECT_EQ(error.command, Schema<C>::kName);
        Session session;
        const std::string reason = test::refusal_of(session, command);
        EXPECT_EQ(error.what, reason) << line;
        int i = 0;
        for_each_field<C>([&](const auto& field) {
            if (i++ == number && !contains(reason, "give either")) {
                EXPECT_TRUE(reason.starts_with(field.name)) << reason;
                EXPECT_TRUE(checked.refusal().field.starts_with(field.name)) << reason;
            }
        });
    }
    return refused;
}

TEST(Schema, HasLimitsThatScriptsAndTheSessionRefuseWithTheSameWords) {
    test::Random random(4711);
    int refused = 0;
    for (int round = 0; round < test::case_count(200); ++round) {
        [&]<std::size_t... I>(std::index_sequence<I...>) {
            ((refused += expect_same_refusals<std::variant_alternative_t<I, Command>>(random)),
             ...);
        }
        (std::make_index_sequence<std::variant_size_v<Command>>());
    }
    EXPECT_GT(refused, 20 * test::case_count(200));
}

TEST(Schema, HasLimitsForEachShape) {
    using Kind = command::Shape::Kind;
    EXPECT_TRUE(check(command::Shape{Kind::sphere, 0}));
    EXPECT_TRUE(check(command::Shape{Kind::plane, 1732}));
    for (const command::Shape& wrong :
         {command::Shape{Kind::sphere, 10}, command::Shape{Kind::cube, 0},
          command::Shape{Kind::torus, 613}, command::Shape{Kind::cylinder, 501}}) {
        EXPECT_EQ(check(wrong).refusal().field, "resolution");
    }
}

TEST(Schema, AcceptsExtensionsInCapitals) {
    EXPECT_TRUE(check(command::Screenshot{.path = "Photo.PNG"}));
    EXPECT_FALSE(check(command::Screenshot{.path = "Photo.jpg"}));
    EXPECT_FALSE(check(command::Screenshot{.path = "png"}));
}

TEST(Schema, RefusesWhatIsNotFinite) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const command::Drag complete_drag = complete<command::Drag>();
    for (const double wrong : {kInfinity, -kInfinity, std::nan("")}) {
        EXPECT_FALSE(check(command::Brush{.radius = wrong}));
        EXPECT_FALSE(check(command::Adapt{.theta_max = Setting::of(wrong)}));
        command::Drag drag = complete_drag;
        drag.moves[0].to.y = wrong;
        EXPECT_EQ(check(drag).refusal().field, "moves[0].to[1]");
        drag = complete_drag;
        drag.pins[0].z = wrong;
        EXPECT_EQ(check(drag).refusal().field, "pins[0][2]");
    }
    EXPECT_TRUE(check(complete_drag));
}

}  // namespace
}  // namespace pectin
