// The table of actions, and the menus and keys that read it.
#include "app/actions.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "app/ui/interface.h"
#include "unit/app_editor_fixture.h"

namespace pectin {
namespace {

// --- The table.

TEST(Actions, EachStandsInTheTableOnce) {
    std::set<Action> found;
    for (const ActionInfo& info : all_actions()) {
        EXPECT_TRUE(found.insert(info.action).second) << info.name;
        EXPECT_EQ(&info_of(info.action), &info);
    }
    EXPECT_EQ(found.size(), kActionCount);
}

TEST(Actions, EachHasANameOfItsOwnATooltipAndAnEffect) {
    std::set<std::string> names;
    for (const ActionInfo& info : all_actions()) {
        const std::string tooltip = info.tooltip;
        EXPECT_FALSE(std::string(info.name).empty());
        EXPECT_TRUE(names.insert(info.name).second) << info.name;
        EXPECT_GT(tooltip.size(), 10u) << info.name;
        EXPECT_TRUE(std::isupper(static_cast<unsigned char>(tooltip.front()))) << info.name;
        EXPECT_EQ(tooltip.find(". "), tooltip.npos) << info.name << ": more than one sentence";
        EXPECT_TRUE(tooltip.ends_with('.')) << info.name;
        EXPECT_TRUE(info.is_enabled && info.perform) << info.name;
    }
}

TEST(Actions, NoTwoShareAKey) {
    std::vector<Shortcut> shortcuts;
    for (const ActionInfo& info : all_actions()) {
        for (const Shortcut& shortcut : info.shortcuts) {
            if (!shortcut.exists()) continue;
            EXPECT_EQ(std::ranges::count(shortcuts, shortcut), 0) << info.name;
            shortcuts.push_back(shortcut);
            EXPECT_NE(shortcut.key == Key::none, shortcut.character == 0)
                << info.name << ": either a key or a character";
            const auto found = shortcut.character == 0
                                   ? action_for(shortcut.key, shortcut.modifiers)
                                   : action_for(static_cast<unsigned char>(shortcut.character));
            EXPECT_EQ(found, info.action) << info.name;
            EXPECT_NE(tooltip_with_shortcuts(info.action).find(label_of(shortcut)),
                      std::string::npos)
                << info.name;
        }
    }
    EXPECT_GT(shortcuts.size(), 15u);
}

TEST(Shortcuts, DistinguishUndoFromRedoAndPlainLettersFromControl) {
    EXPECT_EQ(action_for(Key{'Z'}, {.control = true}), Action::undo);
    EXPECT_EQ(action_for(Key{'Z'}, {.shift = true, .control = true}), Action::redo);
    EXPECT_EQ(action_for(Key{'Y'}, {.control = true}), Action::redo);
    EXPECT_EQ(action_for(Key{'W'}, {}), Action::toggle_wireframe);
    EXPECT_EQ(action_for(Key{'W'}, {.control = true}), std::nullopt);
    EXPECT_EQ(action_for(']'), Action::larger_radius);
    EXPECT_EQ(shortcut_label(Action::redo), "Ctrl+Shift+Z");
    EXPECT_EQ(shortcut_label(Action::frame_all), "Home");
    EXPECT_EQ(tooltip_with_shortcuts(Action::toggle_symmetry),
              "Mirror every drag across a plane (X).");
}

// --- Keys.

using ActionKeysTest = EditorTest;

TEST_F(ActionKeysTest, AnActionThatIsNotEnabledOnlySaysWhatItNeeds) {
    auto editor = this->editor();
    const TriMesh before = editor.session().mesh();
    editor.handle(event::Leave{});
    for (const ActionInfo& info : all_actions()) {
        if (info.is_enabled(editor)) continue;
        SCOPED_TRACE(info.name);
        editor.perform(info.action);
        for (const Shortcut& shortcut : info.shortcuts) {
            editor.handle(event::KeyDown{shortcut.key, shortcut.modifiers});
        }
        EXPECT_EQ(editor.session().mesh(), before);
        EXPECT_EQ(editor.session().undo_count() + editor.session().redo_count(), 0u);
        EXPECT_TRUE(editor.pins().is_empty());
        EXPECT_NE(std::string(info.needs), "");
        EXPECT_EQ(editor.workspace().message(), info.needs);
        EXPECT_EQ(editor.workspace().command_message_kind(), Messages::Kind::information);
    }
    for (const Action refused : {Action::undo, Action::redo, Action::remove_pins, Action::bake,
                                 Action::toggle_pin, Action::fit_cage, Action::normal_text}) {
        EXPECT_FALSE(info_of(refused).is_enabled(editor)) << info_of(refused).name;
    }
}

TEST_F(ActionKeysTest, ActionsOfTheBrushSayThatACageIsInTheWay) {
    auto editor = this->editor();
    editor.use_cage();
    move(editor, kMiddle);
    for (const Action refused : {Action::smaller_radius, Action::larger_radius}) {
        editor.perform(refused);
        EXPECT_EQ(editor.workspace().message(),
                  "The radius cannot be changed while a cage is in use.");
    }
    for (const ActionInfo& info : all_actions()) {
        EXPECT_TRUE(info.is_enabled(editor) || *info.needs) << info.name;
    }
    EXPECT_NE(editor.status_hint().find("cage"), std::string_view::npos);
    EXPECT_EQ(editor.status_hint().find("radius"), std::string_view::npos);
}

TEST_F(ActionKeysTest, PinAndRepetitionBesideTheSurfaceSayWhereTheyWork) {
    auto editor = this->editor();
    drag(editor, kMiddle, kMiddle + Vec2(60, -80));
    move(editor, kBeside);
    for (const Modifiers& modifiers : {Modifiers{}, Modifiers{.shift = true}}) {
        editor.workspace().dismiss();
        key(editor, Key{modifiers.shift ? 'R' : 'P'}, modifiers);
        EXPECT_EQ(editor.workspace().message(), "Put the cursor on the surface and press the key.");
        EXPECT_EQ(editor.session().undo_count(), 1u);
        EXPECT_TRUE(editor.pins().is_empty());
    }
}

TEST_F(ActionKeysTest, ActionsAreEnabledOnceThereIsSomethingToDo) {
    auto editor = this->editor();
    drag(editor, kMiddle, kMiddle + Vec2(60, -80));
    EXPECT_TRUE(info_of(Action::undo).is_enabled(editor));
    EXPECT_TRUE(info_of(Action::bake).is_enabled(editor));
    EXPECT_FALSE(info_of(Action::redo).is_enabled(editor));
    key(editor, Key{'Z'}, {.control = true});
    EXPECT_FALSE(info_of(Action::undo).is_enabled(editor));
    EXPECT_TRUE(info_of(Action::redo).is_enabled(editor));
    move(editor, kMiddle);
    EXPECT_TRUE(info_of(Action::toggle_pin).is_enabled(editor));
    key(editor, Key{'P'});
    EXPECT_TRUE(info_of(Action::remove_pins).is_enabled(editor));
}

TEST_F(ActionKeysTest, SwitchesTurnWhatTheyShowOnAndOff) {
    auto editor = this->editor();
    int switches = 0;
    for (const ActionInfo& info : all_actions()) {
        if (!info.is_on || info.is_choice) continue;
        SCOPED_TRACE(info.name);
        const bool before = info.is_on(editor);
        editor.perform(info.action);
        EXPECT_NE(info.is_on(editor), before);
        editor.perform(info.action);
        EXPECT_EQ(info.is_on(editor), before);
        ++switches;
    }
    EXPECT_EQ(switches, 13);
}

TEST_F(ActionKeysTest, ChoicesAreOnUntilAnotherIsPerformed) {
    auto editor = this->editor();
    const auto ones_on = [&] {
        std::vector<Action> on;
        for (const ActionInfo& info : all_actions()) {
            const bool is_preset = info.menu == Menu::navigation && info.is_choice;
            if (is_preset && info.is_on(editor)) on.push_back(info.action);
        }
        return on;
    };
    EXPECT_EQ(ones_on(), std::vector{Action::navigate_as_blender});
    for (const Action action : {Action::navigate_as_zbrush, Action::navigate_as_maya,
                                Action::navigate_as_maya, Action::navigate_as_blender}) {
        editor.perform(action);
        EXPECT_EQ(ones_on(), std::vector{action});
    }
}

TEST_F(ActionKeysTest, OnlyUndoAndRedoRepeatWhileTheKeyIsHeld) {
    auto editor = this->editor();
    for (int i = 0; i < 3; ++i) drag(editor, kMiddle, kMiddle + Vec2(30, -20 * i));
    ASSERT_EQ(editor.session().undo_count(), 3u);
    editor.handle(event::KeyDown{Key{'Z'}, {.control = true}, false});
    for (int i = 0; i < 2; ++i) {
        editor.handle(event::KeyDown{Key{'Z'}, {.control = true}, true});
    }
    EXPECT_EQ(editor.session().undo_count(), 0u);
    editor.handle(event::KeyDown{Key{'W'}, {}, true});
    EXPECT_FALSE(editor.display.wireframe);
}

// --- Menus.

class MenuBarTest : public EditorTest {
  protected:
    static constexpr double kTop = 12.0;  // a height within the bar
    // Positions of the titles along the bar.
    static constexpr double kFile = 20.0, kEdit = 62.0, kView = 105.0, kTools = 150.0,
                            kHelp = 198.0;

