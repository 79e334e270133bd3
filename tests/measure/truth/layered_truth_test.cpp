#include <cdr/base/error.h>
#include <cdr/image/srgb.h>
#include <cdr/measure/truth/layered_truth.h>
#include <cdr/measure/truth/surface_hit.h>
#include <scenes/sheets.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

namespace cdr::measure {

namespace {

constexpr std::uint32_t kSide = 9;

/// Squares across the view axis, unlit.
struct Stack {
    scene::Scene scene;

    Stack() {
        scene.meshes.push_back(scenes::makeSquare(1.0f));
        scene.background = glm::vec3(0.1f, 0.2f, 0.3f);
    }

    void add(double w, const glm::vec4& color, bool blended, bool doubleSided = true, bool turned = false) {
        const auto number = static_cast<std::uint32_t>(scene.materials.size());
        scene.materials.push_back(
            {.name = "layer",
             .baseColorFactor = color,
             .doubleSided = doubleSided,
             .unlit = true,
             .alphaMode = blended ? scene::AlphaMode::blend : scene::AlphaMode::opaque});
        glm::mat3 basis(static_cast<float>(2.0 * w));
        if (turned) {
            basis[0] = -basis[0];
            basis[2] = -basis[2];
        }
        scene::addInstance(scene, 0, number, number, glm::dvec3(0.0, 0.0, -w), basis);
    }

