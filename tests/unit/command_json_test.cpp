#include "command/json.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "command/reference.h"
#include "support/test_run.h"

namespace pectin {
namespace {

Command parsed(const std::string& line) {
    const auto result = parse_command(line);
    if (const auto* error = std::get_if<CommandError>(&result)) {
        ADD_FAILURE() << line << ": " << error->what;
        return command::Readapt{};
    }
    return std::get<Command>(result);
}

// ---- Round trip

class RandomCommand {
  public:
    explicit RandomCommand(std::uint64_t seed) : bits_(seed) {}

    Command operator()() {
        switch (below(16)) {
            case 0:
                return command::Open{text(), from(0.0, 180.0)};
            case 1:
                return command::Shape{static_cast<command::Shape::Kind>(below(5)), 1 + below(9)};
            case 2:
                return adapt();
            case 3:
                return command::Brush{maybe(positive()), maybe(1 + below(16)),
                                      maybe(static_cast<Falloff>(below(2)))};
            case 4:
                return cage();
            case 5:
                return drag();
            case 6:
                return command::Undo{1 + below(1 << 30)};
            case 7:
                return command::Redo{std::numeric_limits<int>::max() - below(9)};
            case 8:
                return command::Readapt{};
            case 9:
                return command::Save{text()};
            case 10:
                return screenshot();
            case 11:
                return command::Symmetry{maybe(static_cast<command::Symmetry::Plane>(below(3))),
                                         point()};
            case 12:
                return control();
            case 13:
                return command::Bake{};
            case 14:
                return command::History{maybe(below(2) ? Setting::off() : Setting::of(positive()))};
            default:
                return command::Stats{text()};
        }
    }

  private:
    int below(int count) { return static_cast<int>(bits_() % static_cast<std::uint64_t>(count)); }
    template <class T>
    std::optional<T> maybe(T value) {
        return below(2) ? std::optional<T>(value) : std::nullopt;
    }
    double from(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(bits_);
    }
    // Any finite number of any magnitude. Most need 17 digits.
    double number() {
        if (below(4) == 0) return below(2001) - 1000;
        const double x = std::bit_cast<double>(bits_());
        return std::isfinite(x) ? x : -0.0;
    }
    double positive() {
        const double x = std::abs(number());
        return x > 0.0 ? x : std::numeric_limits<double>::denorm_min();
    }
    Vec3 point() { return {number(), number(), number()}; }
    IVec3 counts() { return {1 + below(64), 1 + below(64), 1 + below(64)}; }
    std::string text() {
        const std::array<std::string, 8> pieces{"a",  "\"",   "\\",       "/",
                                                "\n", "\x01", "\xC3\xA9", " "};
        std::string result = "x";
        for (int i = below(8); i > 0; --i) result += pieces[static_cast<std::size_t>(below(8))];
        return result;
    }
    Command adapt() {
        command::Adapt result;
        result.enabled = maybe(below(2) == 0);
        result.theta_max = maybe(below(2) ? Setting::off() : Setting::of(from(90.0, 400.0)));
        result.theta_min = maybe(below(2) ? Setting::automatic() : Setting::of(from(0.0, 90.0)));
        result.trigger = maybe(static_cast<command::Adapt::Trigger>(below(2)));
        result.tolerance = maybe(below(2) ? Setting::automatic() : Setting::of(positive()));
        result.l_max = maybe(below(2) ? Setting::automatic() : Setting::of(positive()));
        result.flatness = maybe(below(2) ? Setting::off() : Setting::of(std::abs(number())));
        result.floor = maybe(below(2) ? Setting::automatic() : Setting::of(positive()));
        result.budget = maybe(1 + bits_() % (std::uint64_t{1} << 53));
        result.drag_budget = maybe(below(3) == 0 ? Setting::automatic()
                                   : below(2)    ? Setting::off()
                                                 : Setting::of(1 + below(9999)));
        result.propagation = maybe(from(1.0, 1.49));
        return result;
    }
    Command cage() {
        if (below(2)) return command::Cage{.fit = counts()};
        const Vec3 cell{positive(), positive(), positive()};
        return command::Cage{.origin = point(),
                             .cell = cell,
                             .deformable = counts(),
                             .margin = IVec3(int(below(3)), int(below(3)), int(below(3)))};
    }
    Command drag() {
        command::Drag result;
        for (int i = 1 + below(3); i > 0; --i) {
            result.moves.push_back({.from = point(), .to = point()});
            if (below(2))
                result.moves.back().twist = {point() + Vec3{0.0, 0.0, 1.0}, from(-3600.0, 3600.0)};
            if (below(2)) result.moves.back().scale = from(0.001, 1000.0);
            if (result.moves.back().twist && result.moves.back().twist->axis == Vec3{0.0}) {
                result.moves.back().twist.reset();
            }
        }
        for (int i = below(3); i > 0; --i) result.pins.push_back(point());
        for (int i = below(3); i > 0; --i) result.via.push_back(point());
        result.connected = below(2) == 0;
        result.fold_free = below(2) == 0;
        return result;
    }
    Command control() {
        command::Control result;
        for (int i = 1 + below(3); i > 0; --i) {
            result.points.push_back({counts() - 1, point()});
        }
        return result;
    }