    void SetUp() override {
        interface_.set_size(kSize, kSize);
        interface_.lay_out(editor_, {});
    }
    void click(const Vec2& at) {
        interface_.handle(editor_, event::MouseMove{at});
        interface_.handle(editor_, event::Press{MouseButton::left, at});
        interface_.handle(editor_, event::Release{MouseButton::left, at});
    }
    std::optional<Action> hover(const Vec2& at) {
        interface_.handle(editor_, event::MouseMove{at});
        for (int i = 0; i < 3; ++i) interface_.lay_out(editor_, {});
        return interface_.hovered_action();
    }
    // Opens the menu whose title is there and returns its entries, from top to bottom.
    std::vector<Action> entries(double title) {
        click({title, kTop});
        return entries_at(title + 12.0);
    }
    std::vector<Action> entries_at(double x, double top = 26.0) {
        std::vector<Action> found;
        for (double y = top; y < 450.0; y += 5.0) {
            const std::optional<Action> entry = hover({x, y});
            if (entry && (found.empty() || found.back() != *entry)) found.push_back(*entry);
        }
        return found;
    }
    void close_menus() {
        interface_.handle(editor_, event::KeyDown{Key::escape});
        interface_.handle(editor_, event::KeyUp{Key::escape});
    }
    void press(Key key) {
        interface_.handle(editor_, event::KeyDown{key});
        interface_.handle(editor_, event::KeyUp{key});
        for (int i = 0; i < 3; ++i) interface_.lay_out(editor_, {});
    }
    bool has_open_menu() {
        for (int i = 0; i < 3; ++i) interface_.lay_out(editor_, {});
        return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    }
    static std::vector<std::string> names(const std::vector<Action>& actions) {
        std::vector<std::string> found;
        for (const Action action : actions) found.emplace_back(info_of(action).name);
        return found;
    }
    static std::vector<Action> table(Menu menu) {
        std::vector<Action> found;
        for (const ActionInfo& info : all_actions()) {
            if (info.menu == menu) found.push_back(info.action);
        }
        return found;
    }