    LayeredPixel middle(double nearView = 0.1, double farView = 100.0) const {
        platform::WorkerPool workers(1);
        const scene::Camera camera{.fovY = 1.0, .nearView = nearView, .farView = farView};
        return castLayers(scene, camera, kSide, kSide, workers).at(3, 4);
    }
};

void expectColor(const LayeredPixel& pixel, const glm::dvec3& wanted) {
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(pixel.color[c], wanted[c], 1e-7) << c;
    }
}

TEST(LayeredTruth, LaysNearOverFarWhateverTheOrderTheyAreGivenIn) {
    Stack stack;
    stack.add(4.0, {0.0f, 1.0f, 0.0f, 0.25f}, true);
    stack.add(8.0, {0.0f, 0.0f, 1.0f, 1.0f}, false);
    stack.add(2.0, {1.0f, 0.0f, 0.0f, 0.5f}, true);
    const LayeredPixel pixel = stack.middle();
    expectColor(pixel, {0.5, 0.5 * 0.25, 0.5 * 0.75});
    EXPECT_EQ(pixel.fragments, 2u);
    EXPECT_TRUE(pixel.isInner);
}

TEST(LayeredTruth, OfNoTranslucentPixelNothingIsSaid) {
    EXPECT_EQ(LayerDifference{}.withinFraction(), std::nullopt);
    EXPECT_EQ((LayerDifference{.pixels = 8, .translucent = 4, .within = 1}.withinFraction()), 0.25);
}

TEST(LayeredTruth, OpaqueSurfacesAndTheRangeEndARay) {
    Stack stack;
    stack.add(1.0, {1.0f, 1.0f, 1.0f, 0.5f}, true); // before near
    stack.add(3.0, {1.0f, 0.0f, 0.0f, 0.5f}, true);
    stack.add(5.0, {0.0f, 1.0f, 0.0f, 0.3f}, false); // an opaque material's alpha is none
    stack.add(6.0, {1.0f, 1.0f, 1.0f, 0.5f}, true);
    EXPECT_EQ(stack.middle(2.0).fragments, 1u);
    expectColor(stack.middle(2.0), {0.5, 0.5, 0.0});
    EXPECT_EQ(stack.middle(2.0, 4.0).fragments, 1u); // nothing opaque before far
    expectColor(stack.middle(2.0, 4.0), {0.5 + 0.05, 0.1, 0.15});
}

TEST(LayeredTruth, OfEqualOpaqueSurfacesTheLastInTheScenesOrderShows) {
    Stack stack;
    stack.add(4.0, {1.0f, 0.0f, 0.0f, 1.0f}, false);
    stack.add(4.0, {0.0f, 1.0f, 0.0f, 1.0f}, false);
    stack.add(4.0, {0.0f, 0.0f, 1.0f, 1.0f}, false);
    stack.scene.instances.object = {7, 9, 4};
    expectColor(stack.middle(), {0.0, 0.0, 1.0});
}

TEST(LayeredTruth, OnAnOpaqueSurfaceIsInFrontOfIt) {
    Stack stack;
    stack.add(5.0, {0.0f, 0.0f, 1.0f, 1.0f}, false);
    stack.add(5.0, {1.0f, 0.0f, 0.0f, 0.5f}, true);
    EXPECT_EQ(stack.middle().fragments, 1u);
    expectColor(stack.middle(), {0.5, 0.0, 0.5});
}

TEST(LayeredTruth, BacksShowOnDoubleSidedSurfacesOnly) {
    Stack stack;
    stack.add(3.0, {1.0f, 0.0f, 0.0f, 0.5f}, true, false, true); // its back towards the camera
    stack.add(4.0, {0.0f, 1.0f, 0.0f, 0.5f}, true, false, false);
    stack.add(5.0, {0.0f, 0.0f, 1.0f, 0.5f}, true, true, true);
    EXPECT_EQ(stack.middle().fragments, 2u);
}

TEST(LayeredTruth, UnlitSurfacesAddWhatTheyEmit) {
    Stack stack;
    stack.add(2.0, {0.5f, 0.0f, 0.25f, 0.5f}, true);
    stack.add(4.0, {0.0f, 1.0f, 0.0f, 1.0f}, false);
    for (scene::Material& material : stack.scene.materials) {
        material.detail.occlusion = scene::TextureUse{}; // of light, of which there is none
        material.detail.emission = glm::vec3(0.25f, 0.5f, 0.0f);
    }
    stack.scene.textures.push_back({.name = "dark", .pixels = image::ImageRgba8(1, 1)});
    expectColor(stack.middle(), {0.5 * 0.75 + 0.5 * 0.25, 0.5 * 0.5 + 0.5 * 1.5, 0.5 * 0.25});
}

/// As the renderer has it, which keeps colours as half floats: the sum, of each surface, before it is blended.
TEST(LayeredTruth, WhatEmitsIsCutOff) {
    Stack stack;
    stack.add(2.0, {20.0f, 1.0f, 0.0f, 0.5f}, true);
    stack.add(4.0, {0.0f, 1.0f, 20.0f, 1.0f}, false); // as 1: a G-buffer holds no more
    for (scene::Material& material : stack.scene.materials) {
        material.detail.emission = glm::vec3(8.0f, 100.0f, 0.0f);
    }
    expectColor(stack.middle(), {0.5 * 16.0 + 0.5 * 8.0, 0.5 * 16.0 + 0.5 * 16.0, 0.5});
    stack.scene.materials[0].detail.emission = glm::vec3(0.0f); // what does not emit is not cut off
    expectColor(stack.middle(), {0.5 * 20.0 + 0.5 * 8.0, 0.5 + 0.5 * 16.0, 0.5});
}

/// Of what blends, shading cuts off what reads textures of detail too. Other detail is none that it reads.
TEST(LayeredTruth, WhatBlendsIsCutOffWithATextureOfDetail) {
    Stack stack;
    stack.add(2.0, {1.0f, 1.0f, 1.0f, 0.25f}, true);
    stack.scene.background = glm::vec3(0.0f);
    stack.scene.ambient = glm::vec3(40.0f);
    stack.scene.textures.push_back(
        {.name = "white", .pixels = image::ImageRgba8(1, 1, {255, 255, 255, 255})});
    scene::Material& material = stack.scene.materials[0];
    material.unlit = false;
    for (const scene::MaterialDetail& unread :
         {scene::MaterialDetail{.normalScale = 0.5f}, scene::MaterialDetail{.occlusionStrength = 0.5f}}) {
        material.detail = unread;
        expectColor(stack.middle(), glm::dvec3(0.25 * 40.0));
        material.detail.occlusion = scene::TextureUse{};
        expectColor(stack.middle(), glm::dvec3(0.25 * 16.0));
    }
}

TEST(LayeredTruth, PixelsNextToASilhouetteAreNotInner) {
    Stack stack;
    stack.add(4.0, {0.0f, 1.0f, 0.0f, 0.5f}, true);
    stack.scene.instances.x[0] = 8.0 + 0.1; // its left edge a little right of the middle
    platform::WorkerPool workers(2);
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.1, .farView = 100.0};
    const LayeredTruth truth = castLayers(stack.scene, camera, kSide, kSide, workers);
    for (std::uint32_t x = 1; x + 1 < kSide; ++x) {
        EXPECT_EQ(truth.at(x, 4).fragments, x > 4 ? 1u : 0u);
        EXPECT_EQ(truth.at(x, 4).isInner, x != 4 && x != 5) << x;
    }
    EXPECT_FALSE(truth.at(0, 4).isInner);
}

