#include "../../support/refusal.h"
#include "../failing_calls.h"
#include "../fixture.h"
#include "../steps.h"

#include <cdr/measure/truth/layered_truth.h>
#include <scenes/sheets.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>
#include <system_error>
#include <utility>

namespace cdr::render_test {

namespace {

constexpr std::uint32_t kSide = 256;

/// Single texels in turn black and white: half the light of white, seen from afar.
image::ImageRgba8 chequered() {
    image::ImageRgba8 picture(kSide, kSide);
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            const auto value = static_cast<std::uint8_t>((x + y) % 2 == 0 ? 255 : 0);
            picture.at(x, y) = {value, value, value, 255};
        }
    }
    return picture;
}

/// A square that shows a texture and no light.
scene::Scene squareWith(const scene::Texture& texture) {
    scene::Scene scene;
    scene.meshes = {scenes::makeSquare(1.0f)};
    scene.textures = {texture};
    scene.materials = {{.name = "shown", .baseColorTexture = 0, .unlit = true}};
    scene::addInstance(scene, 0, 0, 0, glm::dvec3(0.0), glm::mat3(1.0f));
    return scene;
}

class LevelsTest : public RenderTest {
  protected:
    /// Twenty texels of kSide in a pixel, or a twentieth.
    static scene::Camera camera(bool isFar) {
        const double distance = isFar ? 40.0 : 0.04;
        return scene::lookAt({.fovY = 0.5, .nearView = 0.01, .farView = 100.0}, {0.0, 0.0, distance},
                             glm::dvec3(0.0));
    }

    static render::RenderOptions options() {
        return withSorting(smallOptions(depth::parseTechnique("reversed"), 240, 135));
    }

    /// The values of red that the square shows.
    std::set<int> redsOf(const scene::Scene& scene, bool isFar,
                         const render::RenderOptions& with = options()) {
        const render::Frame frame = draw(scene, camera(isFar), with);
        std::set<int> reds;
        const std::uint32_t middle = frame.height() / 2;
        for (std::uint32_t x = frame.width() / 2 - 4; x < frame.width() / 2 + 4; ++x) {
            for (std::uint32_t y = middle - 4; y < middle + 4; ++y) {
                reds.insert(frame.color.at(x, y)[0]);
            }
        }
        return reds;
    }

    static bool areGrey(const std::set<int>& reds, int slack = 1) {
        return std::all_of(reds.begin(), reds.end(), [&](int red) { return std::abs(red - 188) <= slack; });
    }
};

} // namespace

TEST_F(LevelsTest, SmallTexelsAreAveragedInLinearLight) {
    for (const auto levels : {scene::TextureLevels::blended, scene::TextureLevels::nearest}) {
        for (const scene::Filter filter : {scene::Filter::linear, scene::Filter::nearest}) {
            const scene::Texture texture{.pixels = chequered(), .minFilter = filter, .levels = levels};
            EXPECT_TRUE(areGrey(redsOf(squareWith(texture), true)));
        }
    }
}

TEST_F(LevelsTest, DataIsAveragedAsItIs) {
    scene::Scene scene = squareWith({.pixels = chequered(), .content = scene::TextureContent::data});
    scene.materials[0] = {.name = "glows", .baseColorFactor = {0.0f, 0.0f, 0.0f, 1.0f}};
    scene.ambient = glm::vec3(0.0f);
    scene.materials[0].detail = {.emissive = scene::TextureUse{}, .emission = glm::vec3(1.0f)};
    EXPECT_TRUE(
        areGrey(redsOf(scene, true), 4)); // emission has steps of 3 %; averaged as a colour it were 221
}

TEST_F(LevelsTest, WithoutLevelsSmallTexelsAlias) {
    scene::Texture texture{.pixels = chequered(), .levels = scene::TextureLevels::none};
    EXPECT_FALSE(areGrey(redsOf(squareWith(texture), true)));
    texture.minFilter = scene::Filter::nearest;
    const std::set<int> single = redsOf(squareWith(texture), true);
    EXPECT_TRUE(std::all_of(single.begin(), single.end(), [](int red) { return red == 0 || red == 255; }));
    EXPECT_EQ(single.size(), 2u) << "black alone is no picture";
}

TEST_F(LevelsTest, LargeTexelsHaveAFilterOfTheirOwn) {
    scene::Texture texture{.pixels = chequered(), .magFilter = scene::Filter::nearest};
    const std::set<int> single = redsOf(squareWith(texture), false);
    EXPECT_TRUE(std::all_of(single.begin(), single.end(), [](int red) { return red == 0 || red == 255; }));
    EXPECT_EQ(single.size(), 2u);
    texture = {
        .pixels = chequered(), .minFilter = scene::Filter::nearest, .levels = scene::TextureLevels::none};
    EXPECT_GT(redsOf(squareWith(texture), false).size(), 2u);
}

TEST_F(LevelsTest, EveryPipelineReadsThem) {
    const scene::Texture texture{.pixels = chequered()};
    const scene::Scene plain = squareWith(texture);
    scene::Scene other = plain;
    other.materials[0].alphaMode = scene::AlphaMode::blend;
    EXPECT_TRUE(areGrey(redsOf(other, true))) << "blended";
    render::RenderOptions weighted = options();
    weighted.translucency.method = render::Translucency::weighted;
    EXPECT_TRUE(areGrey(redsOf(other, true, weighted))) << "blended by weights";
    other.materials[0].alphaMode = scene::AlphaMode::mask;
    EXPECT_TRUE(areGrey(redsOf(other, true))) << "masked";
    other = plain;
    other.materials[0].layer = 0.01f;
    EXPECT_TRUE(areGrey(redsOf(other, true))) << "with a layer offset";
    for (const char* technique : {"logcdr", "anchored", "log-fragment/none"}) {
        render::RenderOptions with = options();
        with.technique = depth::parseTechnique(technique);
        EXPECT_TRUE(areGrey(redsOf(plain, true, with))) << technique;
    }
}

