#include <gtest/gtest.h>
#include <output/aov.h>

#include <cmath>
#include <map>
#include <string>

namespace {

using namespace cdr;

/// One row of pixels a million units away, a micrometre apart, and one of background.
render::Frame makeFrame() {
    render::Frame frame;
    frame.cascades = {{1e6 + 0.3, 1e6 + 32.0}};
    frame.anchorsView = {1e6 + 0.3};
    frame.color = image::ImageRgba8(8, 1);
    frame.gbuffer = image::Raster<render::GBufferPixel>(8, 1);
    for (std::uint32_t x = 0; x < 7; ++x) {
        frame.gbuffer.at(x, 0) = {.ahead = 1e-6f * static_cast<float>(x), .idAndCascade = 1};
    }
    return frame;
}

TEST(DistanceAov, TheExactPairKeepsMicrometresAMillionUnitsAway) {
    const render::Frame frame = makeFrame();
    std::map<std::string, image::ImageFloat> channels;
    for (const image::ExrChannel& channel : channelsOf(frame, output::Aov::distance, nullptr)) {
        channels[channel.name] = channel.values;
    }
    ASSERT_EQ(channels.size(), 3u);
    for (std::uint32_t x = 0; x < 7; ++x) {
        EXPECT_EQ(channels.at("distance").at(x, 0), 1e6f + 0.3125f); // all of float32 there is
        const double pair = static_cast<double>(channels.at("distance").at(x, 0)) +
                            static_cast<double>(channels.at("distanceRest").at(x, 0));
        EXPECT_NEAR(pair, 1e6 + 0.3 + 1e-6 * x, 1e-9);
        EXPECT_EQ(channels.at("ahead").at(x, 0), 1e-6f * static_cast<float>(x));
    }
    EXPECT_TRUE(std::isinf(channels.at("distance").at(7, 0)));
    EXPECT_EQ(channels.at("distanceRest").at(7, 0), 0.0f);
}

/// Light beyond what 8 bits show stays in the channels.
TEST(LinearAov, ChannelsHoldTheLightItself) {
    render::Frame frame = makeFrame();
    frame.linear = image::Raster<glm::vec3>(8, 1);
    frame.linear.at(3, 0) = {9.0f, 0.5f, 0.25f};
    const std::vector<image::ExrChannel> channels = channelsOf(frame, output::Aov::linear, nullptr);
    ASSERT_EQ(channels.size(), 3u);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(channels[c].name, std::string(1, "RGB"[c]));
        EXPECT_EQ(channels[c].values.at(3, 0), frame.linear.at(3, 0)[static_cast<int>(c)]);
        EXPECT_EQ(channels[c].values.at(4, 0), 0.0f);
    }
    EXPECT_EQ(pictureOf(frame, output::Aov::linear, nullptr).at(3, 0), (image::Rgba8{255, 188, 137, 255}));
    const std::string hash = hashOf(frame, output::Aov::linear, nullptr);
    frame.linear.at(3, 0).r = 9.5f;
    EXPECT_NE(hashOf(frame, output::Aov::linear, nullptr), hash);
}

} // namespace
