#include "parsing.h"

#include <cdr/platform/worker_pool.h>

#include <gtest/gtest.h>
#include <options/drawing_options.h>

namespace cdr::options {

namespace {

struct Drawn {
    TechniqueParts parts;
    std::optional<depth::DepthFormat> format;
    render::RenderOptions options;
};

void addAll(CLI::App& command, Drawn& drawn) {
    addTechniqueParts(command, drawn.parts);
    addDepthFormat(command, drawn.format);
    addTargets(command, drawn.options.targets);
    addSubmission(command, drawn.options);
    addDetail(command, drawn.options.detail);
    addSnapping(command, drawn.options.snapping);
    addThreads(command, drawn.options.threads);
}

std::string drawingRefusalOf(const std::vector<std::string>& words) {
    CLI::App command;
    Drawn drawn;
    addAll(command, drawn);
    return refusalOf(command, words);
}

TEST(DrawingOptions, BecomeValuesWhileTheyAreParsed) {
    CLI::App command;
    Drawn drawn;
    addAll(command, drawn);
    EXPECT_EQ(refusalOf(command, {"--depth=anchored", "--split=count:3", "--format=d16", "--targets=pool:4",
                                  "--submission=primaries", "--batching=per-object", "--detail=object:2",
                                  "--snapping=in-plane", "--threads=3"}),
              "");
    EXPECT_EQ(drawn.parts.technique(), depth::parseTechnique("anchored/count:3"));
    EXPECT_EQ(drawn.format, depth::DepthFormat::d16);
    EXPECT_EQ(drawn.options.targets, render::TargetsChoice::pool(4));
    EXPECT_EQ(drawn.options.submission, render::Submission::primaries);
    EXPECT_EQ(drawn.options.batching, render::Batching::perObject);
    EXPECT_EQ(drawn.options.detail, visibility::parseDetail("object:2"));
    EXPECT_EQ(drawn.options.snapping, render::Snapping::inPlane);
    EXPECT_EQ(drawn.options.threads, 3u);
}

TEST(DrawingOptions, StayAsARendererHasThem) {
    CLI::App command;
    Drawn drawn;
    addAll(command, drawn);
    EXPECT_EQ(refusalOf(command, {}), "");
    EXPECT_EQ(drawn.options, render::RenderOptions{});
    EXPECT_FALSE(drawn.parts.isGiven());
    EXPECT_FALSE(drawn.format);
    EXPECT_EQ(command.get_option("--detail")->get_default_str(), "none");
    EXPECT_EQ(command.get_option("--targets")->get_default_str(), "single");
}

/// Scripts pass a variable that may be empty.
TEST(DrawingOptions, AnEmptyTextIsNoTechnique) {
    CLI::App command;
    Drawn drawn;
    addAll(command, drawn);
    EXPECT_EQ(refusalOf(command, {"--depth", "", "--format", ""}), "");
    EXPECT_FALSE(drawn.parts.isGiven());
    EXPECT_FALSE(drawn.format);
}

TEST(DrawingOptions, OnePartIsEnough) {
    EXPECT_EQ(TechniqueParts{.mapping = depth::Mapping::log}.technique(), depth::parseTechnique("log/none"));
    EXPECT_EQ(TechniqueParts{.split = depth::SplitCount{4}}.technique(),
              depth::parseTechnique("standard/count:4"));
}

TEST(DrawingOptions, RefuseWhatIsUnknown) {
    EXPECT_NE(drawingRefusalOf({"--targets=singel"}).find("did you mean 'single'"), std::string::npos);
    EXPECT_NE(drawingRefusalOf({"--snapping=in-plan"}).find("did you mean 'in-plane'"), std::string::npos);
    EXPECT_NE(drawingRefusalOf({"--split=ratio:1"}).find("above 1"), std::string::npos);
    const std::string tooMany = std::to_string(platform::WorkerPool::kMaxThreads + 1);
    for (const std::string& threads : {std::string("0"), std::string("-1"), std::string("x"), tooMany}) {
        EXPECT_NE(drawingRefusalOf({"--threads=" + threads}).find("--threads"), std::string::npos) << threads;
    }
}

} // namespace

} // namespace cdr::options
