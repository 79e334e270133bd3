#include "fixture.h"

#include <cdr/image/codec.h>
#include <cdr/image/levels.h>
#include <cdr/scene/gltf/import.h>

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
        return gltf::importGltf(document.glb(), folder() / "a.glb", limits);
    }

    std::string refusalOf(const Document& document, const GltfLimits& limits) const {
        try {
            import(document, limits);
        } catch (const base::InputError& error) {
            return error.what();
        }
        return "imported";
    }
};

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

TEST_F(GltfTextures, OnePictureReadInTwoWaysIsDecodedForBoth) {
    Document document = with({image::encodePng(picture(4, 4))});
    document.root["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", 0}};
    const Scene scene = import(document, {}).scene;
    ASSERT_EQ(scene.textures.size(), 2u);
    EXPECT_EQ(scene.textures[0].pixels, picture(4, 4));
    EXPECT_EQ(scene.textures[1].pixels, picture(4, 4));
}

} // namespace
} // namespace cdr::scene::test
