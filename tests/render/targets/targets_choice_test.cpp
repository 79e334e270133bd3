#include "../../support/refusal.h"

#include <cdr/render/targets/targets.h>

#include <gtest/gtest.h>

#include <string>

namespace cdr::render_test {

namespace {

using render::TargetsChoice;
using render::TargetsKind;

TEST(TargetsChoiceTest, NamesAreReadBack) {
    for (const TargetsKind kind : render::kTargetsKinds) {
        EXPECT_EQ(render::parseTargets(nameOf(kind)), TargetsChoice(kind)) << nameOf(kind);
        EXPECT_EQ(render::parseTargets(nameOf(TargetsChoice(kind))), TargetsChoice(kind)) << nameOf(kind);
    }
    EXPECT_EQ(nameOf(TargetsChoice::pool(4)), "pool:4");
    EXPECT_EQ(render::parseTargets("pool:4"), TargetsChoice::pool(4));
    EXPECT_EQ(render::parseTargets("pool").layers, render::kDefaultPoolLayers);
    EXPECT_EQ(render::parseTargets("layers").layers, 0u);
}

/// What parseTargets() says of a bad text.
std::string refusalOf(const std::string& text) {
    return test::inputErrorOf([&] { render::parseTargets(text); }, "accepted");
}

TEST(TargetsChoiceTest, BadTextIsRefusedWithWhatWouldDo) {
    EXPECT_NE(refusalOf("singel").find("did you mean 'single'"), std::string::npos);
    EXPECT_NE(refusalOf("onepass").find("did you mean 'one-pass'"), std::string::npos);
    EXPECT_NE(refusalOf("pol:4").find("did you mean 'pool'"), std::string::npos);
    for (const char* text : {"pool:", "pool:x", "pool:3x", "pool:-1", "pool:2.5", "pool:99999999999"}) {
        EXPECT_NE(refusalOf(text).find("pool:N takes a whole number of layers, 2 to 16"), std::string::npos)
            << text;
    }
    for (const char* text : {"pool:0", "pool:1", "pool:17"}) {
        EXPECT_NE(refusalOf(text).find("a pool has 2 to 16 layers"), std::string::npos) << text;
    }
    for (const char* text : {"single:2", "layers:4", "one-pass:"}) {
        EXPECT_NE(refusalOf(text).find("take no number of layers"), std::string::npos) << text;
    }
}

} // namespace

} // namespace cdr::render_test