    PreparedEditor editor_ = editor();
    Interface interface_{1.0f};
};

TEST_F(MenuBarTest, EachMenuHasTheEntriesOfTheTableInItsOrder) {
    const std::vector<std::pair<double, Menu>> menus{{kFile, Menu::file},
                                                     {kEdit, Menu::edit},
                                                     {kView, Menu::view},
                                                     {kTools, Menu::tools},
                                                     {kHelp, Menu::help}};
    std::size_t count = 0;
    for (const auto& [title, menu] : menus) {
        EXPECT_EQ(names(entries(title)), names(table(menu)));
        count += table(menu).size();
        close_menus();
        close_menus();
    }
    for (const Menu submenu :
         {Menu::new_object, Menu::viewpoint, Menu::navigation, Menu::examples}) {
        count += table(submenu).size();
    }
    EXPECT_EQ(count, kActionCount) << "actions of no menu";
}

TEST_F(MenuBarTest, SubmenusHaveTheEntriesOfTheTable) {
    const std::vector<std::pair<double, Menu>> submenus{
        {kFile, Menu::new_object}, {kView, Menu::viewpoint}, {kView, Menu::navigation}};
    for (const auto& [title, submenu] : submenus) {
        SCOPED_TRACE(info_of(table(submenu).front()).name);
        click({title, kTop});
        std::vector<Action> found;
        // An entry of the menu opens the submenu, whose first entry is on its right.
        for (double y = 26.0; y < 330.0 && found.empty(); y += 8.0) {
            for (double x = title + 80.0; x < title + 300.0 && found.empty(); x += 25.0) {
                hover({title + 12.0, y});
                const std::optional<Action> first = hover({x, y});
                if (first == table(submenu).front()) found = entries_at(x, y);
            }
        }
        EXPECT_EQ(names(found), names(table(submenu)));
        click({640.0, 795.0});  // beside the menus, which closes them
    }
}

TEST_F(MenuBarTest, EscapeClosesAMenuWithItsSubmenu) {
    click({kView, kTop});
    EXPECT_TRUE(has_open_menu());
    press(Key::escape);
    EXPECT_FALSE(has_open_menu());
    click({kFile, kTop});
    hover({kFile + 10.0, 36.0});  // New, which opens its submenu
    EXPECT_TRUE(has_open_menu());
    press(Key::escape);
    EXPECT_FALSE(has_open_menu());
}

TEST_F(MenuBarTest, MenusCanBeUsedByTheKeyboardAlone) {
    press(Key::f10);
    ASSERT_TRUE(has_open_menu());
    press(Key::right);
    press(Key::right);  // View
    for (int i = 0; i < 30 && interface_.hovered_action() != Action::toggle_wireframe; ++i) {
        press(Key::down);
    }
    ASSERT_EQ(interface_.hovered_action(), Action::toggle_wireframe);
    EXPECT_FALSE(editor_.display.wireframe);
    press(Key::enter);
    EXPECT_TRUE(editor_.display.wireframe);
    EXPECT_FALSE(has_open_menu());
}

TEST_F(MenuBarTest, RightOpensTheSubmenuThatTheArrowKeysAreAt) {
    press(Key::f10);
    press(Key::down);
    for (int i = 0; i < 30 && interface_.hovered_action() != Action::open; ++i) press(Key::down);
    ASSERT_EQ(interface_.hovered_action(), Action::open);
    press(Key::up);  // New
    press(Key::right);
    ASSERT_EQ(interface_.hovered_action(), Action::new_sphere) << "not the menu Edit";
    press(Key::down);
    press(Key::enter);
    EXPECT_FALSE(has_open_menu());
    EXPECT_EQ(editor_.workspace().object_name(), "cube");
}

TEST_F(MenuBarTest, RightEntersTheSubmenuThatTheCursorHasOpened) {
    click({kFile, kTop});
    hover({kFile + 10.0, 36.0});  // New
    press(Key::right);
    EXPECT_EQ(interface_.hovered_action(), Action::new_sphere) << "not the menu Edit";
    press(Key::down);
    press(Key::enter);
    EXPECT_EQ(editor_.workspace().object_name(), "cube");
    EXPECT_FALSE(has_open_menu());
}

TEST_F(MenuBarTest, RightLeadsFromASubmenuToTheNextMenuOfTheBar) {
    click({kFile, kTop});
    hover({kFile + 10.0, 36.0});
    press(Key::right);
    press(Key::right);
    ASSERT_TRUE(has_open_menu());
    press(Key::down);
    ASSERT_TRUE(interface_.hovered_action());
    EXPECT_EQ(info_of(*interface_.hovered_action()).menu, Menu::edit);
}

TEST_F(MenuBarTest, LeftClosesASubmenuAndLeadsFromAMenuToTheOneBefore) {
    press(Key::f10);
    press(Key::down);
    for (int i = 0; i < 30 && interface_.hovered_action() != Action::open; ++i) press(Key::down);
    press(Key::up);
    press(Key::right);
    press(Key::left);
    EXPECT_TRUE(has_open_menu());
    press(Key::down);
    EXPECT_EQ(interface_.hovered_action(), Action::open) << "the menu File is still open";
}

TEST_F(MenuBarTest, ArrowKeysDoNothingWhileNoMenuIsOpen) {
    for (const Key key : {Key::down, Key::right, Key::enter, Key::space}) press(key);
    EXPECT_FALSE(has_open_menu());
    EXPECT_EQ(ImGui::GetIO().ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard, 0);
}

TEST_F(MenuBarTest, AnEntryThatIsNotEnabledCannotBeChosen) {
    const auto choose = [this](Action action) {
        click({kEdit, kTop});
        double y = 26.0;
        while (y < 200.0 && hover({kEdit + 12.0, y}) != action) y += 5.0;
        click({kEdit + 12.0, y});
        const std::string message = editor_.workspace().message();
        close_menus();  // if the menu is closed, Esc dismisses the message
        return message;
    };
    drag(editor_, kMiddle, kMiddle + Vec2{60, -80});
    EXPECT_EQ(choose(Action::undo), "");
    EXPECT_EQ(editor_.session().undo_count(), 0u);
    EXPECT_EQ(choose(Action::redo), "");
    EXPECT_EQ(editor_.session().undo_count(), 1u);
    EXPECT_EQ(choose(Action::redo), "") << "there was nothing to redo";
    EXPECT_EQ(editor_.session().undo_count(), 1u);
}

}  // namespace
}  // namespace pectin
