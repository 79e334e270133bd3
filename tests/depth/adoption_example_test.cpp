#include "../../src/examples/depth_only/draw_anchored.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

using cdr::depth::CascadeConstants;
using cdr::depth::Cascades;

struct Drawn {
    std::size_t object;
    float x, y, ahead;
};
struct Pass {
    CascadeConstants constants;
    std::vector<Drawn> drawn;
};

/// Keeps what it is told to draw.
struct RecordingEngine : adoption::Engine {
    std::vector<Pass> passes{};

    void clearDepth(float) override { passes.emplace_back(); }
    void setCascade(const CascadeConstants& constants) override { passes.back().constants = constants; }
    void draw(const adoption::Object& object, float x, float y, float ahead) override {
        passes.back().drawn.push_back({static_cast<std::size_t>(&object - visible.data()), x, y, ahead});
    }
};

std::vector<std::uint32_t> readSpirv(const char* path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
    std::memcpy(words.data(), bytes.data(), words.size() * sizeof(std::uint32_t));
    return words;
}

/// Byte offsets of the members of the only structure that is in a block of a module. They are from OpDecorate and
/// OpMemberDecorate (SPIR-V 1.6, sections 3.20 and 3.52.3).
std::vector<std::uint32_t> cascadeOffsets(const std::vector<std::uint32_t>& words) {
    std::set<std::uint32_t> blocks;
    std::map<std::uint32_t, std::vector<std::uint32_t>> offsets; // by type, in member order
    for (std::size_t at = 5; at < words.size() && words[at] >> 16 != 0; at += words[at] >> 16) {
        const std::uint32_t operation = words[at] & 0xffffu;
        if (operation == 71 && words[at + 2] == 2) { // OpDecorate, Block
            blocks.insert(words[at + 1]);
        } else if (operation == 72 && words[at + 3] == 35) { // OpMemberDecorate, Offset
            offsets[words[at + 1]].push_back(words[at + 4]);
        }
    }
    std::erase_if(offsets, [&](const auto& type) { return blocks.contains(type.first); });
    return offsets.size() == 1 ? offsets.begin()->second : std::vector<std::uint32_t>{};
}

/// What setCascade() hands over lies where the shaders read it, as their compiler has laid it out.
TEST(AdoptionExample, PushConstantsLieWhereTheShadersReadThem) {
    const std::vector<std::uint32_t> vec4s{offsetof(CascadeConstants, anchorView),
                                           offsetof(CascadeConstants, nearAhead)};
    EXPECT_EQ(cascadeOffsets(readSpirv(CDR_ADOPTION_SHADER)), vec4s);
    EXPECT_EQ(cascadeOffsets(readSpirv(CDR_ADOPTION_SHADER_HLSL)), vec4s);
}

/// cdr_depth.glsl's clip position in float32, as a depth buffer of floats would store it.
float depthOf(const CascadeConstants& cascade, float ahead) {
    return (cascade.scale * ahead + cascade.offset) / (cascade.anchorView + ahead);
}

/// Followed to the letter, it orders two objects a million units away and ten micrometres apart.
TEST(AdoptionExample, OrdersWhatFloat32DistancesCannot) {
    RecordingEngine engine;
    engine.nearView = 0.001;
    engine.farView = 2e6;
    engine.footprintSlope = 5e-8;
    engine.visible = {{{0.0, 0.0, -0.01}, 0.002}};
    engine.projection = {.fovY = 1.0, .aspect = 1.5};
    for (int i = 0; i < 100; ++i) {
        engine.visible.push_back({{0.0, 0.0, -1e6 + 0.1 * i}, 0.5});
        engine.visible.push_back({{0.0, 0.0, -1e6 + 0.1 * i - 1e-5}, 0.5});
    }
    Cascades cascades;
    adoption::drawAnchored(engine, cascades);
    ASSERT_EQ(engine.passes.size(), 2u);
    EXPECT_EQ(engine.passes[1].drawn.size(), 1u); // what is near has a cascade of its own, drawn last
    ASSERT_EQ(engine.passes[0].drawn.size(), 200u);
    const Pass& far = engine.passes[0];
    for (std::size_t i = 0; i < 200; i += 2) {
        EXPECT_LT(depthOf(far.constants, far.drawn[i].ahead), depthOf(far.constants, far.drawn[i + 1].ahead));
        EXPECT_EQ(static_cast<float>(-engine.visible[i + 1].centre.z),
                  static_cast<float>(-engine.visible[i + 2].centre.z));
        EXPECT_GT(far.drawn[i].ahead, far.constants.nearAhead);
        EXPECT_LT(far.drawn[i].ahead, far.constants.farAhead);
    }
}

} // namespace
