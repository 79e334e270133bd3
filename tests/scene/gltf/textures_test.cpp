#include "../../support/refusal.h"
#include "fixture.h"

#include <cdr/image/codec.h>
#include <cdr/image/levels.h>
#include <cdr/scene/gltf/import.h>

#include <random>

namespace cdr::scene::test {
namespace {

/// Squares, each with a picture of its own.
class GltfTextures : public GltfFolder {
  protected:
    static image::ImageRgba8 picture(std::uint32_t width, std::uint32_t height) {
        image::ImageRgba8 made(width, height);
        for (std::size_t i = 0; i < made.pixels.size(); ++i) {
            const auto noise = static_cast<std::uint32_t>(i * 2654435761u + width);
            made.pixels[i] = {static_cast<std::uint8_t>(noise >> 24), static_cast<std::uint8_t>(noise >> 16),
                              static_cast<std::uint8_t>(noise >> 8), 255};
        }
        return made;
    }

    /// @param pictures encoded.
    static Document with(const std::vector<Bytes>& pictures) {
        Document document = square();
        const json primitive = document.primitive();
        json& primitives = document.root["meshes"][0]["primitives"];
        primitives.clear();
        const int uv = document.addAccessor(std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}, "VEC2", kFloat);
        for (std::size_t i = 0; i < pictures.size(); ++i) {
            document.root["images"].push_back({{"bufferView", document.addView(pictures[i])}});
            document.root["textures"].push_back({{"source", i}});
            document.root["materials"].push_back(
                {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", i}}}}}});
            primitives.push_back(primitive);
            primitives.back()["attributes"]["TEXCOORD_0"] = uv;
            primitives.back()["material"] = i;
        }
        return document;
    }

    GltfImport import(const Document& document, const GltfLimits& limits) const {
        return gltf::importGltf(gltf::ByteSource(document.glb()), folder() / "a.glb", limits);
    }

    std::string refusalOf(const Document& document, const GltfLimits& limits) const {
        return cdr::test::inputErrorOf([&] { import(document, limits); }, "imported");
    }
};

/// Else a small file keeps the importer reading for hours.
TEST_F(GltfTextures, ManyPicturesInOneBufferViewAreRefused) {
    std::mt19937 random(1);
    image::ImageRgba8 noise(64, 64);
    for (image::Rgba8& pixel : noise.pixels) {
        const auto bits = static_cast<std::uint32_t>(random());
        pixel = {static_cast<std::uint8_t>(bits >> 24), static_cast<std::uint8_t>(bits >> 16),
                 static_cast<std::uint8_t>(bits >> 8), 255};
    }
    for (const std::size_t count : {4u, 40u}) {
        std::vector<Bytes> pictures(count, image::encodePng(picture(1, 1)));
        pictures[0] = image::encodePng(noise);
        Document document = with(pictures);
        for (json& sharing : document.root["images"]) {
            sharing["bufferView"] = document.root["images"][0]["bufferView"];
        }
        GltfLimits limits;
        limits.maxFileBytes = document.glb().size();
        const std::string said = refusalOf(document, limits);
        const char* expected =
            count == 4 ? "imported" : ": with it, pictures in buffer views are over the limit of bytes";
        EXPECT_NE(said.find(expected), std::string::npos) << said;
        EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }
}

TEST_F(GltfTextures, AreTheSameForAnyNumberOfThreads) {
    std::vector<Bytes> pictures;
    for (std::uint32_t i = 1; i <= 12; ++i) {
        pictures.push_back(image::encodePng(picture(i, 40 - 3 * i)));
    }
    const Document document = with(pictures);
    for (const std::size_t threads : {1u, 4u, 0u}) {
        const Scene scene = import(document, {.threads = threads}).scene;
        ASSERT_EQ(scene.textures.size(), pictures.size());
        for (std::uint32_t i = 1; i <= 12; ++i) {
            EXPECT_EQ(scene.textures[i - 1].pixels, picture(i, 40 - 3 * i)) << threads;
        }
    }
}

TEST_F(GltfTextures, TheFirstDamagedOneIsNamedForAnyNumberOfThreads) {
    const Bytes good = image::encodePng(picture(64, 64));
    Bytes cut = good;
    cut.resize(cut.size() / 2); // its header is whole
    const Document document = with({good, good, cut, good, cut, cut, good, cut});
    for (const std::size_t threads : {1u, 2u, 8u}) {
        for (int repeat = 0; repeat < 10; ++repeat) {
            expectSays(refusalOf(document, {.threads = threads}), "image 2: damaged PNG");
        }
    }
}

/// Else a small file whose levels are left out keeps the importer decoding for hours.
TEST_F(GltfTextures, MoreTexelsThanCanBeDecodedInMinutesAreRefused) {
    std::vector<Bytes> pictures(1'025);
    const Bytes large = image::encodePng(image::ImageRgba8(8'192, 8'192));
    std::fill(pictures.begin(), pictures.end(), Bytes(image::encodePng(picture(1, 1))));
    pictures[0] = large;
    Document document = with(pictures);
    for (json& sharing : document.root["images"]) {
        sharing["bufferView"] = document.root["images"][0]["bufferView"];
    }
    expectSays(refusalOf(document, {.textureMemory = 1u << 20u}),
               "its pictures have 68786 million texels, over the limit of 68719");
}

TEST_F(GltfTextures, OnePictureReadInTwoWaysIsDecodedForBoth) {
    Document document = with({image::encodePng(picture(4, 4))});
    document.root["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", 0}};
    const Scene scene = import(document, {}).scene;
    ASSERT_EQ(scene.textures.size(), 2u);
    EXPECT_EQ(scene.textures[0].pixels, picture(4, 4));
    EXPECT_EQ(scene.textures[1].pixels, picture(4, 4));
}

TEST_F(GltfTextures, ABudgetTakesLevelsFromThoseThatTakeMost) {
    const std::vector<Bytes> pictures{image::encodePng(picture(1024, 512)), image::encodePng(picture(64, 64)),
                                      image::encodePng(picture(512, 512))};
    const Document document = with(pictures);
    EXPECT_TRUE(import(document, {.textureMemory = 5u << 20u}).ignored.empty()); // they take 4.1 MiB
    const GltfImport shrunk = import(document, {.textureMemory = 1u << 20u});
    const std::vector<Texture>& textures = shrunk.scene.textures;
    ASSERT_EQ(textures.size(), 3u);
    EXPECT_EQ(textures[0].pixels.width, 256u);
    EXPECT_EQ(textures[0].pixels.height, 128u);
    EXPECT_EQ(textures[1].pixels, picture(64, 64));
    EXPECT_EQ(textures[2].pixels.width, 256u);
    EXPECT_EQ(textures[0].pixels, image::smallerLevels(picture(1024, 512), image::Encoding::srgb, 2).back());
    EXPECT_TRUE(anySays(shrunk.ignored, "image 0 and 1 more: shown smaller than it is, so that all textures "
                                        "fit in 1 MiB"));
    std::uint64_t pixels = 0;
    for (const Texture& texture : textures) {
        pixels += image::levelPixels(texture.pixels.width, texture.pixels.height, 99);
    }
    EXPECT_LE(pixels * 4, 1u << 20u);
}

TEST_F(GltfTextures, ABudgetCountsLevelsOnlyWhereThereAreAny) {
    Document document = with({image::encodePng(picture(512, 512))});
    EXPECT_EQ(import(document, {.textureMemory = 1u << 20u}).scene.textures[0].pixels.width, 256u);
    document.root["samplers"] = {{{"minFilter", 9729}}};
    document.root["textures"][0]["sampler"] = 0;
    EXPECT_EQ(import(document, {.textureMemory = 1u << 20u}).scene.textures[0].pixels.width, 512u);
}

TEST_F(GltfTextures, DataShrinksAsDataAndColourAsLight) {
    image::ImageRgba8 stripes(2, 1, {0, 0, 0, 255});
    stripes.at(1, 0) = {255, 255, 255, 255};
    Document document = with({image::encodePng(stripes)});
    document.root["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", 0}};
    const std::vector<Texture> textures = import(document, {.textureMemory = 8}).scene.textures;
    ASSERT_EQ(textures.size(), 2u);
    EXPECT_EQ(textures[0].pixels.at(0, 0)[0], 188);
    EXPECT_EQ(textures[1].pixels.at(0, 0)[0], 128);
}

/// Sizes are read before pixels, so what is over the limit is refused while it takes no memory.
TEST_F(GltfTextures, WhatIsOverTheLimitIsRefusedBeforeItIsDecoded) {
    const Bytes good = image::encodePng(picture(64, 64));
    Bytes damaged = good;
    damaged.resize(damaged.size() / 2); // is refused when it is decoded
    const Document document = with({damaged, good, good});
    // Three textures of one pixel each are the least.
    expectSays(refusalOf(document, {.textureMemory = 11}), "its textures take 0 MiB, over the limit of 0");
    expectSays(refusalOf(document, {.textureMemory = 12}), "image 0: damaged PNG");
}

} // namespace
} // namespace cdr::scene::test
