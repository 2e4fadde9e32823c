// The windows of the menu Help, and the list of inputs that they and the README show. Nothing is
// drawn: what is on the screen is read from the draw data.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <span>

#include "app/fuzzy_match.h"
#include "app/input_reference.h"
#include "app/libraries.h"
#include "app/ui/columns.h"
#include "app/ui/command_palette.h"
#include "support/offscreen_window.h"
#include "support/paths.h"
#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::OffscreenWindow;

std::string readme() {
    std::ifstream file(test::source_path("README.md"));
    return {std::istreambuf_iterator<char>(file), {}};
}

// --- The list of inputs.

TEST(Inputs, AreTheTableInTheReadme) {
    EXPECT_NE(readme().find("\n" + input_table() + "\n"), std::string::npos)
        << "paste what `pectin help --keys` prints into the README";
}

TEST(Inputs, ContainEveryShortcutOfTheTableOfActions) {
    const std::string table = input_table();
    for (const ActionInfo& info : all_actions()) {
        for (const Shortcut& shortcut : info.shortcuts) {
            if (!shortcut.exists()) continue;
            EXPECT_NE(table.find(label_of(shortcut)), std::string::npos) << info.name;
            EXPECT_NE(table.find(info.name), std::string::npos);
        }
    }
}

TEST(Inputs, OfEveryToolAreListedOnce) {
    std::set<std::string> listed;
    for (const InputSection& section : input_sections()) {
        for (const InputLine& line : section.lines) {
            EXPECT_TRUE(listed.insert(section.title + line.input).second) << line.input;
            EXPECT_FALSE(line.effect.empty()) << line.input;
        }
    }
    for (const auto& tool : all_tools()) {
        const InputGroup group = tool->inputs();
        EXPECT_FALSE(group.inputs.empty()) << "a tool says nothing about its inputs";
        for (const InputReference& input : group.inputs) {
            EXPECT_TRUE(listed.contains(std::string(group.title) + std::string(input.input)));
            EXPECT_TRUE(input.effect.ends_with('.')) << input.effect;
        }
    }
}

// --- Columns.

// The best division, by trying all of them.
double least_sum_of_squares(std::span<const float> heights, std::size_t columns) {
    if (columns == 1) {
        const double sum = std::accumulate(heights.begin(), heights.end(), 0.0);
        return sum * sum;
    }
    double least = std::numeric_limits<double>::infinity(), height = 0.0;
    for (std::size_t first = 0; first <= heights.size(); ++first) {
        if (first > 0) height += static_cast<double>(heights[first - 1]);
        least = std::min(
            least, height * height + least_sum_of_squares(heights.subspan(first), columns - 1));
    }
    return least;
}

TEST(Columns, AreAsEqualAsTheOrderOfTheBlocksAllows) {
    const int cases = test::case_count(300);
    for (int i = 0; i < cases; ++i) {
        SCOPED_TRACE("seed " + std::to_string(i));
        test::Random random(static_cast<std::uint64_t>(i));
        std::vector<float> heights(static_cast<std::size_t>(random.integer(0, 9)));
        for (float& height : heights) height = static_cast<float>(random.integer(1, 20));
        const auto columns = static_cast<std::size_t>(random.integer(1, 4));
        const std::vector<std::size_t> column_of = balanced_columns(heights, columns);
        ASSERT_EQ(column_of.size(), heights.size());
        EXPECT_TRUE(std::ranges::is_sorted(column_of));
        std::vector<double> sums(columns, 0.0);
        for (std::size_t k = 0; k < heights.size(); ++k) {
            ASSERT_LT(column_of[k], columns);
            sums[column_of[k]] += static_cast<double>(heights[k]);
        }
        double squares = 0.0;
        for (const double sum : sums) squares += sum * sum;
        EXPECT_DOUBLE_EQ(squares, least_sum_of_squares(heights, columns));
    }
}

// --- Finding by some letters.

TEST(FuzzyMatch, NeedsAllLettersInTheirOrder) {
    EXPECT_TRUE(match_score("wire", "Wireframe"));
    EXPECT_TRUE(match_score("WF", "wireframe"));
    EXPECT_TRUE(match_score("save p", "Save a picture"));
    EXPECT_FALSE(match_score("fw", "wireframe"));
    EXPECT_FALSE(match_score("wirer", "wire"));
    EXPECT_FALSE(match_score("x", ""));
    EXPECT_TRUE(match_score("", ""));
}

TEST(FuzzyMatch, PrefersLettersInARowBeginningsOfWordsAndShortTexts) {
    EXPECT_GT(match_score("top", "Top"), match_score("top", "Stop"));
    EXPECT_GT(match_score("sp", "Symmetry plane"), match_score("sp", "Inspect"));
    EXPECT_GT(match_score("cage", "A cage"), match_score("cage", "Create image"));
    EXPECT_GT(match_score("save", "Save"), match_score("save", "Save as"));
}

TEST(FuzzyMatch, PutsAnActionFirstWhoseWholeNameIsTyped) {
    for (const ActionInfo& info : all_actions()) {
        std::string name;
        for (const char c : std::string(info.name)) {
            if (static_cast<unsigned char>(c) < 0x80) name += c;
        }
        ASSERT_FALSE(matching_actions(name).empty()) << name;
        EXPECT_EQ(info_of(matching_actions(name).front()).name, std::string(info.name));
    }
}

