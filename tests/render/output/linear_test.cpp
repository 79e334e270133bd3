#include "../../support/refusal.h"
#include "../fixture.h"
#include "../host/host_side.h"

#include <cdr/base/error.h>
#include <cdr/image/srgb.h>

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

namespace cdr::render_test {

namespace {

class LinearTest : public RenderTest {
  protected:
    /// A lamp that shines brighter than a picture shows, and a sheet of glass before part of it.
    static scene::Scene brightScene() {
        scene::Scene scene = boxScene();
        scene.lights[0].color = glm::vec3(4.0f, 2.0f, 1.0f);
        scene.materials.push_back({.name = "lamp"});
        scene.materials.back().detail.emission = glm::vec3(9.0f, 6.0f, 3.0f);
        scene.materials.push_back({.name = "glass",
                                   .baseColorFactor = {0.2f, 0.4f, 0.8f, 0.5f},
                                   .alphaMode = scene::AlphaMode::blend});
        addBox(scene, {-1.0, 0.0, -5.0});
        scene::addInstance(scene, 0, 1, 1, {1.0, 0.0, -5.0}, glm::mat3(1.0f));
        scene::addInstance(scene, 0, 2, 2, {0.9, 0.0, -3.0}, glm::mat3(0.5f));
        return scene;
    }
    static render::RenderOptions linearOptions(const char* technique = "anchored") {
        render::RenderOptions options = smallOptions(depth::parseTechnique(technique));
        options.linear = true;
        return options;
    }
};

/// By how many steps the picture is off what its light amounts to.
int mostOff(const render::Frame& frame, float exposure) {
    int most = 0;
    for (std::size_t i = 0; i < frame.linear.pixels.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const double light = static_cast<double>(exposure * frame.linear.pixels[i][c]);
            most = std::max(most, std::abs(image::srgbOfLinear(std::min(light, 1.0)) -
                                           frame.color.pixels[i][static_cast<std::size_t>(c)]));
        }
    }
    return most;
}

float brightest(const render::Frame& frame) {
    float most = 0.0f;
    for (const glm::vec3& light : frame.linear.pixels) {
        most = std::max({most, light.r, light.g, light.b});
    }
    return most;
}

TEST_F(LinearTest, IsTheLightOfThePicture) {
    const scene::Scene scene = brightScene();
    for (const depth::Technique& technique : presetTechniques()) {
        render::RenderOptions options = linearOptions();
        options.technique = technique;
        const render::Frame frame = draw(scene, {}, options);
        EXPECT_LE(mostOff(frame, 1.0f), 1) << nameOf(technique);
        EXPECT_GT(brightest(frame), 2.0f) << nameOf(technique);
        options.linear = false;
        EXPECT_EQ(draw(scene, {}, options).color.pixels, frame.color.pixels) << nameOf(technique);
    }
}

TEST_F(LinearTest, ComesBeforeWhatFinishesAPicture) {
    const scene::Scene scene = brightScene();
    render::RenderOptions options = linearOptions();
    const render::Frame plain = draw(scene, {}, options);
    options.effects.finish = {.toneMap = render::ToneMap::none, .exposure = -2.0};
    const render::Frame exposed = draw(scene, {}, options);
    EXPECT_EQ(exposed.linear.pixels, plain.linear.pixels);
    EXPECT_LE(mostOff(exposed, 0.25f), 1);
    options.effects.finish = {.toneMap = render::ToneMap::neutral};
    options.effects.antialias = render::Antialias::edges;
    const render::Frame finished = draw(scene, {}, options);
    EXPECT_EQ(finished.linear.pixels, plain.linear.pixels);
    EXPECT_NE(finished.color.pixels, plain.color.pixels);
}

TEST_F(LinearTest, HasTheSameBitsForAllTargetsAndSubmissions) {
    const scene::Scene scene = brightScene();
    render::RenderOptions options = linearOptions("anchored/count:3");
    const render::Frame wanted = draw(scene, {}, options);
    for (const char* targets : {"single", "accumulate", "pool:2", "layers", "one-pass"}) {
        for (const render::Submission submission : submissions()) {
            options.targets = render::parseTargets(targets);
            options.submission = submission;
            options.threads = 2;
            EXPECT_EQ(draw(scene, {}, options).linear.pixels, wanted.linear.pixels)
                << targets << " " << nameOf(submission);
        }
    }
}

TEST_F(LinearTest, GoesIntoTheImageOfAHostThatWantsNoPicture) {
    const scene::Scene scene = brightScene();
    render::RenderOptions options = linearOptions();
    options.framesInFlight = 2;
    HostSide host(device(), {options.width, options.height}, vk::Format::eR16G16B16A16Sfloat);
    SoleRenderer renderer(device(), scene, options);
    for (const double fov : {0.5, 1.0, 1.4}) {
        const scene::Camera camera{.fovY = fov};
        render::HostFrame frame = host.begin();
        frame.linear = std::exchange(frame.color, {});
        host.submit(renderer, camera, frame);
        const auto halves = host.color<std::uint64_t>();
        const render::Frame wanted = draw(scene, camera, options);
        for (std::size_t i = 0; i < halves.pixels.size(); ++i) {
            ASSERT_EQ(glm::vec3(glm::unpackHalf4x16(halves.pixels[i])), wanted.linear.pixels[i]) << i;
        }
    }
}

/// Into an image of another format of floats it is converted.
TEST_F(LinearTest, FormatsOfFloatsHoldIt) {
    const scene::Scene scene = brightScene();
    const render::RenderOptions options = linearOptions();
    HostSide host(device(), {options.width, options.height}, vk::Format::eR32G32B32A32Sfloat);
    SoleRenderer renderer(device(), scene, options);
    render::HostFrame frame = host.begin();
    frame.linear = frame.color;
    frame.color = {};
    host.submit(renderer, {}, frame);
    const auto floats = host.color<glm::vec4>();
    const render::Frame wanted = draw(scene, {}, options);
    for (std::size_t i = 0; i < floats.pixels.size(); ++i) {
        ASSERT_EQ(glm::vec3(floats.pixels[i]), wanted.linear.pixels[i]) << i;
    }
}

TEST_F(LinearTest, OffIsNotThere) {
    scene::Scene scene = boxScene();
    addBox(scene, {0.0, 0.0, -5.0});
    render::RenderOptions options = linearOptions();
    options.linear = false;
    const render::GpuScene gpuScene(device(), scene);
    render::Renderer without(device(), scene, gpuScene, options);
    EXPECT_TRUE(without.render({}).linear.pixels.empty());
    EXPECT_EQ(without.surfaces().linear.image, VkImage(VK_NULL_HANDLE));
    options.linear = true;
    render::Renderer with(device(), scene, gpuScene, options);
    with.draw({});
    EXPECT_EQ(with.surfaces().linear.format, VK_FORMAT_R16G16B16A16_SFLOAT);
    HostSide host(device(), {options.width, options.height});
    render::HostFrame frame = host.begin();
    const auto refusal = [&](render::Renderer& renderer) {
        return test::inputErrorOf([&] { renderer.record({}, frame); }, "none");
    };
    frame.linear = frame.color;
    EXPECT_NE(refusal(without).find("keeps none"), std::string::npos);
    EXPECT_NE(refusal(with).find("floats"), std::string::npos); // 8 bits are none
    for (const VkFormat format :
         {VK_FORMAT_R32_SFLOAT, VK_FORMAT_R16G16_SFLOAT}) { // green or blue would be lost
        frame.linear->format = format;
        EXPECT_NE(refusal(with).find("floats"), std::string::npos) << format;
    }
    frame.linear = {};
    frame.color = {};
    EXPECT_NE(refusal(with).find("no color image"), std::string::npos);
    options.surface = render::SurfacePath::lit;
    EXPECT_THROW(render::Renderer(device(), scene, gpuScene, options), base::InputError);
}

} // namespace

} // namespace cdr::render_test
