#include "../failing_calls.h"
#include "../fixture.h"

#include <cdr/scene/world/world.h>

#include <fmt/format.h>

namespace cdr::render_test {

namespace {

class MeshRoomTest : public RenderTest {};

TEST_F(MeshRoomTest, AMeshOfMoreVerticesThanDrawsCanNameIsRefused) {
    const scene::Mesh box = scene::makeBox(glm::vec3(1.0f));
    scene::Mesh larger = box;
    larger.boxHalfSides.reset();
    larger.vertices.push_back(larger.vertices.front());
    const StandIn few = fewIndices(static_cast<std::uint32_t>(box.vertices.size()));
    const gpu::Device small(lentDevice());
    scene::World world(boxScene());
    render::GpuScene onDevice(small, world);
    world.addMesh(box);
    onDevice.update();
    const scene::MeshHandle refused = world.addMesh(larger);
    const std::string why =
        fmt::format("mesh {} of scene boxes has {} vertices, {} draws at most {} of a mesh", refused.index,
                    larger.vertices.size(), small.info().name, box.vertices.size());
    EXPECT_EQ(test::inputErrorOf([&] { onDevice.update(); }), why);
    EXPECT_EQ(test::inputErrorOf([&] { const render::GpuScene anew(small, world); }), why);
    world.removeMesh(refused);
    EXPECT_NO_THROW(onDevice.update());
}

/// Buffers get twice the room that is needed, but they end at the device's largest one, which meshes may fill.
TEST_F(MeshRoomTest, MeshesGrowUpToTheLargestBufferOfTheDevice) {
    constexpr std::uint64_t kBytes = 128 * 1024;
    const scene::Mesh box = scene::makeBox(glm::vec3(1.0f));
    const std::uint64_t most =
        kBytes / 28; // a vertex has 28 bytes, and boxes have more bytes of these than of indices
    const StandIn buffers = smallBuffers(kBytes);
    const gpu::Device small(lentDevice());
    ASSERT_EQ(small.info().maxBufferBytes, kBytes);
    scene::World world(boxScene());
    render::GpuScene onDevice(small, world);
    std::uint64_t meshes = 1;
    for (; (meshes + 1) * box.vertices.size() <= most; ++meshes) {
        world.addMesh(box);
        ASSERT_NO_THROW(onDevice.update()) << meshes + 1 << " meshes";
    }
    const scene::MeshHandle refused = world.addMesh(box);
    ++meshes;
    EXPECT_EQ(
        test::runErrorOf([&] { onDevice.update(); }),
        fmt::format("the meshes of scene boxes have {} vertices and {} indices, {} has buffers for {} and {}",
                    meshes * box.vertices.size(), meshes * box.indices.size(), small.info().name, most,
                    kBytes / 4));
    world.removeMesh(refused);
    EXPECT_NO_THROW(onDevice.update());
}

TEST_F(MeshRoomTest, ABufferIsNoLargerThanWhatTheDeviceAllocatesAtOnce) {
    constexpr std::uint64_t kBytes = 128 * 1024;
    const StandIn allocations = smallAllocations(kBytes);
    const gpu::Device small(lentDevice());
    EXPECT_EQ(small.info().maxBufferBytes, kBytes);
}

} // namespace

} // namespace cdr::render_test