/// Rows are cast in bands, so that each row of faces is kept only while its neighbours ask for it.
TEST(LayeredTruth, PixelsBelowAnEdgeAreNotInnerWhateverTheRow) {
    constexpr std::uint32_t kHeight = 100;
    platform::WorkerPool workers(2);
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.1, .farView = 100.0};
    for (std::uint32_t edge = 2; edge + 2 < kHeight; ++edge) {
        Stack stack;
        stack.add(4.0, {0.0f, 1.0f, 0.0f, 0.5f}, true);
        const double pixel = 2.0 * 4.0 * std::tan(0.5) / kHeight;
        // Its upper edge between the centres of two rows.
        stack.scene.instances.y[0] = -8.0 + pixel * (kHeight / 2.0 - edge);
        const LayeredTruth truth = castLayers(stack.scene, camera, 3, kHeight, workers);
        for (std::uint32_t y = 1; y + 1 < kHeight; ++y) {
            ASSERT_EQ(truth.at(1, y).fragments, y >= edge ? 1u : 0u) << edge << " " << y;
            ASSERT_EQ(truth.at(1, y).isInner, y + 1 != edge && y != edge) << edge << " " << y;
        }
    }
}

TEST(LayeredTruth, TakesNoMoreMemoryThanItsPixelsAndSomeRows) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "AddressSanitizer keeps what is freed";
#endif
    constexpr std::uint32_t kPicture = 1024;
    Stack stack;
    for (int i = 0; i < 8; ++i) {
        stack.add(4.0 + i, {0.0f, 1.0f, 0.0f, 0.5f}, true);
    }
    platform::WorkerPool workers(2);
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.1, .farView = 100.0};
    const auto peakKiB = [] {
        std::ifstream status("/proc/self/status");
        std::size_t kib = 0;
        for (std::string word; status >> word && word != "VmHWM:";) {
        }
        status >> kib;
        return kib;
    };
    castLayers(stack.scene, camera, kSide, kSide, workers); // what any call takes is taken
    std::ofstream("/proc/self/clear_refs") << "5\n";        // else the peak may be one of an earlier test
    const std::size_t before = peakKiB();
    EXPECT_GT(before, 0u);
    const LayeredTruth truth = castLayers(stack.scene, camera, kPicture, kPicture, workers);
    EXPECT_EQ(truth.at(500, 500).fragments, 8u);
    EXPECT_GT((peakKiB() - before) * 1024, truth.pixels.size() * sizeof(LayeredPixel) / 2) << "it is counted";
    EXPECT_LT((peakKiB() - before) * 1024, truth.pixels.size() * 2 * sizeof(LayeredPixel));
}

TEST(LayeredTruth, ComparesInnerPixelsOnly) {
    Stack stack;
    stack.add(4.0, {0.0f, 1.0f, 0.0f, 0.5f}, true);
    platform::WorkerPool workers(1);
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.1, .farView = 100.0};
    const LayeredTruth truth = castLayers(stack.scene, camera, kSide, kSide, workers);
    image::ImageRgba8 picture = pictureOf(truth);
    image::ImageU32 fragmentCounts(kSide, kSide, 1);
    fragmentCounts.at(0, 0) = 7; // at the border
    picture.at(4, 4)[1] = static_cast<std::uint8_t>(picture.at(4, 4)[1] - 3);
    fragmentCounts.at(5, 5) = 2;
    const LayerDifference difference = compareLayers(picture, fragmentCounts, truth);
    EXPECT_EQ(difference.translucent, (kSide - 2) * (kSide - 2));
    EXPECT_EQ(difference.miscounted, 1u);
    EXPECT_EQ(difference.within, difference.translucent - 1);
    EXPECT_EQ(difference.largestError, 3u);
    EXPECT_THROW(compareLayers(image::ImageRgba8(2, 2), fragmentCounts, truth), base::InputError);
}

