#include "fixture.h"

namespace cdr::scene::test {
namespace {

using GltfComponent = GltfFolder;

/// Texture coordinates of every component type there is, as glTF 2.0 (3.6.2.2) and KHR_mesh_quantization have
/// them.
TEST_F(GltfComponent, EveryComponentTypePlainAndNormalized) {
    Document document = square();
    const auto uvOfVertex1 = [&](int accessor, bool normalized) {
        document.root["accessors"].back()["normalized"] = normalized;
        document.primitive()["attributes"]["TEXCOORD_0"] = accessor;
        return load(document).scene.meshes[0].vertices[1].uv;
    };
    const auto expectBoth = [&](const auto& values, int type, const glm::vec2& plain,
                                const glm::vec2& scaled) {
        EXPECT_EQ(uvOfVertex1(document.addAccessor(values, "VEC2", type), false), plain) << type;
        EXPECT_EQ(uvOfVertex1(document.addAccessor(values, "VEC2", type), true), scaled) << type;
    };
    expectBoth(std::vector<std::int8_t>{0, 0, 127, -128, 0, 0, 0, 0}, kByte, {127, -128}, {1, -1});
    expectBoth(std::vector<std::uint8_t>{0, 0, 255, 51, 0, 0, 0, 0}, kUByte, {255, 51}, {1, 0.2f});
    expectBoth(std::vector<std::int16_t>{0, 0, 32767, -32768, 0, 0, 0, 0}, kShort, {32767, -32768}, {1, -1});
    expectBoth(std::vector<std::uint16_t>{0, 0, 65535, 13107, 0, 0, 0, 0}, kUShort, {65535, 13107},
               {1, 0.2f});
    expectBoth(std::vector<std::uint32_t>{0, 0, 4294967295u, 0, 0, 0, 0, 0}, kUInt, {4294967296.0f, 0},
               {1, 0});
    EXPECT_EQ(
        uvOfVertex1(document.addAccessor(std::vector<float>{0, 0, 0.25f, -7, 0, 0, 0, 0}, "VEC2", kFloat),
                    false),
        glm::vec2(0.25f, -7));
}

TEST_F(GltfComponent, QuantizedNormals) {
    Document document = square();
    document.root["extensionsRequired"] = {"KHR_mesh_quantization"};
    const auto normal = [&](int accessor) {
        document.root["accessors"].back()["normalized"] = true;
        document.primitive()["attributes"]["NORMAL"] = accessor;
        return load(document).scene.meshes[0].vertices[1].normal;
    };
    EXPECT_EQ(normal(document.addAccessor(
                  std::vector<std::int8_t>{0, 0, 127, 0, -127, 0, 0, 0, 127, 0, 0, 127}, "VEC3", kByte)),
              glm::vec3(0, -1, 0));
    EXPECT_EQ(
        normal(document.addAccessor(
            std::vector<std::int16_t>{0, 0, 32767, -32767, 0, 0, 0, 0, 32767, 0, 0, 32767}, "VEC3", kShort)),
        glm::vec3(-1, 0, 0));
}

} // namespace
} // namespace cdr::scene::test
