#include "../fixture.h"

#include <cdr/gpu/memory.h>
#include <cdr/scene/world/world.h>

#include <utility>

namespace cdr::render_test {

namespace {

class RepeatedUpdateTest : public RenderTest {};

/// Each attempt uploads the texture before the one that is refused, in the place of the attempt before.
TEST_F(RepeatedUpdateTest, DoesNotKeepWhatEachAttemptUploaded) {
    constexpr std::uint32_t kSide = 1024;
    constexpr std::uint64_t kBytes = std::uint64_t{4} * kSide * kSide;
    scene::World world(boxScene());
    const auto add = [&](std::uint32_t width, std::uint32_t height) {
        const image::ImageRgba8 pixels(width, height, {255, 255, 255, 255});
        const scene::TextureHandle texture =
            world.addTexture({.name = {}, .pixels = pixels, .levels = scene::TextureLevels::none});
        return std::pair(texture, world.addMaterial({.baseColorTexture = texture.index}));
    };
    render::GpuScene onDevice(device(), world);
    add(kSide, kSide);
    const auto refused = add(device().info().maxImageSide + 1, 1);
    const std::uint64_t before = gpu::allocatedDeviceBytes(device());
    for (int attempt = 0; attempt < 20; ++attempt) {
        EXPECT_THROW(onDevice.update(), base::InputError);
    }
    EXPECT_LE(gpu::allocatedDeviceBytes(device()), before + 4 * kBytes); // the last one, and what is going
    world.removeMaterial(refused.second);
    world.removeTexture(refused.first);
    EXPECT_NO_THROW(onDevice.update());
}

} // namespace

} // namespace cdr::render_test
