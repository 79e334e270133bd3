#include "../failing_calls.h"
#include "../fixture.h"

#include <cdr/render/submit/binning_pass.h>
#include <cdr/render/submit/stager.h>
#include <cdr/scene/world/world.h>

#include <optional>
#include <vector>

namespace cdr::render_test {

namespace {

constexpr std::uint64_t kMebibyte = std::uint64_t{1} << 20u;

/// A device of little memory, of which tests leave some.
class DeviceRoomTest : public RenderTest {
  protected:
    void SetUp() override {
        RenderTest::SetUp();
        gpu::BorrowedDevice handles = lentDevice();
        handles.hasGpuDrivenFeatures = device().info().gpuDrivenMissing.empty();
        handles.hasFragmentStores = device().info().hasFragmentStores;
        const StandIn heaps = smallHeaps(256 * kMebibyte);
        m_small.emplace(handles);
    }

    const gpu::Device& small() const { return *m_small; }

    /// Takes all memory but so many bytes. False where the device has its memory in parts.
    bool leaves(std::uint64_t bytes) {
        m_rest.emplace_back(small(), gpu::freeDeviceBytes(small()) - bytes,
                            vk::BufferUsageFlagBits::eTransferDst, gpu::MemoryUse::deviceOnly, "the rest");
        return gpu::freeDeviceBytes(small()) <= bytes;
    }