/// Leaves of a few texels cover as much of a pixel, however far they are.
TEST_F(LevelsTest, MaskedOnesShowAsMuchFromAfar) {
    scene::Texture texture{
        .pixels = image::ImageRgba8(kSide, kSide, {90, 160, 40, 0}), .alphaWeighs = true, .cutoff = 0.5f};
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            const std::uint32_t spread = (x / 3 * 2654435761u) ^ (y / 3 * 2246822519u);
            texture.pixels.at(x, y)[3] = (spread >> 20u) % 10 < 3 ? 255 : 0;
        }
    }
    scene::Scene scene = squareWith(texture);
    scene.materials[0].alphaMode = scene::AlphaMode::mask;
    const auto shareAt = [&](double distance) {
        const scene::Camera from = scene::lookAt({.fovY = 0.5, .nearView = 0.01, .farView = 100.0},
                                                 {0.0, 0.0, distance}, glm::dvec3(0.0));
        const image::ImageU32 ids = draw(scene, from, options()).ids();
        scene::Scene whole = scene;
        whole.materials[0].alphaMode = scene::AlphaMode::opaque;
        const image::ImageU32 all = draw(whole, from, options()).ids();
        const auto shown = [](const image::ImageU32& of) {
            return static_cast<double>(std::count(of.pixels.begin(), of.pixels.end(), 1u));
        };
        return shown(ids) / shown(all);
    };
    const double near = shareAt(2.0);
    for (const double distance : {4.0, 8.0, 16.0}) {
        EXPECT_NEAR(shareAt(distance), near, 0.1) << distance; // a blend of two levels keeps less
    }
    scene.textures[0].cutoff.reset();
    EXPECT_LT(shareAt(16.0), 0.5 * near);
}

/// A floor that goes on to the horizon has every level, and pictures change their levels from row to row.
TEST_F(LevelsTest, LooksAsFloat64TruthFromNearToFar) {
    scene::Texture texture{.pixels = image::ImageRgba8(kSide, kSide)};
    for (std::size_t i = 0; i < texture.pixels.pixels.size(); ++i) {
        const auto noise = static_cast<std::uint32_t>(i * 2654435761u);
        texture.pixels.pixels[i] = {static_cast<std::uint8_t>(noise >> 24),
                                    static_cast<std::uint8_t>(noise >> 16),
                                    static_cast<std::uint8_t>(noise >> 8), 255};
    }
    scene::Scene scene = squareWith(texture);
    const scene::Camera camera =
        scene::lookAt({.fovY = 0.5, .nearView = 0.01, .farView = 100.0}, {0.0, -2.0, 0.25}, glm::dvec3(0.0));
    const render::Frame frame = draw(scene, camera, options());
    const auto meanSteps = [&](const scene::Scene& of) {
        const measure::LayeredTruth truth = layersOf(of, camera, frame.width(), frame.height());
        const image::ImageRgba8 wanted = measure::pictureOf(truth);
        double sum = 0.0;
        double count = 0.0;
        const image::ImageU32 ids = frame.ids();
        for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
            if (truth.pixels[i].isInner && ids.pixels[i] != 0) {
                for (std::size_t c = 0; c < 3; ++c) {
                    sum += std::abs(int{wanted.pixels[i][c]} - int{frame.color.pixels[i][c]}) / 3.0;
                }
                count += 1.0;
            }
        }
        return sum / count;
    };
    EXPECT_LE(meanSteps(scene), 4.0);
    scene.textures[0].levels = scene::TextureLevels::none;
    EXPECT_GE(meanSteps(scene), 15.0);
}

/// Devices have as few as 4,000 samplers.
TEST_F(LevelsTest, TexturesOfTheSameOptionsShareASampler) {
    scene::Scene scene = squareWith({.name = "first", .pixels = image::ImageRgba8(1, 1)});
    const auto addTexture = [&](const scene::Texture& texture) {
        scene.materials.push_back(scene.materials[0]);
        scene.materials.back().baseColorTexture = static_cast<std::uint32_t>(scene.textures.size());
        scene.textures.push_back(texture);
    };
    const scene::Texture texture = scene.textures[0];
    for (int i = 0; i < 8; ++i) {
        addTexture(texture);
    }
    const auto makesMoreThan = [&](std::size_t samplers) {
        const FailingCall failing("vkCreateSampler", samplers);
        try {
            const render::GpuScene onDevice(device(), scene);
        } catch (const std::system_error&) { // of the call that failed
        }
        return FailingCall::hasFailed();
    };
    EXPECT_FALSE(makesMoreThan(1)); // that of materials without a texture is among them
    scene::Texture clamped = texture;
    clamped.wrapU = scene::WrapMode::clampToEdge;
    addTexture(clamped);
    addTexture(clamped);
    EXPECT_TRUE(makesMoreThan(1));
    EXPECT_FALSE(makesMoreThan(2));
}

TEST_F(LevelsTest, ATextureThatIsTooLargeIsNamed) {
    const image::ImageRgba8 wide(device().info().maxImageSide + 1, 1, {255, 255, 255, 255});
    for (const auto& [name, said] : {std::pair{"", "texture 0: "}, {"bricks", "texture 0 bricks: "}}) {
        const scene::Scene scene = squareWith({.name = name, .pixels = wide});
        const std::string message =
            test::inputErrorOf([&] { const render::GpuScene onDevice(device(), scene); });
        EXPECT_EQ(message.find(said), 0u) << message;
    }
}

} // namespace cdr::render_test