// --- The windows.

class HelpWindows : public testing::Test {
  protected:
    OffscreenWindow window_;
    Editor& editor_ = window_.editor();

    bool shows(const std::string& text) const { return window_.find(text).has_value(); }
};

TEST_F(HelpWindows, F1ListsInputsUntilItIsPressedAgainOrEsc) {
    window_.key(Key::f1);
    window_.settle();
    EXPECT_TRUE(shows("Drag the surface"));
    EXPECT_TRUE(shows("Hold F and move the"));
    EXPECT_TRUE(shows("Wireframe"));
    window_.key(Key::f1);
    EXPECT_FALSE(editor_.has_dialog());
    window_.key(Key::f1);
    window_.key(Key::escape);
    window_.settle();
    EXPECT_FALSE(shows("Hold F and move the"));
    EXPECT_FALSE(editor_.has_dialog());
}

TEST_F(HelpWindows, TheListOfInputsCanBeSearched) {
    window_.key(Key::f1);
    window_.type("twist");
    window_.settle();
    EXPECT_TRUE(shows("Wheel, while dragging"));
    EXPECT_FALSE(shows("Hold F and move the"));
    EXPECT_FALSE(editor_.display.wireframe) << "W went to the field";
}

TEST_F(HelpWindows, TheListOfInputsScrollsInASmallWindow) {
    window_.resize({800, 600});
    window_.key(Key::f1);
    window_.settle();
    const std::vector<InputSection> sections = input_sections(MousePreset::blender);
    const std::string last = sections.back().lines.back().effect;
    EXPECT_FALSE(shows(last));
    for (int i = 0; i < 60; ++i) window_.scroll({400, 300}, -1.0);
    window_.settle();
    EXPECT_TRUE(shows(last)) << last;
    EXPECT_TRUE(shows("Close"));
}

TEST_F(HelpWindows, ThePaletteFindsAnActionAndPerformsIt) {
    window_.key(Key{'P'}, {.shift = true, .control = true});
    window_.type("wirefr");
    window_.key(Key::enter);
    EXPECT_TRUE(editor_.display.wireframe);
    EXPECT_FALSE(editor_.has_dialog());
    // The next query begins empty.
    window_.key(Key::f3);
    window_.type("toru");
    window_.key(Key::enter);
    EXPECT_EQ(editor_.workspace().object_name(), "torus");
}

TEST_F(HelpWindows, ThePaletteFollowsArrowsAndTheMouse) {
    window_.key(Key::f3);
    window_.type("radius");
    window_.settle();
    const std::vector<Action> found = matching_actions("radius");
    ASSERT_GE(found.size(), 2u);
    const double before = editor_.workspace().radius();
    window_.key(Key::down);
    window_.key(Key::enter);
    const double second = editor_.workspace().radius();
    EXPECT_EQ(second > before, found[1] == Action::larger_radius);
    EXPECT_NE(second, before);
    window_.key(Key::f3);
    window_.settle();
    EXPECT_TRUE(window_.click("Cube"));
    EXPECT_EQ(editor_.workspace().object_name(), "cube");
}

TEST_F(HelpWindows, ThePaletteSaysWhyAnActionIsNotEnabledAndKeepsIt) {
    window_.key(Key::f3);
    window_.type("redo");
    window_.settle();
    EXPECT_TRUE(shows("There is nothing to redo."));
    window_.key(Key::enter);
    EXPECT_TRUE(editor_.help_page());
    window_.key(Key::escape);
    EXPECT_FALSE(editor_.help_page());
}

TEST_F(HelpWindows, AClickBesideAWindowClosesItAndDoesNotReachTheObject) {
    window_.key(Key::f3);
    window_.settle();
    window_.click(Vec2{30, 690});
    EXPECT_FALSE(editor_.help_page());
    EXPECT_EQ(editor_.session().undo_count(), 0u);
}

TEST_F(HelpWindows, NoneOpensOverADialog) {
    window_.key(Key{'O'}, {.control = true});
    window_.key(Key::f1);
    EXPECT_FALSE(editor_.help_page());
    EXPECT_TRUE(editor_.document().browser());
}

TEST_F(HelpWindows, TheReferenceHasTheFieldsOfTheSchema) {
    editor_.perform(Action::show_reference);
    window_.type("waypoints");
    window_.settle();
    EXPECT_TRUE(shows("drag"));
    EXPECT_TRUE(shows("via"));
    EXPECT_FALSE(shows("theta_max"));
}

TEST_F(HelpWindows, AboutNamesVersionLicenceLibrariesAndRenderer) {
    window_.interface().set_renderer("a paintbrush");
    editor_.perform(Action::show_about);
    window_.settle();
    EXPECT_TRUE(shows("pectin " + program_version()));
    EXPECT_TRUE(shows("MIT"));
    EXPECT_TRUE(shows("a paintbrush"));
    for (const Library& library : libraries()) {
        EXPECT_FALSE(library.version.empty()) << library.name;
    }
    EXPECT_TRUE(shows(libraries().front().name));
}

}  // namespace
}  // namespace pectin
