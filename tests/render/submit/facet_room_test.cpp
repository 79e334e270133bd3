#include "../failing_calls.h"
#include "../fixture.h"

#include <array>

namespace cdr::render_test {

namespace {

using render::SurfacePath;

/// Those whose triangles the CPU writes.
constexpr std::array kFacetSurfaces{SurfacePath::visibility, SurfacePath::lit};

class FacetRoomTest : public RenderTest {
  protected:
    static render::RenderOptions facetOptions(SurfacePath surface) {
        render::RenderOptions options = thumbnailOptions(depth::parseTechnique("reversed"));
        options.surface = surface;
        return options;
    }
};

/// Each box has 8 vertices, so a draw shows 3 of them.
TEST_F(FacetRoomTest, DrawsNameNoVertexThatTheDeviceCannotName) {
    scene::Scene scene = boxScene();
    for (int column = -3; column <= 3; ++column) {
        addBox(scene, {1.5 * column, 0.0, -10.0});
    }
    const StandIn few = fewIndices(24);
    const gpu::Device small(lentDevice());
    for (const SurfacePath surface : kFacetSurfaces) {
        const render::RenderOptions options = facetOptions(surface);
        SoleRenderer renderer(small, scene, options);
        const std::size_t before = indexedDraws();
        EXPECT_EQ(renderer.draw({}).draws, 7u);
        EXPECT_EQ(indexedDraws() - before, 3u) << nameOf(surface);
        EXPECT_EQ(hashOf(renderer.render({})), hashOf(draw(scene, {}, options))) << nameOf(surface);
    }
}

/// Half as many again would not fit: a box has 192 bytes of what takes most.
TEST_F(FacetRoomTest, FacetsGrowUpToTheLargestBufferOfTheDevice) {
    constexpr std::uint64_t kBytes = 512 * 1024;
    scene::Scene scene = boxScene();
    for (int i = 0; i < 2'500; ++i) {
        addBox(scene, {0.0, 0.0, -5.0});
    }
    const StandIn buffers = smallBuffers(kBytes);
    const gpu::Device small(lentDevice());
    for (const SurfacePath surface : kFacetSurfaces) {
        SoleRenderer renderer(small, scene, facetOptions(surface));
        EXPECT_EQ(test::runErrorOf([&] { renderer.draw({}); }), "") << nameOf(surface);
    }
}

} // namespace

} // namespace cdr::render_test
