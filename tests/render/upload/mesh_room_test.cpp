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
    const FewIndices few(static_cast<std::uint32_t>(box.vertices.size()));
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

} // namespace

} // namespace cdr::render_test