  private:
    std::optional<gpu::Device> m_small;
    std::vector<gpu::Buffer> m_rest;
};

TEST_F(DeviceRoomTest, WhatGrowsTakesHalfAsMuchAgainWhereThatIsFree) {
    gpu::Records records{.count = 4 * kMebibyte / 64, .bytes = 64};
    const auto room = [&] {
        return gpu::roomToGrow(small(), records, gpu::MemoryUse::deviceOnly, "what grows") * 64;
    };
    EXPECT_EQ(room(), 6 * kMebibyte);
    records.most = records.count + 1;
    EXPECT_EQ(room(), 4 * kMebibyte + 64);
    records.most = 0;
    EXPECT_EQ(room(), 4 * kMebibyte);
    records.most = 2 * records.count;
    if (!leaves(5 * kMebibyte)) {
        GTEST_SKIP() << "the device has its memory in parts";
    }
    EXPECT_EQ(room(), 4 * kMebibyte);
    ASSERT_TRUE(leaves(3 * kMebibyte));
    EXPECT_EQ(test::runErrorOf(room).find("what grows needs 4.0 MiB of device memory"), 0u);
}

TEST_F(DeviceRoomTest, RecordsAndChangesTakeWhatIsFree) {
    if (!leaves(5 * kMebibyte)) {
        GTEST_SKIP() << "the device has its memory in parts";
    }
    {
        gpu::Buffer records;
        gpu::growRecords(small(), records, 4 * kMebibyte / 64, 64, "things");
        EXPECT_EQ(records.size(), 4 * kMebibyte);
    }
    const std::vector<char> changes(4 * kMebibyte);
    render::Stager stager;
    stager.add(0, 0, changes);
    gpu::Buffer staging;
    std::vector<std::vector<vk::BufferCopy>> regions(1);
    stager.write(small(), staging, regions);
    EXPECT_EQ(staging.size(), 4 * kMebibyte);
}

TEST_F(DeviceRoomTest, AGpuDrivenFrameTakesNoMemoryThatItHas) {
    if (!canDrawGpuDriven()) {
        GTEST_SKIP() << "the device does not draw gpu-driven";
    }
    scene::Scene scene = boxScene();
    addBox(scene, {0.0, 0.0, -5.0});
    render::RenderOptions options = thumbnailOptions(depth::parseTechnique("reversed"));
    options.submission = render::Submission::gpuDriven;
    SoleRenderer renderer(small(), scene, options);
    const std::string wanted = hashOf(renderer.render({}));
    if (!leaves(0)) {
        GTEST_SKIP() << "the device has its memory in parts";
    }
    EXPECT_EQ(hashOf(renderer.render({})), wanted);
}

TEST_F(DeviceRoomTest, AGpuDrivenSceneThatGrewTakesWhatIsFree) {
    if (!canDrawGpuDriven()) {
        GTEST_SKIP() << "the device does not draw gpu-driven";
    }
    constexpr std::size_t kBefore = 20'000;
    constexpr std::size_t kNow = 26'000; // their changes have room in the buffer of the first ones
    scene::Scene scene = boxScene();
    for (std::size_t i = 0; i < kBefore; ++i) {
        addBox(scene, {0.0, 0.0, -5.0});
    }
    scene::World world(scene);
    render::GpuScene onDevice(small(), world);
    render::BinningPass binning(small(), {.scene = world.scene(), .uploaded = onDevice.uploaded()},
                                visibility::DetailMode::none, {});
    render::BinningPass::Copies copies = binning.makeCopies();
    binning.follow(copies);
    binning.noteLaunched();
    for (std::size_t i = kBefore; i < kNow; ++i) {
        world.addInstance({.mesh = world.mesh(0), .material = world.material(0), .object = 1});
    }
    onDevice.update();
    constexpr std::uint64_t kNeeded =
        kNow * (sizeof(shaders::InstanceSphere) + sizeof(shaders::InstanceLook));
    if (!leaves(kNeeded * 5 / 4)) {
        GTEST_SKIP() << "the device has its memory in parts";
    }
    EXPECT_TRUE(binning.follow(copies));
    EXPECT_EQ((*copies.buffers)[0].size(), kNow * sizeof(shaders::InstanceSphere));
    EXPECT_EQ((*copies.buffers)[1].size(), kNow * sizeof(shaders::InstanceLook));
}

/// Two frames in flight find room for their lists, and the third does not.
TEST_F(DeviceRoomTest, FramesWhoseListsFindNoMemoryAreDrawnWeighted) {
    using render::Translucency;
    if (!small().info().hasFragmentStores) {
        GTEST_SKIP() << "the device sorts no fragments";
    }
    scene::Scene scene = boxScene();
    scene.materials.push_back(
        {.name = "glass", .baseColorFactor = glm::vec4(0.5f), .alphaMode = scene::AlphaMode::blend});
    scene::addInstance(scene, 0, 1, 1, {0.0, 0.0, -5.0}, glm::mat3(1.0f));
    render::RenderOptions options = withSorting(smallOptions(depth::parseTechnique("reversed")));
    constexpr std::uint64_t kPixels = std::uint64_t{480} * 270;
    constexpr std::uint64_t kHeads = kPixels * 4;
    constexpr std::uint64_t kNodes = kPixels * 32;
    std::uint64_t taken = 0;
    for (int i = 0; i < 2; ++i) { // the first leaves memory that others share
        const std::uint64_t before = gpu::freeDeviceBytes(small());
        SoleRenderer one(small(), scene, options);
        one.draw({});
        taken = before - gpu::freeDeviceBytes(small());
    }
    if (!leaves(taken + 2 * kHeads + kNodes * 3 / 2)) {
        GTEST_SKIP() << "the device has its memory in parts";
    }
    options.framesInFlight = 3;
    SoleRenderer renderer(small(), scene, options);
    EXPECT_EQ(renderer.draw({}).translucency.method, Translucency::sorted);
    EXPECT_EQ(renderer.draw({}).translucency.method, Translucency::sorted);
    const render::TranslucencyStats third = renderer.draw({}).translucency;
    EXPECT_EQ(third.method, Translucency::weighted);
    ASSERT_TRUE(third.refusal.has_value());
    EXPECT_EQ(third.refusal->cause, render::ListRefusal::Cause::memory);
    EXPECT_EQ(third.refusal->fragments, 0u);
    EXPECT_EQ(renderer.draw({}).translucency.method, Translucency::sorted);
}

} // namespace

} // namespace cdr::render_test