    Command screenshot() {
        command::Screenshot result{.path = text() + ".png"};
        result.size = {16 + below(8177), 16 + below(8177)};
        const Vec3 eye{from(-9.0, 9.0), from(-9.0, 9.0), 1.0 + from(0.0, 1e9)};
        if (below(2)) result.camera = Camera{.eye = eye, .fov = from(1.0, 170.0)};
        if (result.camera && below(2)) result.camera->projection = Projection::orthographic;
        result.show = {below(2) == 0, below(2) == 0, below(2) == 0};
        return result;
    }

    std::mt19937_64 bits_;
};

TEST(CommandJson, ParsesFormattedCommandsBackToEqualOnes) {
    const std::uint64_t seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    RecordProperty("seed", std::to_string(seed));
    RandomCommand random_command(seed);
    const int count = test::is_long() ? 200'000 : 5'000;
    for (int i = 0; i < count; ++i) {
        const Command command = random_command();
        const std::string line = format_command(command);
        ASSERT_EQ(line.find('\n'), line.npos) << line;
        ASSERT_TRUE(parsed(line) == command) << line;
        ASSERT_EQ(format_command(parsed(line)), line);
    }
}

TEST(CommandJson, WritesShortestNumbersAndOmitsEmptyFields) {
    const command::Drag drag{.moves = {{.from = Vec3(0, 0, 1), .to = Vec3(0.1, 0, -1.3)}},
                             .pins = {}};
    EXPECT_EQ(format_command(drag),
              R"({"cmd": "drag", "moves": [{"from": [0, 0, 1], "to": [0.1, 0, -1.3]}]})");
    EXPECT_EQ(format_command(command::Readapt{}), R"({"cmd": "readapt"})");
    EXPECT_EQ(format_command(command::Adapt{.theta_max = Setting::off()}),
              R"({"cmd": "adapt", "theta_max": null})");
}

TEST(CommandJson, KeepsTheSignOfZero) {
    const Command command =
        command::Drag{.moves = {{.from = Vec3(-0.0), .to = Vec3(1)}}, .pins = {}};
    const Command back = parsed(format_command(command));
    EXPECT_TRUE(std::signbit(std::get<command::Drag>(back).moves[0].from.x));
}

TEST(CommandJson, NamesEveryCommandAsTheReferenceDoes) {
    EXPECT_EQ(command_reference().size(), std::variant_size_v<Command>);
    EXPECT_STREQ(name(command::Open{}), "open");
    EXPECT_STREQ(name(command::Brush{}), "brush");
    EXPECT_STREQ(name(command::History{}), "history");
    EXPECT_STREQ(name(command::Readapt{}), "readapt");
    EXPECT_STREQ(name(command::Stats{}), "stats");
    EXPECT_STREQ(name(command::Screenshot{}), "screenshot");
}

TEST(CommandJson, FillsOmittedFieldsWithTheirDefaults) {
    EXPECT_TRUE(parsed(R"({"cmd": "undo"})") == Command(command::Undo{.count = 1}));
    EXPECT_TRUE(parsed(R"({"path": "a.obj", "cmd": "open"})") ==
                Command(command::Open{.path = "a.obj", .crease_angle = 45.0}));
    EXPECT_TRUE(parsed(R"({"cmd": "adapt"})") == Command(command::Adapt{}));
}

TEST(CommandJson, AcceptsWholeNumbersInAnyNotation) {
    EXPECT_TRUE(parsed(R"({"cmd": "adapt", "budget": 1e6})") ==
                Command(command::Adapt{.budget = 1'000'000}));
    EXPECT_TRUE(parsed(R"({"cmd": "brush", "span": 5.0, "radius": 1})") ==
                Command(command::Brush{.radius = 1.0, .span = 5}));
}

TEST(CommandJson, DistinguishesAutomaticOffAndNumbers) {
    EXPECT_TRUE(parsed(R"({"cmd": "adapt", "theta_min": null, "l_max": "auto", "flatness": 0})") ==
                Command(command::Adapt{.theta_min = Setting::off(),
                                       .l_max = Setting::automatic(),
                                       .flatness = Setting::of(0.0)}));
    EXPECT_TRUE(parsed(R"({"cmd": "adapt", "theta_max": 180})") ==
                Command(command::Adapt{.theta_max = Setting::of(180.0)}));
    EXPECT_TRUE(parsed(R"({"cmd": "history", "megabytes": null})") ==
                Command(command::History{Setting::off()}));
    EXPECT_TRUE(parsed(R"({"cmd": "history", "megabytes": 0.5})") ==
                Command(command::History{Setting::of(0.5)}));
    EXPECT_TRUE(parsed(R"({"cmd": "history"})") == Command(command::History{}));
}

// ---- Errors

struct BadLine {
    std::string line, command;
    std::vector<std::string> said;  // parts of the message: what is wrong and what would be right
};

void expect_error(const BadLine& bad) {
    const auto result = parse_command(bad.line);
    ASSERT_TRUE(std::holds_alternative<CommandError>(result)) << bad.line;
    const CommandError& error = std::get<CommandError>(result);
    EXPECT_EQ(error.command, bad.command) << bad.line;
    for (const std::string& words : bad.said)
        EXPECT_NE(error.what.find(words), error.what.npos)
            << bad.line << "\nsays: " << error.what << "\nnot: " << words;
    EXPECT_EQ(error.what.find_first_of("\n\r"), error.what.npos);
    EXPECT_EQ(error.what.find("json.exception"), error.what.npos);
    EXPECT_LT(error.what.size(), 250u);
}

TEST(CommandErrors, SayWhyALineIsNotACommand) {
    for (const BadLine& bad :
         {BadLine{"", "script", {"not valid JSON", "unexpected end of input"}},
          BadLine{"hello", "script", {"not valid JSON at column 1"}},
          BadLine{R"({"cmd": "undo")", "script", {"not valid JSON at column 15", "expected"}},
          BadLine{R"({"cmd": "undo"} x)", "script", {"not valid JSON", "expected end of input"}},
          BadLine{R"({"cmd": "undo"} {})", "script", {"not valid JSON", "expected end of input"}},
          BadLine{R"({"cmd": "brush", "radius": NaN})", "script", {"not valid JSON"}},
          BadLine{R"({"cmd": "brush", "radius": Infinity})", "script", {"not valid JSON"}},
          BadLine{"{\"cmd\": \"save\", \"path\": \"\xFF\"}", "script", {"UTF-8"}},
          BadLine{R"({"cmd": "brush", "radius": 1e400})", "script", {"1e400", "too large"}},
          BadLine{"{\"cmd\": \"brush\", \"radius\": 1" + std::string(999, '0') + "}",
                  "script",
                  {"too large"}},
          BadLine{std::string(100'000, '['), "script", {"not valid JSON"}},
          BadLine{"[1]", "script", {"must be an object", "not an array of length 1"}},
          BadLine{"3", "script", {"must be an object", "not 3"}},
          BadLine{"{}", "script", {"cmd is missing", "a command's name"}},
          BadLine{R"({"cmd": null})", "script", {"cmd must be a command's name", "not null"}},
          BadLine{R"({"cmd": "undo", "cmd": "redo"})", "script", {"\"cmd\" is given twice"}},
          BadLine{R"({"cmd": "drag", "moves": [{"from": [0,0,0], "from": [0,0,0]}]})",
                  "script",
                  {"\"from\" is given twice"}},
          BadLine{R"({"cmd": "redu"})", "redu", {"unknown command", "did you mean redo?", "known"}},
          BadLine{R"({"cmd": "Save"})", "Save", {"did you mean save?"}},
          BadLine{R"({"cmd": "photograph"})", "photograph", {"unknown command", "open, shape"}},
          BadLine{R"({"cmd": "a\nb"})", "script", {R"("a\nb" is an unknown command)"}}})
        expect_error(bad);
}

TEST(CommandErrors, NameTheFieldItsValueAndWhatWouldBeRight) {
    for (const BadLine& bad :
         {BadLine{R"({"cmd": "undo", "times": 2})", "undo", {"unknown field \"times\"", "count"}},
          BadLine{R"({"cmd": "readapt", "count": 2})", "readapt", {"has no fields"}},
          BadLine{R"({"cmd": "open"})", "open", {"path is missing", "the path of an OBJ file"}},
          BadLine{R"({"cmd": "open", "path": ""})", "open", {"path must be", "an empty string"}},
          BadLine{R"({"cmd": "open", "path": 3})", "open", {"path must be", "not 3"}},
          BadLine{R"({"cmd": "save", "path": "a\u0000b"})", "save", {"NUL"}},
          BadLine{R"({"cmd": "stats", "path": []})", "stats", {"not an empty array"}},
          BadLine{R"({"cmd": "open", "path": "a", "crease_angle": 181})", "open", {"0 to 180"}},
          BadLine{R"({"cmd": "shape", "resolution": 1})", "shape", {"kind is missing", "sphere"}},
          BadLine{R"({"cmd": "shape", "kind": "cone", "resolution": 1})", "shape", {"\"cone\""}},
          BadLine{R"({"cmd": "shape", "kind": "cube"})", "shape", {"resolution is missing"}},
          BadLine{R"({"cmd": "shape", "kind": "cube", "resolution": -1})", "shape", {"not -1"}},
          BadLine{R"({"cmd": "shape", "kind": "cube", "resolution": 1.5})", "shape", {"whole"}},
          BadLine{R"({"cmd": "shape", "kind": "cube", "resolution": 3e9})",
                  "shape",
                  {"from 0 to 1732"}},
          BadLine{
              R"({"cmd": "brush", "radius": "1"})", "brush", {"radius", "not a string (\"1\")"}},
          BadLine{R"({"cmd": "brush", "radius": null})", "brush", {"a length above 0, not null"}},
          BadLine{R"({"cmd": "brush", "radius": 0})", "brush", {"a length above 0, not 0"}},
          BadLine{R"({"cmd": "brush", "span": 17})", "brush", {"span", "from 1 to 16, not 17"}},
          BadLine{R"({"cmd": "undo", "count": 0})", "undo", {"count", "from 1"}},
          BadLine{R"({"cmd": "redo", "count": true})", "redo", {"count", "not true"}}})
        expect_error(bad);
}

TEST(CommandErrors, KeepSettingsInTheirRanges) {
    for (const BadLine& bad :
         {BadLine{R"({"cmd": "adapt", "enabled": 1})", "adapt", {"enabled must be true or false"}},
          BadLine{R"({"cmd": "adapt", "trigger": "normal"})",
                  "adapt",
                  {"trigger", "normals, midpoint or certified"}},
          BadLine{R"({"cmd": "adapt", "tolerance": null})",
                  "adapt",
                  {"tolerance", "above 0 or \"auto\""}},
          BadLine{R"({"cmd": "adapt", "theta_max": 0})", "adapt", {"theta_max", "above 0 or null"}},
          BadLine{R"({"cmd": "adapt", "theta_max": "auto"})", "adapt", {"theta_max", "\"auto\""}},
          BadLine{R"({"cmd": "adapt", "theta_min": -1})", "adapt", {"theta_min", "at least 0"}},
          BadLine{R"({"cmd": "adapt", "theta_min": "off"})", "adapt", {"\"auto\" or null"}},
          BadLine{R"({"cmd": "adapt", "theta_max": 9, "theta_min": 9})",
                  "adapt",
                  {"theta_min must be below theta_max", "9 against 9"}},
          BadLine{R"({"cmd": "adapt", "l_max": 0})", "adapt", {"l_max", "above 0"}},
          BadLine{R"({"cmd": "adapt", "flatness": -0.1})", "adapt", {"flatness", "at least 0"}},
          BadLine{R"({"cmd": "adapt", "floor": null})", "adapt", {"floor", "\"auto\", not null"}},
          BadLine{R"({"cmd": "adapt", "budget": 0})", "adapt", {"budget", "whole number from 1"}},
          BadLine{R"({"cmd": "adapt", "budget": 1e300})", "adapt", {"9007199254740992"}},
          BadLine{R"({"cmd": "adapt", "drag_budget": 0})", "adapt", {"drag_budget", "from 1 to"}},
          BadLine{R"({"cmd": "adapt", "drag_budget": 1.5})", "adapt", {"whole number", "or null"}},
          BadLine{R"({"cmd": "adapt", "propagation": 1.5})", "adapt", {"below 1.5"}},
          BadLine{R"({"cmd": "adapt", "propagation": 0.99})", "adapt", {"at least 1"}},
          BadLine{R"({"cmd": "history", "megabytes": 0})", "history", {"above 0 or null, not 0"}},
          BadLine{R"({"cmd": "history", "megabytes": "auto"})", "history", {"not \"auto\""}},
          BadLine{R"({"cmd": "history", "megabytes": true})", "history", {"above 0", "not true"}},
          BadLine{R"({"cmd": "history", "limit": 5})", "history", {"\"limit\"", "megabytes"}}})
        expect_error(bad);
}

TEST(CommandErrors, NameThePositionInsideLatticesAndPoints) {
    for (
        const BadLine& bad :
        {BadLine{R"({"cmd": "cage"})", "cage", {"no lattice", "either", "fit"}},
         BadLine{R"({"cmd": "cage", "fit": [1,1,1], "cell": [1,1,1]})", "cage", {"both"}},
         BadLine{R"({"cmd": "cage", "fit": [1,1]})", "cage", {"three whole", "length 2"}},
         BadLine{R"({"cmd": "cage", "fit": [1,1,255]})", "cage", {"fit[2]", "1 to 254"}},
         BadLine{R"({"cmd": "cage", "fit": [1,1,1], "margin": [1,1,1]})", "cage", {"both"}},
         BadLine{
             R"({"cmd": "cage", "origin": [0,0,0], "cell": [1,1,1], "deformable": [1,1,1], "margin": [0,3,0]})",
             "cage",
             {"margin[1]", "0 to 2"}},
         BadLine{R"({"cmd": "cage", "origin": [0,0,0], "cell": [1,1,1]})", "cage", {"deformable"}},
         BadLine{R"({"cmd": "cage", "origin": [0,0,0], "cell": [1,0,1], "deformable": [1,1,1]})",
                 "cage",
                 {"cell[1] must be a number above 0"}},
         BadLine{R"({"cmd": "drag"})", "drag", {"moves is missing"}},
         BadLine{R"({"cmd": "drag", "moves": []})", "drag", {"one or more", "empty array"}},
         BadLine{R"({"cmd": "drag", "moves": [[0,0,0]]})", "drag", {"moves[0] must be an object"}},
         BadLine{
             R"({"cmd": "drag", "moves": [{"from": [0,0,0]}]})", "drag", {"moves[0].to is mis"}},
         BadLine{R"({"cmd": "drag", "moves": [{"from": [0,0,0], "to": [0,0]}]})",
                 "drag",
                 {"moves[0].to", "three numbers", "length 2"}},
         BadLine{R"({"cmd": "drag", "moves": [{"from": [0,0,0], "to": [0,0,"1"]}]})",
                 "drag",
                 {"moves[0].to[2] must be a number"}},
         BadLine{R"({"cmd": "drag", "moves": [{"from": [0,0,0], "to": [0,0,0], "via": 1}]})",
                 "drag",
                 {"moves[0]", "unknown field \"via\"", "from, to, twist and scale"}},
         BadLine{R"({"cmd": "drag", "moves": [{"from": [0,0,0], "to": [0,0,0], "scale": 0}]})",
                 "drag",
                 {"moves[0].scale must be a number from 0.001 to 1000"}},
         BadLine{R"({"cmd": "drag", "moves": [{"from": [0,0,0], "to": [0,0,0],
                      "twist": {"axis": [0,0,0], "degrees": 3}}]})",
                 "drag",
                 {"moves[0].twist.axis must have a length"}},
         BadLine{R"({"cmd": "drag", "moves": [{"from": [0,0,0], "to": [0,0,0],
                      "twist": {"axis": [0,0,1]}}]})",
                 "drag",
                 {"moves[0].twist.degrees is missing"}},
         BadLine{R"({"cmd": "drag", "moves": [{"from": [0,0,0], "to": [0,0,0],
                      "twist": {"axis": [0,0,1], "angle": 1}}]})",
                 "drag",
                 {"moves[0].twist", "unknown field \"angle\"", "axis and degrees"}},
         BadLine{R"({"cmd": "drag", "moves": [{"from": [0,0,0], "to": [0,0,0]}], "via": [1]})",
                 "drag",
                 {"via[0] must be a point"}},
         BadLine{R"({"cmd": "drag", "moves": [{"from": [0,0,0], "to": [0,0,0]}], "fold_free": 1})",
                 "drag",
                 {"fold_free must be true or false"}},
         BadLine{R"({"cmd": "symmetry"})", "symmetry", {"plane is missing", "\"x\""}},
         BadLine{R"({"cmd": "symmetry", "plane": "w"})", "symmetry", {"plane must be", "\"w\""}},
         BadLine{R"({"cmd": "symmetry", "plane": null, "through": 1})", "symmetry", {"through"}},
         BadLine{R"({"cmd": "control"})", "control", {"points is missing"}},
         BadLine{R"({"cmd": "control", "points": []})", "control", {"one or more"}},
         BadLine{R"({"cmd": "control", "points": [{"index": [0,0], "to": [0,0,0]}]})",
                 "control",
                 {"points[0].index must be an array of three"}},
         BadLine{R"({"cmd": "control", "points": [{"index": [0,0,256], "to": [0,0,0]}]})",
                 "control",
                 {"points[0].index[2]", "from -2 to 255"}},
         BadLine{R"({"cmd": "control", "points": [{"index": [0,-3,0], "to": [0,0,0]}]})",
                 "control",
                 {"points[0].index[1]", "from -2 to 255"}},
         BadLine{R"({"cmd": "drag", "moves": [{"from": [0,0,0], "to": [0,0,0]}], "pins": 1})",
                 "drag",
                 {"pins must be an array of points"}},
         BadLine{R"({"cmd": "drag", "moves": [{"from": [0,0,0], "to": [0,0,0]}], "pins": [[1]]})",
                 "drag",
                 {"pins[0]"}}})
        expect_error(bad);
}

