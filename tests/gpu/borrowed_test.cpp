#include "../support/refusal.h"
#include "host_loader.h"

#include <cdr/gpu/commands.h>
#include <cdr/gpu/device.h>
#include <cdr/gpu/features.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace cdr::gpu;

/// What an owner says that its device was created with.
struct NamedFeatures {
    VkPhysicalDeviceVulkan13Features v13 = vk::PhysicalDeviceVulkan13Features{};
    VkPhysicalDeviceVulkan12Features v12 = vk::PhysicalDeviceVulkan12Features{.pNext = &v13};
    VkPhysicalDeviceFeatures2 features = vk::PhysicalDeviceFeatures2{.pNext = &v12};

    NamedFeatures() = default;
    NamedFeatures(const NamedFeatures&) = delete;
    NamedFeatures& operator=(const NamedFeatures&) = delete;
};

class BorrowedDevices : public testing::Test {
  protected:
    void TearDown() override { cdr::test::withheldFeatures().clear(); }

    /// Without the structs that the device was created with.
    BorrowedDevice lent() const {
        return {.instance = m_instance.handle(),
                .physical = m_device.physical(),
                .device = m_device.handle(),
                .queue = m_device.queue(),
                .queueFamily = m_device.queueFamily()};
    }
    /// With those features, and all of them enabled that cdr uses.
    BorrowedDevice lentWith(VkPhysicalDeviceFeatures2& features) const {
        BorrowedDevice borrowed = lent();
        borrowed.features = &features;
        enableFeatures(borrowed.instance, borrowed.physical, features);
        return borrowed;
    }
    /// Why it is refused; empty where it is not.
    static std::string refusalOf(const BorrowedDevice& borrowed) {
        return cdr::test::inputErrorOf([&] { const Device device(borrowed); });
    }
    const std::string& name() const { return m_device.info().name; }
    bool hasFloat64() const { return m_device.info().hasFloat64; }
    bool hasCondition() const { return m_device.info().hasConditionalRendering; }
    std::uint32_t maxIndex() const { return m_device.info().maxIndex; }
    bool canDeform() const { return m_device.info().deformMissing.empty(); }

  private:
    Instance m_instance;
    Device m_device{m_instance, ""};
};

/// The host names no features, but the physical device is asked.
TEST_F(BorrowedDevices, WhatThePhysicalDeviceLacksIsRefusedByItsName) {
    EXPECT_EQ(refusalOf(lent()), "");
    for (const char* feature : {"dynamicRendering", "synchronization2", "depthClamp", "shaderClipDistance"}) {
        cdr::test::withheldFeatures() = {feature};
        EXPECT_EQ(refusalOf(lent()), "the borrowed device " + name() + " lacks " + feature);
    }
    cdr::test::withheldFeatures() = {"shaderClipDistance", "synchronization2"};
    EXPECT_EQ(refusalOf(lent()),
              "the borrowed device " + name() + " lacks synchronization2, shaderClipDistance");
    cdr::test::withheldFeatures() = {};
    EXPECT_EQ(refusalOf(lent()), "");
}

/// Vulkan does not say what a device was created with, so what its owner does not name counts as off.
TEST_F(BorrowedDevices, HaveTheNumbersOfShadersThatTheirOwnerNames) {
    BorrowedDevice borrowed = lent();
    EXPECT_FALSE(Device(borrowed).info().hasFloat64);
    EXPECT_FALSE(Device(borrowed).info().deformMissing.empty());
    EXPECT_FALSE(Device(borrowed).info().hasInt64Atomics);
    borrowed.hasGpuDrivenFeatures = true;
    EXPECT_EQ(Device(borrowed).info().hasFloat64, hasFloat64());
    EXPECT_EQ(Device(borrowed).info().deformMissing.empty(), canDeform());
    EXPECT_FALSE(Device(borrowed).info().hasInt64Atomics);
}

TEST_F(BorrowedDevices, RenderConditionallyWhereTheirOwnerNamesTheFeature) {
    EXPECT_FALSE(Device(lent()).info().hasConditionalRendering);
    VkPhysicalDeviceConditionalRenderingFeaturesEXT conditional =
        vk::PhysicalDeviceConditionalRenderingFeaturesEXT{};
    NamedFeatures named;
    named.v13.pNext = &conditional;
    const BorrowedDevice borrowed = lentWith(named.features);
    EXPECT_EQ(hasConditionalRendering(named.features), hasCondition());
    EXPECT_EQ(Device(borrowed).info().hasConditionalRendering, hasCondition());
    conditional.conditionalRendering = VK_FALSE;
    EXPECT_FALSE(Device(borrowed).info().hasConditionalRendering);
    named.v13.pNext = nullptr; // an owner that does not know the extension
    EXPECT_FALSE(hasConditionalRendering(named.features));
    EXPECT_FALSE(Device(borrowed).info().hasConditionalRendering);
}

