#include <cdr/base/error.h>
#include <viewer/state/surface_choice.h>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace cdr::viewer {

namespace {

using vk::ColorSpaceKHR;
using vk::Format;

vk::Format formatAmong(const std::vector<vk::SurfaceFormatKHR>& offered) {
    return chooseSurfaceFormat(offered).format;
}

TEST(SurfaceFormat, IsOneThatWritesBytesAsTheyAre) {
    constexpr auto kSrgb = ColorSpaceKHR::eSrgbNonlinear;
    EXPECT_EQ(formatAmong({{Format::eB8G8R8A8Srgb, kSrgb},
                           {Format::eR8G8B8A8Unorm, kSrgb},
                           {Format::eB8G8R8A8Unorm, kSrgb}}),
              Format::eB8G8R8A8Unorm);
    EXPECT_EQ(formatAmong({{Format::eA2B10G10R10UnormPack32, kSrgb}, {Format::eR8G8B8A8Unorm, kSrgb}}),
              Format::eR8G8B8A8Unorm);
    EXPECT_EQ(formatAmong({{Format::eA2B10G10R10UnormPack32, kSrgb}}), Format::eA2B10G10R10UnormPack32);
    EXPECT_EQ(formatAmong({{Format::eUndefined, kSrgb}}), Format::eB8G8R8A8Unorm);
    // Another space would show other colours.
    EXPECT_EQ(formatAmong({{Format::eB8G8R8A8Unorm, ColorSpaceKHR::eDisplayP3NonlinearEXT},
                           {Format::eR8G8B8A8Unorm, kSrgb}}),
              Format::eR8G8B8A8Unorm);
    EXPECT_THROW(formatAmong({{Format::eB8G8R8A8Srgb, kSrgb}}), base::RunError);
    EXPECT_THROW(formatAmong({}), base::RunError);
}

TEST(SurfaceFormat, HoldsBytesOrTenBits) {
    EXPECT_TRUE(holdsBytes(Format::eB8G8R8A8Unorm));
    EXPECT_TRUE(holdsBytes(Format::eR8G8B8A8Unorm));
    EXPECT_FALSE(holdsBytes(Format::eA2B10G10R10UnormPack32));
}

TEST(PresentMode, IsMailboxWhereThereIsOne) {
    using Mode = vk::PresentModeKHR;
    const std::vector<Mode> all{Mode::eImmediate, Mode::eMailbox, Mode::eFifo};
    const std::vector<Mode> least{Mode::eFifo};
    EXPECT_EQ(choosePresentMode(all, Pace::newest), Mode::eMailbox);
    EXPECT_EQ(choosePresentMode(all, Pace::display), Mode::eFifo);
    EXPECT_EQ(choosePresentMode(least, Pace::newest), Mode::eFifo);
}

vk::SurfaceCapabilitiesKHR surfaceOf(vk::Extent2D now, vk::Extent2D least = {1, 1},
                                     vk::Extent2D most = {16384, 16384}) {
    vk::SurfaceCapabilitiesKHR surface;
    surface.currentExtent = now;
    surface.minImageExtent = least;
    surface.maxImageExtent = most;
    return surface;
}

TEST(SurfaceExtent, IsTheSurfacesOrWhatIsWanted) {
    constexpr std::uint32_t kAny = std::numeric_limits<std::uint32_t>::max();
    const vk::Extent2D wanted{800, 480};
    EXPECT_EQ(chooseSurfaceExtent(surfaceOf({640, 360}), wanted), (vk::Extent2D{640, 360}));
    EXPECT_EQ(chooseSurfaceExtent(surfaceOf({kAny, kAny}), wanted), wanted);
    EXPECT_EQ(chooseSurfaceExtent(surfaceOf({kAny, kAny}, {900, 1}), wanted), (vk::Extent2D{900, 480}));
    EXPECT_EQ(chooseSurfaceExtent(surfaceOf({kAny, kAny}, {1, 1}, {500, 300}), wanted),
              (vk::Extent2D{500, 300}));
}

TEST(SurfaceExtent, IsNoneWithoutPixels) {
    constexpr std::uint32_t kAny = std::numeric_limits<std::uint32_t>::max();
    EXPECT_FALSE(chooseSurfaceExtent(surfaceOf({0, 0}), {800, 480}));
    EXPECT_FALSE(chooseSurfaceExtent(surfaceOf({0, 360}), {800, 480}));
    EXPECT_FALSE(chooseSurfaceExtent(surfaceOf({kAny, kAny}, {0, 0}, {0, 0}), {800, 480}));
}

TEST(SurfaceImages, AreOneMoreThanTheLeast) {
    vk::SurfaceCapabilitiesKHR surface;
    surface.minImageCount = 3;
    surface.maxImageCount = 0; // no limit
    EXPECT_EQ(chooseImageCount(surface), 4u);
    surface.maxImageCount = 3;
    EXPECT_EQ(chooseImageCount(surface), 3u);
}

TEST(SurfaceAlpha, IsOpaqueWhereItCanBe) {
    using Alpha = vk::CompositeAlphaFlagBitsKHR;
    vk::SurfaceCapabilitiesKHR surface;
    surface.supportedCompositeAlpha = Alpha::eInherit | Alpha::eOpaque;
    EXPECT_EQ(chooseCompositeAlpha(surface), Alpha::eOpaque);
    surface.supportedCompositeAlpha = Alpha::ePostMultiplied | Alpha::eInherit;
    EXPECT_EQ(chooseCompositeAlpha(surface), Alpha::eInherit);
    surface.supportedCompositeAlpha = Alpha::ePostMultiplied;
    EXPECT_EQ(chooseCompositeAlpha(surface), Alpha::ePostMultiplied);
}

} // namespace

} // namespace cdr::viewer