TEST(SampleTexture, IsBilinearInLinearLightAndWraps) {
    scene::Texture texture{.name = "two", .pixels = image::ImageRgba8(2, 1)};
    texture.pixels.at(0, 0) = {0, 0, 0, 0};
    texture.pixels.at(1, 0) = {255, 188, 0, 255};
    const double linear188 = image::linearOfSrgb()[188];
    EXPECT_NEAR(sampleTexture(texture, {0.75, 0.3}).r, 1.0, 1e-12);
    EXPECT_NEAR(sampleTexture(texture, {0.5, 0.3}).g, 0.5 * linear188, 1e-12);
    EXPECT_NEAR(sampleTexture(texture, {1.0, 0.3}).a, 0.5, 1e-12); // half-way to the first again
    texture.wrapU = scene::WrapMode::clampToEdge;
    EXPECT_NEAR(sampleTexture(texture, {1.0, 0.3}).a, 1.0, 1e-12);
    EXPECT_NEAR(sampleTexture(texture, {-3.0, 0.3}).a, 0.0, 1e-12);
}

/// The texel of a nearest filter beyond what any integer holds. 3e30 is 1 above a multiple of 3, and 4 above one of 6.
double texelAt(double u, scene::WrapMode mode) {
    scene::Texture texture{.name = "three", .pixels = image::ImageRgba8(3, 1)};
    for (std::uint32_t x = 0; x < 3; ++x) {
        texture.pixels.at(x, 0)[3] = static_cast<std::uint8_t>(x);
    }
    texture.magFilter = scene::Filter::nearest;
    texture.wrapU = mode;
    return std::round(255.0 * sampleTexture(texture, {u, 0.5}).a);
}

TEST(SampleTexture, WrapsPlacesOfAnySize) {
    using scene::WrapMode;
    EXPECT_EQ(texelAt(1e30, WrapMode::clampToEdge), 2.0);
    EXPECT_EQ(texelAt(-1e30, WrapMode::clampToEdge), 0.0);
    EXPECT_EQ(texelAt(1e30, WrapMode::repeat), 1.0);
    EXPECT_EQ(texelAt(-1e30, WrapMode::repeat), 2.0);
    EXPECT_EQ(texelAt(1e30, WrapMode::mirroredRepeat), 1.0);
    EXPECT_EQ(texelAt(-1e30, WrapMode::mirroredRepeat), 2.0);
    EXPECT_EQ(texelAt(-0.1, WrapMode::repeat), 2.0);
    EXPECT_EQ(texelAt(-0.1, WrapMode::mirroredRepeat), 0.0);
    EXPECT_EQ(texelAt(1.4, WrapMode::mirroredRepeat), 1.0);
}

/// A texture whose texels are a hundredth of a pixel is seen as its smallest level.
glm::dvec4 seenFromAfar(const scene::Texture& texture) {
    scene::Scene scene;
    scene.textures = {texture};
    return TruthTextures(scene).sample(0, {0.5, 0.5}, {.right = {1.0, 0.0}, .down = {0.0, 1.0}});
}

TEST(SampleTexture, ColoursCountByAlphaWhereTheTextureSaysSo) {
    scene::Texture texture{.name = "two", .pixels = image::ImageRgba8(2, 1)};
    texture.pixels.at(0, 0) = {255, 0, 0, 255};
    texture.pixels.at(1, 0) = {0, 255, 0, 0};
    EXPECT_NEAR(seenFromAfar(texture).r, 0.5, 1e-6);
    texture.alphaWeighs = true;
    EXPECT_NEAR(seenFromAfar(texture).r, 1.0, 1e-6);
    EXPECT_NEAR(seenFromAfar(texture).g, 0.0, 1e-6);
    EXPECT_NEAR(seenFromAfar(texture).a, 0.5, 1e-6);
}

TEST(SampleTexture, MasksKeepTheirShare) {
    scene::Texture texture{.name = "mask", .pixels = image::ImageRgba8(10, 10, {9, 9, 9, 100})};
    for (std::size_t i = 0; i < 60; ++i) {
        texture.pixels.pixels[i][3] = 140; // 124 on average
    }
    EXPECT_LT(seenFromAfar(texture).a, 0.5);
    texture.cutoff = 0.5f;
    EXPECT_GT(seenFromAfar(texture).a, 0.5); // most is shown
}

} // namespace

} // namespace cdr::measure
