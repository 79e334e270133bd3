#include "parsing.h"

#include <gtest/gtest.h>
#include <options/views/views_plan.h>

namespace cdr::options {

namespace {

std::string parseViews(const std::vector<std::string>& words, ViewsArguments& views) {
    CLI::App command;
    addStereoOptions(command, views);
    addViewsOption(command, views);
    return refusalOf(command, words);
}

TEST(ViewsOptions, BecomeTheViewsOfAPicture) {
    ViewsArguments views;
    EXPECT_EQ(
        parseViews({"--stereo=toed-in", "--eye-distance=0.1", "--converge=4", "--stereo-picture=anaglyph"},
                   views),
        "");
    EXPECT_EQ(views.stereo, scene::StereoMode::toedIn);
    EXPECT_EQ(views.picture, StereoPicture::anaglyph);
    const ViewsPlan plan(views, 64, 32);
    EXPECT_EQ(plan.kind(), ViewsKind::stereo);
    EXPECT_EQ(plan.stereoName(), "toed-in");
    EXPECT_TRUE(plan.isAnaglyph());
    nlohmann::ordered_json json;
    addViewsJson(json, views);
    EXPECT_EQ(json.dump(),
              R"({"stereo":"toed-in","stereo_picture":"anaglyph","eye_distance":0.1,"converge":4.0})");
}

TEST(ViewsOptions, AreOneViewUnlessGiven) {
    ViewsArguments views;
    EXPECT_EQ(parseViews({"--stereo=none"}, views), "");
    EXPECT_EQ(views, ViewsArguments{});
    EXPECT_EQ(ViewsPlan(views, 64, 32).kind(), ViewsKind::one);
    nlohmann::ordered_json json;
    addViewsJson(json, views);
    EXPECT_TRUE(json.empty());
    EXPECT_EQ(parseViews({"--views=six"}, views), "");
    EXPECT_EQ(ViewsPlan(views, 32, 32).count(), 6u);
    addViewsJson(json, views);
    EXPECT_EQ(json.dump(), R"({"views":"six"})");
}

TEST(ViewsOptions, RefuseUnknownNames) {
    ViewsArguments views;
    EXPECT_NE(parseViews({"--stereo=toedin"}, views).find("(known: none, parallel, toed-in, off-axis)"),
              std::string::npos);
    EXPECT_NE(parseViews({"--views=stereo"}, views).find("(known: one, six)"), std::string::npos);
    EXPECT_NE(parseViews({"--stereo-picture=anaglif"}, views).find("did you mean 'anaglyph'"),
              std::string::npos);
}

} // namespace

} // namespace cdr::options
