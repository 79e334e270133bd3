#include "../support/refusal.h"

#include <cdr/base/error.h>
#include <cdr/gpu/commands.h>
#include <cdr/gpu/device.h>
#include <cdr/gpu/memory.h>
#include <cdr/gpu/upload.h>

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <numeric>
#include <string>

namespace {

using namespace cdr::gpu;
using cdr::base::InputError;

TEST(Devices, AtLeastOneIsUsableAndSaysWhatItIs) {
    const Instance instance;
    const auto infos = listDevices(instance);
    ASSERT_FALSE(infos.empty()) << "no Vulkan device: these tests need a driver, mesa-vulkan-drivers has one";
    for (const DeviceInfo& info : infos) {
        EXPECT_FALSE(info.name.empty());
        EXPECT_FALSE(info.depthFormats.empty());
    }
}

TEST(Devices, CanBeChosenByNumberAndName) {
    const Instance instance;
    const Device byNumber(instance, "0");
    const Device byName(instance, byNumber.info().name.substr(0, 5));
    EXPECT_EQ(byNumber.info().index, 0u);
    // The first part of a name may be another device's too.
    EXPECT_EQ(byName.info().name.substr(0, 5), byNumber.info().name.substr(0, 5));
}

TEST(Devices, RefusalNamesEachDeviceAndWhy) {
    const Instance instance;
    const std::string message =
        cdr::test::inputErrorOf([&] { const Device device(instance, "no such device"); });
    EXPECT_NE(message.find("not the one asked for"), std::string::npos);
    EXPECT_NE(message.find(listDevices(instance).front().name), std::string::npos);
    EXPECT_THROW(Device(instance, "999"), InputError);
}

TEST(Devices, AnExtensionThatIsNotThereIsRefusedByName) {
    const std::string message = cdr::test::inputErrorOf(
        [&] { const Instance instance({.validate = false, .extensions = {"VK_KHR_no_such_extension"}}); });
    EXPECT_NE(message.find("VK_KHR_no_such_extension"), std::string::npos);
}

TEST(Memory, AnImageOfTooManyPixelsASideIsRefused) {
    const Instance instance;
    const Device device(instance, "");
    const std::uint32_t most = device.info().maxImageSide;
    const auto imageOf = [&](std::uint32_t width, std::uint32_t height) {
        return Image(device,
                     {.extent = {width, height},
                      .format = vk::Format::eR8G8B8A8Unorm,
                      .usage = vk::ImageUsageFlagBits::eTransferDst},
                     "wide");
    };
    EXPECT_NO_THROW(imageOf(most, 1));
    EXPECT_THROW(imageOf(most + 1, 1), InputError);
    EXPECT_THROW(imageOf(1, most + 1), InputError);
}

TEST(Memory, ABufferOfMoreBytesThanTheDeviceHasInOneIsRefused) {
    const Instance instance;
    const Device device(instance, "");
    const std::uint64_t most = device.info().maxBufferBytes;
    EXPECT_GE(most, std::uint64_t{1} << 30); // by Vulkan
    EXPECT_LE(device.info().maxStorageBufferBytes, most);
    if (most == std::numeric_limits<std::uint64_t>::max()) {
        GTEST_SKIP() << device.info().name << " has buffers of any size";
    }
    EXPECT_EQ(cdr::test::runErrorOf([&] {
                  const Buffer buffer(device, most + 1, vk::BufferUsageFlagBits::eTransferDst,
                                      MemoryUse::deviceOnly, "long");
              }),
              "long: " + std::to_string(most + 1) + " bytes, where " + device.info().name +
                  " has buffers of at most " + std::to_string(most));
}

TEST(Memory, UploadsArriveWhole) {
    const Instance instance({.validate = true, .extensions = {}});
    {
        const Device device(instance, "");
        const std::string text = "every byte of this arrives";
        const Buffer onDevice = uploadBuffer(device, std::as_bytes(std::span(text)),
                                             vk::BufferUsageFlagBits::eTransferSrc, "text");
        const Buffer back(device, text.size(), vk::BufferUsageFlagBits::eTransferDst, MemoryUse::hostReads,
                          "back");
        runOnce(device, [&](vk::CommandBuffer commands) {
            commands.copyBuffer(onDevice.handle(), back.handle(), vk::BufferCopy{.size = text.size()});
        });
        back.invalidate();
        EXPECT_EQ(std::memcmp(back.mapped(), text.data(), text.size()), 0);
    }
    for (const std::string& message : instance.validation().messages()) {
        ADD_FAILURE() << message;
    }
}

/// Pieces of all sizes, over the edges of the staging buffer, and a last one that does not fill it.
TEST(Memory, AFilledBufferHoldsAllItsParts) {
    const Instance instance({.validate = true, .extensions = {}});
    {
        const Device device(instance, "");
        constexpr std::size_t kWords = (2 * BufferFill::kMaxBytes + 4096) / 4;
        std::vector<std::uint32_t> words(kWords);
        std::iota(words.begin(), words.end(), 1u);
        using Usage = vk::BufferUsageFlagBits;
        const Buffer onDevice(device, 4 * kWords + 64, Usage::eTransferDst | Usage::eTransferSrc,
                              MemoryUse::deviceOnly, "filled");
        BufferFill fill(device, onDevice);
        std::size_t piece = 1;
        for (std::size_t first = 0; first < kWords; first += piece) {
            piece = std::min(3 * piece + 1, kWords - first);
            fill.add(std::as_bytes(std::span(words).subspan(first, piece)));
        }
        fill.finish();
        fill.finish(); // nothing is left
        const Buffer back(device, 4 * kWords, Usage::eTransferDst, MemoryUse::hostReads, "back");
        runOnce(device, [&](vk::CommandBuffer commands) {
            commands.copyBuffer(onDevice.handle(), back.handle(), vk::BufferCopy{.size = 4 * kWords});
        });
        back.invalidate();
        EXPECT_EQ(std::memcmp(back.mapped(), words.data(), 4 * kWords), 0);
    }
    for (const std::string& message : instance.validation().messages()) {
        ADD_FAILURE() << message;
    }
}

TEST(Memory, TooLargeIsRefusedBeforeAllocatingWithBothFigures) {
    const Instance instance;
    const Device device(instance, "");
    EXPECT_GT(freeDeviceBytes(device), 0u);
    EXPECT_NO_THROW(requireDeviceBytes(device, 1, "a byte"));
    const std::string message =
        cdr::test::runErrorOf([&] { requireDeviceBytes(device, std::uint64_t{1} << 60, "a planet"); });
    EXPECT_NE(message.find("a planet needs 1099511627776.0 MiB"), std::string::npos);
    EXPECT_NE(message.find("are free on"), std::string::npos);
}

/// An empty log would mean nothing if a broken call left it empty too.
TEST(Validation, TheHookHearsMistakes) {
    const Instance instance({.validate = true, .extensions = {}});
    const Device device(instance, "");
    ASSERT_EQ(instance.validation().count(), 0u);
    // A transfer source that is used as a destination.
    const Buffer a(device, 64, vk::BufferUsageFlagBits::eTransferSrc, MemoryUse::deviceOnly, "a");
    const Buffer b(device, 64, vk::BufferUsageFlagBits::eTransferSrc, MemoryUse::deviceOnly, "b");
    runOnce(device, [&](vk::CommandBuffer commands) {
        commands.copyBuffer(a.handle(), b.handle(), vk::BufferCopy{.size = 64});
    });
    EXPECT_GT(instance.validation().count(), 0u);
}

TEST(Validation, TheHookHearsHazards) {
    const Instance instance({.validate = true, .extensions = {}});
    const Device device(instance, "");
    constexpr auto kBoth = vk::BufferUsageFlagBits::eTransferSrc | vk::BufferUsageFlagBits::eTransferDst;
    const Buffer a(device, 64, kBoth, MemoryUse::deviceOnly, "a");
    const Buffer b(device, 64, kBoth, MemoryUse::deviceOnly, "b");
    runOnce(device, [&](vk::CommandBuffer commands) {
        commands.copyBuffer(a.handle(), b.handle(), vk::BufferCopy{.size = 64});
        commands.copyBuffer(b.handle(), a.handle(), vk::BufferCopy{.size = 64}); // no barrier in between
    });
    const auto messages = instance.validation().messages();
    ASSERT_FALSE(messages.empty());
    EXPECT_NE(messages.front().find("READ_AFTER_WRITE"), std::string::npos) << messages.front();
}

} // namespace
