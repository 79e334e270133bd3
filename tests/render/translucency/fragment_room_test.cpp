#include "../failing_calls.h"
#include "../fixture.h"
#include "../host/host_side.h"

#include <scenes/sheets.h>

namespace cdr::render_test {

namespace {

using render::Translucency;

class FragmentRoomTest : public RenderTest {
  protected:
    static render::RenderOptions sorted() {
        return withSorting(smallOptions(depth::parseTechnique("reversed"), 192, 108));
    }

    /// So many panes, each of which covers the picture.
    static scene::Scene panes(int count) {
        scene::Scene scene = boxScene();
        scene.meshes.push_back(scenes::makeSquare(1.0f));
        scene.materials.push_back({.name = "glass",
                                   .baseColorFactor = glm::vec4(0.5f),
                                   .doubleSided = true,
                                   .alphaMode = scene::AlphaMode::blend});
        for (int pane = 0; pane < count; ++pane) {
            scene::addInstance(scene, 1, 1, 1, {0.0, 0.0, -10.0 - pane}, glm::mat3(100.0f));
        }
        return scene;
    }

    static scene::Camera behind() { return scene::lookAlong({}, {}, {0.0, 0.0, 1.0}); }
};

/// Frames that nobody waits for cannot be drawn again. Once one had too little room, those after it are drawn weighted.
TEST_F(FragmentRoomTest, FramesThatOverlapAreDrawnWeightedWhereListsMayNotGrow) {
    const scene::Scene scene = panes(3);
    render::RenderOptions options = sorted();
    options.translucency.method = Translucency::weighted;
    const image::ImageRgba8 weighted = draw(scene, {}, options).color;
    options = sorted();
    const image::ImageRgba8 whole = draw(scene, {}, options).color;
    ASSERT_NE(whole, weighted);
    options.translucency.maxBytes = std::uint64_t{192} * 108 * 60; // a node for most pixels
    const render::GpuScene onDevice(device(), scene);
    for (const std::size_t inFlight : {std::size_t{1}, std::size_t{2}}) {
        options.framesInFlight = inFlight;
        HostSide host(device(), {192, 108});
        render::Renderer renderer(device(), scene, onDevice, options);
        for (int frame = 0; frame < 5; ++frame) {
            host.submit(renderer, {}, host.begin());
            const bool isKnown = frame >= static_cast<int>(inFlight);
            EXPECT_EQ(host.color<image::Rgba8>() == weighted, isKnown) << frame << " of " << inFlight;
            const render::TranslucencyStats told = renderer.lastStats().translucency;
            EXPECT_EQ(told.method, isKnown ? Translucency::weighted : Translucency::sorted) << frame;
            EXPECT_EQ(told.refusal.has_value(), isKnown) << frame;
        }
        // One that is waited for can be drawn again, so it is sorted where its fragments fit.
        EXPECT_EQ(renderer.draw(behind()).translucency.method, Translucency::sorted);
        EXPECT_EQ(renderer.draw({}).translucency.method, Translucency::weighted);
    }
}

TEST_F(FragmentRoomTest, RecordedFramesTellOfFragmentsThatFoundNoRoom) {
    const scene::Scene scene = panes(3);
    HostSide host(device(), {192, 108});
    SoleRenderer renderer(device(), scene, sorted());
    host.submit(renderer, {}, host.begin());
    const std::uint64_t bytes = renderer.lastStats().translucency.bytes;
    renderer.finish();
    const render::TranslucencyStats told = renderer.lastStats().translucency;
    EXPECT_EQ(told.method, Translucency::sorted);
    EXPECT_EQ(told.draws, 3u);
    EXPECT_EQ(told.fragments, 3u * 192 * 108);
    EXPECT_GT(told.bytes, bytes); // the next frame finds room
}

/// A counter that went on to 2^32 would begin anew there, and the frame would seem to have found room.
TEST_F(FragmentRoomTest, CountingEndsLongBeforeTheCounterBeginsAnew) {
    const scene::Scene scene = panes(3);
    render::RenderOptions options = sorted();
    options.translucency.method = Translucency::weighted;
    const std::string weighted = hashOf(draw(scene, {}, options));
    options = sorted();
    constexpr std::uint32_t kMost = std::uint32_t{1} << 31u;
    for (const std::uint32_t left : {2u * 192 * 108, 0u}) { // the third pane exceeds it, or each
        const StandIn before = counterFrom(kMost - left);
        const render::Frame frame = draw(scene, {}, options);
        EXPECT_EQ(frame.stats.translucency.method, Translucency::weighted);
        ASSERT_TRUE(frame.stats.translucency.refusal.has_value());
        const render::ListRefusal& refusal = *frame.stats.translucency.refusal;
        EXPECT_EQ(refusal.cause, render::ListRefusal::Cause::bound);
        EXPECT_EQ(refusal.fragments, kMost);
        EXPECT_TRUE(refusal.mayBeMore);
        EXPECT_EQ(hashOf(frame), weighted);
    }
    EXPECT_FALSE(draw(scene, {}, options).stats.translucency.refusal.has_value());
}

/// The larger list takes the place of the smaller one.
TEST_F(FragmentRoomTest, ListsGrowWhereBothWouldNotFit) {
    const scene::Scene scene = panes(2);
    const render::RenderOptions options = sorted();
    const std::string wanted = hashOf(draw(scene, {}, options));
    const StandIn heaps = smallHeaps(std::uint64_t{256} << 20u);
    gpu::BorrowedDevice handles = lentDevice();
    handles.hasGpuDrivenFeatures = true;
    handles.hasFragmentStores = true;
    const gpu::Device small(handles);
    SoleRenderer renderer(small, scene, options);
    renderer.draw(behind());
    const std::uint64_t pixels = std::uint64_t{192} * 108;
    const std::uint64_t listBytes = pixels * 32;
    const std::uint64_t available = gpu::freeDeviceBytes(small);
    ASSERT_GT(available, 2 * listBytes);
    ASSERT_LT(available, std::uint64_t{256} << 20u);
    const gpu::Buffer rest(small, available - listBytes * 3 / 2, vk::BufferUsageFlagBits::eTransferDst,
                           gpu::MemoryUse::deviceOnly, "the rest");
    const render::Frame frame = renderer.render({});
    EXPECT_EQ(frame.stats.translucency.fragments, 2 * pixels);
    EXPECT_EQ(hashOf(frame), wanted);
}

/// More lights than there was room for take new inputs, which go on with the lists.
TEST_F(FragmentRoomTest, ListsThatGrewStayWhereLightsAreAdded) {
    scene::World world(panes(3));
    SoleRenderer renderer(device(), world, sorted());
    const std::uint64_t grown = renderer.draw({}).translucency.bytes;
    for (int i = 0; i < 3; ++i) {
        world.addLight({.position = {-5.0, 10.0, 0.0}});
    }
    renderer.submit({});
    EXPECT_EQ(renderer.lastStats().translucency.bytes, grown);
}

} // namespace

} // namespace cdr::render_test
