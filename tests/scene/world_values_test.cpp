#include <cdr/base/error.h>
#include <cdr/scene/world/world.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace cdr::scene {

namespace {

/// Why a new world does not take it; "taken" where it does.
template <typename Add>
std::string refusalToAdd(const Add& add) {
    World world;
    try {
        add(world);
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "taken";
}

TEST(WorldValues, ACutoffIsAnAlphaAboveZero) {
    Texture texture{.name = "leaf", .pixels = image::ImageRgba8(1, 1, {1, 2, 3, 255})};
    const auto refusalOf = [&](float cutoff) {
        texture.cutoff = cutoff;
        return refusalToAdd([&](World& world) { world.addTexture(texture); });
    };
    EXPECT_EQ(refusalOf(1.0f), "taken");
    EXPECT_EQ(refusalOf(0.0f), "the new texture: its cutoff must lie in (0, 1], not 0");
    for (const float cutoff : {-0.5f, 1.5f, NAN}) {
        EXPECT_NE(refusalOf(cutoff), "taken") << cutoff;
    }
}

TEST(WorldValues, HalfSidesOfABoxAreFiniteAndNotNegative) {
    Mesh mesh = makeBox({1.0f, 0.0f, 1.0f});
    EXPECT_EQ(refusalToAdd([&](World& world) { world.addMesh(mesh); }), "taken");
    for (const float half : {-1.0f, NAN, INFINITY}) {
        mesh.boxHalfSides->y = half;
        EXPECT_EQ(refusalToAdd([&](World& world) { world.addMesh(mesh); }),
                  "the new mesh: the half sides of its box must be finite and 0 or more");
    }
}

} // namespace

} // namespace cdr::scene
