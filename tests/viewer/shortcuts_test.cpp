#include <viewer/panels/shortcuts.h>

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <set>
#include <string_view>
#include <utility>

namespace cdr::viewer_test {

namespace {

using namespace viewer;

ViewerModel pressed(int key, int modifiers) {
    ViewerModel model;
    applyShortcut({.key = key, .pressed = true, .modifiers = modifiers}, model);
    return model;
}

TEST(Shortcuts, AreEachShownOnce) {
    std::set<std::string_view> keys;
    for (const ShortcutSection& section : shortcuts()) {
        EXPECT_FALSE(section.title.empty());
        for (const Shortcut& line : section.shortcuts) {
            EXPECT_TRUE(keys.insert(line.keys).second) << line.keys;
            EXPECT_GT(line.meaning.size(), 8u) << line.keys;
            EXPECT_FALSE(line.meaning.ends_with('.')) << line.keys;
        }
    }
    EXPECT_TRUE(keys.contains("F1"));
    EXPECT_TRUE(keys.contains("1 to 6"));
}

TEST(Shortcuts, NeedAKeyEach) {
    std::set<std::pair<int, int>> keys;
    for (const ShortcutSection& section : shortcuts()) {
        for (const Shortcut& line : section.shortcuts) {
            for (std::size_t i = 0; line.act != nullptr && i < line.count; ++i) {
                EXPECT_TRUE(keys.emplace(line.key + static_cast<int>(i), line.modifiers).second) << line.keys;
            }
        }
    }
}

TEST(Shortcuts, WithControlMeanAnotherThingOrTheSame) {
    EXPECT_EQ(pressed(GLFW_KEY_C, GLFW_MOD_CONTROL).actions, (std::vector{Action::copyCommandLine}));
    EXPECT_FALSE(pressed(GLFW_KEY_C, GLFW_MOD_CONTROL).settings.second.has_value());
    EXPECT_TRUE(pressed(GLFW_KEY_C, 0).settings.second.has_value());
    EXPECT_EQ(pressed(GLFW_KEY_Q, GLFW_MOD_CONTROL).actions, (std::vector{Action::quit}));
    EXPECT_TRUE(pressed(GLFW_KEY_Q, 0).actions.empty());
    EXPECT_EQ(pressed(GLFW_KEY_F12, GLFW_MOD_CONTROL).actions, (std::vector{Action::screenshotPicture}));
    EXPECT_EQ(pressed(GLFW_KEY_F12, GLFW_MOD_SHIFT).actions, (std::vector{Action::screenshotWindow}));
}

TEST(Shortcuts, TheLastOfARangeIsItsOwnAndTheNextKeyIsNot) {
    EXPECT_EQ(pressed(GLFW_KEY_F6, 0).interface.panelKeys->panel, 4u);
    EXPECT_FALSE(pressed(GLFW_KEY_F7, 0).interface.panelKeys.has_value());
    EXPECT_EQ(nameOf(pressed(GLFW_KEY_6, 0).settings.technique), "anchored");
    EXPECT_EQ(pressed(GLFW_KEY_7, 0).settings.technique, ViewerModel().settings.technique);
}

} // namespace

} // namespace cdr::viewer_test