TEST_F(BorrowedDevices, DrawMeshesOfAnySizeWhereTheirOwnerNamesTheFeature) {
    constexpr std::uint32_t kSure = 0xffffff; // by Vulkan without the feature
    EXPECT_GE(maxIndex(), kSure);
    EXPECT_EQ(Device(lent()).info().maxIndex, kSure);
    NamedFeatures named;
    const BorrowedDevice borrowed = lentWith(named.features);
    EXPECT_EQ(Device(borrowed).info().maxIndex,
              named.features.features.fullDrawIndexUint32 ? maxIndex() : kSure);
    named.features.features.fullDrawIndexUint32 = VK_FALSE;
    EXPECT_EQ(Device(borrowed).info().maxIndex, kSure);
}

TEST_F(BorrowedDevices, UseThePipelineCacheOfTheirOwnerAndLeaveIt) {
    BorrowedDevice borrowed = lent();
    const vk::Device owner(borrowed.device);
    const vk::UniquePipelineCache cache = owner.createPipelineCacheUnique({}); // frees it once
    EXPECT_NE(Device(borrowed).pipelineCache(), VkPipelineCache(*cache));
    borrowed.pipelineCache = *cache;
    EXPECT_EQ(Device(borrowed).pipelineCache(), VkPipelineCache(*cache));
}

TEST_F(BorrowedDevices, AQueueFamilyThatIsNotThereIsRefused) {
    BorrowedDevice spoilt = lent();
    spoilt.queueFamily = 1000;
    EXPECT_EQ(refusalOf(spoilt),
              "the borrowed device " + name() + " has no queue family 1000 that does graphics and compute");
}

/// vkQueueWaitIdle() needs the lock that the host's submit() takes, and cdr does not have it.
TEST_F(BorrowedDevices, AWaitThatFailsDoesNotTouchASharedQueue) {
    for (const bool isShared : {false, true}) {
        BorrowedDevice borrowed = lent();
        int submissions = 0;
        if (isShared) {
            borrowed.submit = [&](const VkSubmitInfo2& submission, VkFence done) {
                ++submissions;
                return functions().vkQueueSubmit2(borrowed.queue, 1, &submission, done);
            };
        }
        const Device device(borrowed);
        EXPECT_EQ(device.isQueueShared(), isShared);
        cdr::test::waits() = {.fencesToFail = 1};
        EXPECT_THROW(waitForQueue(device), vk::OutOfHostMemoryError);
        EXPECT_EQ(cdr::test::waits().idle, isShared ? 0 : 1);
        EXPECT_EQ(submissions, isShared ? 2 : 0) << "the second is waited for in its place";
    }
}

/// An instance of an engine's own, for a version of Vulkan that it names, and a device with the features that cdr needs.
struct EnginesDevice {
    vk::UniqueInstance instance;
    vk::UniqueDevice device;
    BorrowedDevice lent;
};

EnginesDevice madeFor(std::uint32_t version) {
    EnginesDevice made;
    const vk::ApplicationInfo application{.apiVersion = version};
    made.instance = vk::createInstanceUnique({.pApplicationInfo = &application});
    const vk::PhysicalDevice physical = made.instance->enumeratePhysicalDevices().front();
    constexpr float kPriority = 1.0f;
    const vk::DeviceQueueCreateInfo queue{.queueCount = 1, .pQueuePriorities = &kPriority};
    vk::PhysicalDeviceVulkan13Features v13{.synchronization2 = true, .dynamicRendering = true};
    vk::PhysicalDeviceVulkan12Features v12{.pNext = &v13, .timelineSemaphore = true};
    const vk::PhysicalDeviceFeatures2 features{.pNext = &v12,
                                               .features = {.depthClamp = true, .shaderClipDistance = true}};
    made.device = physical.createDeviceUnique(
        {.pNext = &features, .queueCreateInfoCount = 1, .pQueueCreateInfos = &queue});
    made.lent = {.instance = *made.instance,
                 .physical = physical,
                 .device = *made.device,
                 .queue = made.device->getQueue(0, 0)};
    return made;
}

/// Its device may lack the functions of later versions, though the loader gives them for the instance. Some drivers have them.
TEST_F(BorrowedDevices, AnInstanceOfAnEarlierVersionIsRefused) {
    EXPECT_EQ(refusalOf(madeFor(VK_API_VERSION_1_3).lent), "");
    for (const std::uint32_t version : {VK_API_VERSION_1_1, VK_API_VERSION_1_2}) {
        const EnginesDevice made = madeFor(version);
        const bool hasThem = made.device->getProcAddr("vkCmdBeginRendering") != nullptr;
        EXPECT_EQ(refusalOf(made.lent),
                  hasThem
                      ? ""
                      : "the device gives no vkCmdBeginRendering; its instance must be made for Vulkan 1.3");
    }
    const std::string ofTheFirst = refusalOf(madeFor(VK_API_VERSION_1_0).lent);
    EXPECT_TRUE(ofTheFirst.empty() ||
                ofTheFirst == "the borrowed device " + name() +
                                  " lacks Vulkan 1.3, for which the instance must be made")
        << ofTheFirst;
}

} // namespace