// ---- Header and statistics

TEST(ScriptHeader, MustBeVersionOne) {
    EXPECT_TRUE(check_header(R"({"pectin": 1})"));
    EXPECT_TRUE(check_header(R"(  {"pectin":1}  )"));
    for (const char* line : {"", "{}", "1", R"({"cmd": "undo"})", R"({"pectin": 1, "a": 2})",
                             R"({"pectin": "1"})", R"({"pectin": 0})", R"({"pectin": 1)"}) {
        const Done done = check_header(line);
        ASSERT_FALSE(done) << line;
        EXPECT_NE(done.refusal().reason.find("must be {\"pectin\": 1}"), std::string::npos)
            << done.refusal().reason;
    }
    EXPECT_NE(check_header(R"({"pectin": 2})").refusal().reason.find("version 2"),
              std::string::npos);
}

TEST(StatisticsJson, HasItsFieldsInOrderAndEndsWithANewline) {
    Statistics statistics;
    statistics.vertices = 12;
    statistics.input = {{"lines", 3}, {"points", 0}};
    statistics.last.seconds.refine = 0.25;
    statistics.angle_min_deg = std::numeric_limits<double>::quiet_NaN();
    const std::string text = format_statistics(statistics);
    std::size_t at = 0;
    for (const char* field : {"{\n",
                              "  \"vertices\": 12,\n",
                              "\"faces\"",
                              "\"base_vertices\"",
                              "\"base_faces\"",
                              "\"max_level\"",
                              "\"input\": {\n",
                              "\"lines\": 3,\n",
                              "\"points\": 0\n  },\n",
                              "\"last\": {\n",
                              "\"splits\"",
                              "\"unsplits\"",
                              "\"influenced_vertices\"",
                              "\"seconds\": {\n",
                              "\"begin\"",
                              "\"solve\"",
                              "\"deform\"",
                              "\"refine\": 0.25,\n",
                              "\"decimate\"",
                              "\"commit\": 0\n",
                              "\"error\": {\n",
                              "\"last\": null,\n",
                              "\"total\": null\n",
                              "\"edge_max\"",
                              "\"angle_min_deg\": null",
                              "\"divergence_max_deg\"",
                              "\"needing_refinement\"",
                              "\"held_back\"",
                              "\"floor_hit\": false",
                              "\"budget_hit\"",
                              "\"drag_budget_hit\"",
                              "\"folded_vertices\"",
                              "\"memory_bytes\": 0,\n",
                              "\"undo_steps\": 0,\n",
                              "\"undo_bytes\": 0\n}\n"}) {
        const std::size_t found = text.find(field, at);
        ASSERT_NE(found, text.npos) << field << " after " << at << " in\n" << text;
        at = found;
    }
    EXPECT_TRUE(text.ends_with("}\n"));
}

}  // namespace
}  // namespace pectin
