#include <cdr/render/materials/material_words.h>
#include <cdr/shaders/shared.h>

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <set>

namespace cdr::render {

namespace {

float cutoffOf(const MaterialWords& words) {
    return std::bit_cast<float>(words.cutoffAndShine & ~shaders::kShineMask);
}

/// The metallic and roughness that a code not 0 stands for.
scene::Shine shineOfCode(std::uint32_t code) {
    const std::uint32_t metallicStep = (code - 1) / shaders::kRoughnessSteps;
    const std::uint32_t roughnessStep = (code - 1) % shaders::kRoughnessSteps;
    return {.metallic = static_cast<float>(metallicStep) / (shaders::kMetallicSteps - 1),
            .roughness = static_cast<float>(roughnessStep) / (shaders::kRoughnessSteps - 1)};
}

TEST(ShineCode, ZeroIsMattAlone) {
    EXPECT_EQ(shineCode({}), 0u);
    EXPECT_EQ(shineCode(scene::Shine{.metallic = 0.0f, .roughness = 0.0f}), 1u);
    EXPECT_EQ(shineCode(scene::Shine{}), 255u);
}

TEST(ShineCode, IsWithinHalfAStepOfEveryValue) {
    for (int m = 0; m <= 100; ++m) {
        for (int r = 0; r <= 1000; ++r) {
            const scene::Shine shine{.metallic = static_cast<float>(m) / 100.0f,
                                     .roughness = static_cast<float>(r) / 1000.0f};
            const std::uint32_t code = shineCode(shine);
            ASSERT_GE(code, 1u);
            ASSERT_LE(code, shaders::kShineMask);
            const scene::Shine kept = shineOfCode(code);
            ASSERT_LE(std::abs(kept.metallic - shine.metallic), 0.125f + 1e-6f) << m;
            ASSERT_LE(std::abs(kept.roughness - shine.roughness), 0.01f + 1e-6f) << r;
        }
    }
}

TEST(ShineCode, EachCodeIsItsOwn) {
    for (std::uint32_t code = 1; code <= shaders::kShineMask; ++code) {
        EXPECT_EQ(shineCode(shineOfCode(code)), code);
    }
}

TEST(ShineCode, TenthsOfRoughnessAreExact) {
    for (int tenth = 0; tenth <= 10; ++tenth) {
        const scene::Shine shine{.metallic = 0.5f, .roughness = static_cast<float>(tenth) / 10.0f};
        EXPECT_NEAR(shineOfCode(shineCode(shine)).roughness, shine.roughness, 1e-7f);
        EXPECT_EQ(shineOfCode(shineCode(shine)).metallic, 0.5f);
    }
}

TEST(ShineCode, WhatLiesOutsideCountsAsTheEnds) {
    EXPECT_EQ(shineCode(scene::Shine{.metallic = -3.0f, .roughness = 7.0f}),
              shineCode(scene::Shine{.metallic = 0.0f, .roughness = 1.0f}));
}

TEST(MaterialWords, HoldTheCutoffBesideTheShine) {
    for (const float cutoff : {0.0f, 0.25f, 0.5f, 1.0f, 0.4f, 1e-3f, 17.0f, INFINITY}) {
        scene::Material material{.name = "mask", .alphaCutoff = cutoff};
        EXPECT_EQ(wordsOf(material).cutoffAndShine & shaders::kShineMask, 0u);
        material.shine = scene::Shine{};
        const MaterialWords words = wordsOf(material);
        EXPECT_EQ(words.cutoffAndShine & shaders::kShineMask, 255u);
        EXPECT_LE(cutoffOf(words), cutoff);
        EXPECT_GE(cutoffOf(words), cutoff * (1.0f - 0x1p-15f));
    }
    EXPECT_EQ(cutoffOf(wordsOf({.name = "half", .alphaCutoff = 0.5f})), 0.5f);
}

TEST(MaterialWords, UnlitDoesNotShine) {
    EXPECT_EQ(wordsOf({.name = "unlit", .shine = scene::Shine{}, .unlit = true}).cutoffAndShine &
                  shaders::kShineMask,
              0u);
}

} // namespace

} // namespace cdr::render
