#include "../../support/refusal.h"

#include <viewer/drive/script.h>

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <variant>

namespace cdr::viewer {

namespace {

/// What is said of a script that is refused; empty where it is taken.
std::string refusalOf(const std::string& text) {
    return test::inputErrorOf([&] { parseScript(text, "s"); });
}

TEST(Script, IsReadLineByLine) {
    const auto steps = parseScript("# a comment\n\nkey a shift control\nresize 320 240\nwait-frame\n"
                                   "click a name with spaces\n",
                                   "s");
    ASSERT_EQ(steps.size(), 5u); // a key is pressed and released
    const auto& key = std::get<KeyInput>(std::get<InputEvent>(steps[1]));
    EXPECT_EQ(key.key, 'A');
    EXPECT_FALSE(key.pressed);
    EXPECT_NE(key.modifiers, 0);
    EXPECT_EQ(std::get<WindowSize>(steps[2]).height, 240);
    EXPECT_EQ(std::get<ClickItem>(steps[4]).name, "a name with spaces");
}

TEST(Script, RefusesWhatItWouldNotPlay) {
    const std::pair<const char*, const char*> refused[] = {
        {"key a ctrl", "s, line 1: unknown modifier 'ctrl'"},
        {"state\nresize 1 2 3", "s, line 2: '3' is one word too many"},
        {"quit now", "s, line 1: 'now' is one word too many"},
        {"move 1 2 x", "s, line 1: 'x' is one word too many"},
        {"press 5", "s, line 1: button must be 0 to 4"},
        {"resize 0 9", "s, line 1: width must be 1 to"},
        {"key", "s, line 1: key missing"},
        {"leap", "s, line 1: unknown step 'leap'"}};
    for (const auto& [text, why] : refused) {
        EXPECT_EQ(refusalOf(text).substr(0, std::string(why).size()), why);
    }
}

} // namespace

} // namespace cdr::viewer
