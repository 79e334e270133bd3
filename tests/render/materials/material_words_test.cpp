#include <cdr/render/materials/material_words.h>
#include <cdr/shaders/shared.h>

#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace cdr::render {

namespace {

float cutoffOf(const MaterialWords& words) {
    return std::bit_cast<float>(words.cutoffAndMetallicRoughness & ~shaders::kMetallicRoughnessMask);
}

/// The metallic and roughness that a code not 0 stands for.
scene::MetallicRoughness metallicRoughnessOfCode(std::uint32_t code) {
    const std::uint32_t metallicStep = (code - 1) / shaders::kRoughnessSteps;
    const std::uint32_t roughnessStep = (code - 1) % shaders::kRoughnessSteps;
    return {.metallic = static_cast<float>(metallicStep) / (shaders::kMetallicSteps - 1),
            .roughness = static_cast<float>(roughnessStep) / (shaders::kRoughnessSteps - 1)};
}

TEST(MetallicRoughnessCode, ZeroIsMattAlone) {
    EXPECT_EQ(metallicRoughnessCode({}), 0u);
    EXPECT_EQ(metallicRoughnessCode(scene::MetallicRoughness{.metallic = 0.0f, .roughness = 0.0f}), 1u);
    EXPECT_EQ(metallicRoughnessCode(scene::MetallicRoughness{}), 255u);
}

TEST(MetallicRoughnessCode, IsWithinHalfAStepOfEveryValue) {
    for (int m = 0; m <= 100; ++m) {
        for (int r = 0; r <= 1000; ++r) {
            const scene::MetallicRoughness metallicRoughness{.metallic = static_cast<float>(m) / 100.0f,
                                                             .roughness = static_cast<float>(r) / 1000.0f};
            const std::uint32_t code = metallicRoughnessCode(metallicRoughness);
            ASSERT_GE(code, 1u);
            ASSERT_LE(code, shaders::kMetallicRoughnessMask);
            const scene::MetallicRoughness kept = metallicRoughnessOfCode(code);
            ASSERT_LE(std::abs(kept.metallic - metallicRoughness.metallic), 0.125f + 1e-6f) << m;
            ASSERT_LE(std::abs(kept.roughness - metallicRoughness.roughness), 0.01f + 1e-6f) << r;
        }
    }
}

TEST(MetallicRoughnessCode, EachCodeIsItsOwn) {
    for (std::uint32_t code = 1; code <= shaders::kMetallicRoughnessMask; ++code) {
        EXPECT_EQ(metallicRoughnessCode(metallicRoughnessOfCode(code)), code);
    }
}

TEST(MetallicRoughnessCode, TenthsOfRoughnessAreExact) {
    for (int tenth = 0; tenth <= 10; ++tenth) {
        const scene::MetallicRoughness metallicRoughness{.metallic = 0.5f,
                                                         .roughness = static_cast<float>(tenth) / 10.0f};
        EXPECT_NEAR(metallicRoughnessOfCode(metallicRoughnessCode(metallicRoughness)).roughness,
                    metallicRoughness.roughness, 1e-7f);
        EXPECT_EQ(metallicRoughnessOfCode(metallicRoughnessCode(metallicRoughness)).metallic, 0.5f);
    }
}

TEST(MetallicRoughnessCode, WhatLiesOutsideCountsAsTheEnds) {
    EXPECT_EQ(metallicRoughnessCode(scene::MetallicRoughness{.metallic = -3.0f, .roughness = 7.0f}),
              metallicRoughnessCode(scene::MetallicRoughness{.metallic = 0.0f, .roughness = 1.0f}));
}

scene::Material masked(float alpha, float cutoff) {
    return {.name = "mask",
            .baseColorFactor = glm::vec4(1.0f, 1.0f, 1.0f, alpha),
            .alphaMode = scene::AlphaMode::mask,
            .alphaCutoff = cutoff};
}

/// glTF keeps an alpha of at least the cutoff. Half floats of the factor would be above or below it.
TEST(MaterialWords, AMaskComparesTheFactorExactly) {
    for (const float alpha : {0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.8f, 0.9f, 1.0f}) {
        EXPECT_LE(cutoffOf(wordsOf(masked(alpha, alpha))), 1.0f) << alpha;
        EXPECT_GT(cutoffOf(wordsOf(masked(alpha, alpha))), 0.9999f) << alpha;
        EXPECT_GT(cutoffOf(wordsOf(masked(alpha, alpha * 1.0001f))), 1.0f) << alpha;
        EXPECT_EQ(glm::unpackHalf2x16(wordsOf(masked(alpha, alpha)).baseColorBa).y, 1.0f) << alpha;
    }
    EXPECT_LT(cutoffOf(wordsOf(masked(0.4f, 0.4f))), 1.0f); // interpolation may round
    EXPECT_EQ(cutoffOf(wordsOf(masked(1.0f, 0.5f))), 0.5f);
    EXPECT_TRUE(std::isinf(cutoffOf(wordsOf(masked(0.0f, 0.5f)))));
    EXPECT_EQ(cutoffOf(wordsOf(masked(0.0f, 0.0f))), 0.0f);
    EXPECT_EQ(leastAlphaOf(masked(0.0f, 0.5f)), INFINITY);
}

TEST(MaterialWords, HoldTheCutoffBesideMetallicAndRoughness) {
    for (const float cutoff : {0.0f, 0.25f, 0.5f, 1.0f, 0.4f, 1e-3f, 17.0f, INFINITY}) {
        scene::Material material{.name = "mask", .alphaCutoff = cutoff};
        EXPECT_EQ(wordsOf(material).cutoffAndMetallicRoughness & shaders::kMetallicRoughnessMask, 0u);
        material.metallicRoughness = scene::MetallicRoughness{};
        const MaterialWords words = wordsOf(material);
        EXPECT_EQ(words.cutoffAndMetallicRoughness & shaders::kMetallicRoughnessMask, 255u);
        EXPECT_LE(cutoffOf(words), cutoff);
        EXPECT_GE(cutoffOf(words), cutoff * (1.0f - 0x1p-15f));
    }
    EXPECT_EQ(cutoffOf(wordsOf({.name = "half", .alphaCutoff = 0.5f})), 0.5f);
}

/// Infinity times a black texel would be no number.
TEST(MaterialWords, OfABrightColorAreFinite) {
    for (const float bright : {scene::kMaxBaseColor, 65520.0f, 1e6f, 3e38f}) {
        const MaterialWords words =
            wordsOf({.name = "bright", .baseColorFactor = {bright, 0.5f, bright, 1.0f}});
        EXPECT_EQ(glm::unpackHalf2x16(words.baseColorRg), glm::vec2(65504.0f, 0.5f)) << bright;
        EXPECT_EQ(glm::unpackHalf2x16(words.baseColorBa), glm::vec2(65504.0f, 1.0f)) << bright;
    }
}

TEST(NormalScale, IsBoundedInBothDirections) {
    EXPECT_EQ(normalScaleOf({.normalScale = 3e38f}), scene::kMaxNormalScale);
    EXPECT_EQ(normalScaleOf({.normalScale = -3e38f}), -scene::kMaxNormalScale);
    EXPECT_EQ(normalScaleOf({.normalScale = -2.5f}), -2.5f);
}

TEST(MaterialWords, UnlitCountsAsMatt) {
    EXPECT_EQ(wordsOf({.name = "unlit", .metallicRoughness = scene::MetallicRoughness{}, .unlit = true})
                      .cutoffAndMetallicRoughness &
                  shaders::kMetallicRoughnessMask,
              0u);
}

} // namespace

} // namespace cdr::render
