#include <cdr/base/error.h>
#include <cdr/render/geometry/begin_cascade.h>
#include <cdr/render/geometry/geometry_pipelines.h>
#include <cdr/render/output/depth_output.h>
#include <cdr/render/output/host_commands.h>

#include <fmt/format.h>
#include <vulkan/vulkan_format_traits.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace cdr::render {

namespace {

void require(bool holds, const std::string& why) {
    if (!holds) {
        throw base::InputError("a frame cannot be recorded: " + why);
    }
}

void requireImage(const SurfaceImage& image, const RenderOptions& options, const char* what) {
    require(image.image != VK_NULL_HANDLE, fmt::format("there is no {} image", what));
    require(image.extent.width == options.width && image.extent.height == options.height,
            fmt::format("the {} image has {}x{} pixels, the renderer {}x{}", what, image.extent.width,
                        image.extent.height, options.width, options.height));
    require(image.layout != VK_IMAGE_LAYOUT_UNDEFINED && image.layout != VK_IMAGE_LAYOUT_PREINITIALIZED,
            fmt::format("no layout is named that the {} image is left in", what));
}

/// Whether vkCmdBlitImage() writes a picture of colours to it.
bool takesColors(const gpu::Device& device, vk::Format format) {
    if (format == vk::Format::eUndefined ||
        !(vk::PhysicalDevice(device.physical()).getFormatProperties(format).optimalTilingFeatures &
          vk::FormatFeatureFlagBits::eBlitDst)) {
        return false;
    }
    const std::string_view numbers = vk::componentNumericFormat(format, 0);
    return std::string_view(vk::componentName(format, 0)) != "D" && numbers != "UINT" && numbers != "SINT";
}

void requireDepth(const HostDepth& depth, const RenderOptions& options) {
    requireImage(depth.image, options, "depth");
    require(vk::Format(depth.image.format) == kHostDepthFormat,
            "the format of the depth image is not D32_SFLOAT");
    require(depth.image.view != VK_NULL_HANDLE, "the depth image has no view");
    require(depth.mapping == depth::Mapping::reversed || depth.mapping == depth::Mapping::standard,
            fmt::format("a host's depth is reversed or standard, not {}", nameOf(depth.mapping)));
    require(std::isfinite(depth.nearView) && depth.nearView > 0.0, "the host's near plane must be above 0");
    require(depth.farView || depth.mapping == depth::Mapping::reversed, "standard depth needs a far plane");
    require(!depth.farView || (std::isfinite(*depth.farView) && *depth.farView > depth.nearView),
            "the host's far plane must be beyond its near plane");
}

void requireColor(const gpu::Device& device, const SurfaceImage& color, const RenderOptions& options) {
    requireImage(color, options, "color");
    require(takesColors(device, vk::Format(color.format)),
            fmt::format("{} writes no pictures to images of format {}", device.info().name,
                        vk::to_string(vk::Format(color.format))));
}

/// Whether its pixels hold so many floats, of any sign where asked for.
void requireFloats(const gpu::Device& device, const SurfaceImage& image, const RenderOptions& options,
                   const char* what, std::uint8_t count, bool isSigned) {
    requireImage(image, options, what);
    const auto format = vk::Format(image.format);
    const std::string_view numbers = vk::componentNumericFormat(format, 0);
    require(takesColors(device, format) && vk::componentCount(format) >= count &&
                (numbers == "SFLOAT" || (numbers == "UFLOAT" && !isSigned)),
            fmt::format("the {} image needs {} floats or more, in a format that {} writes, which {} is not",
                        what, count, device.info().name, vk::to_string(format)));
}

void requireDraws(const HostFrame& host, const RenderOptions& options) {
    require(!options.occlusionCulling || options.submission == Submission::gpuDriven,
            "occlusion culling submits commands of its own before a frame's");
    require(!host.draw || options.surface == SurfacePath::gbuffer,
            fmt::format("a host draws into a G-buffer, and surface {} keeps none", nameOf(options.surface)));
    require(!host.draw || !options.focus.isOn(),
            "a host cannot draw inside cascades where a lens has a focus");
    require(std::all_of(host.occupied.begin(), host.occupied.end(),
                        [](const depth::Interval& interval) {
                            return std::isfinite(interval.nearView) && std::isfinite(interval.farView) &&
                                   interval.nearView <= interval.farView;
                        }),
            "an occupied interval must run from a nearer to a farther view distance");
}

HostCascade hostCascadeOf(const gpu::Device& device, const RenderOptions& options, const FrameView& view,
                          std::size_t cascade, vk::CommandBuffer commands) {
    const CascadeView& made = view.cascades[cascade];
    const glm::vec2 lens = clipLensShift(view.frustum);
    return {.commands = commands,
            .index = static_cast<std::uint32_t>(cascade),
            .clipRange = made.clipRange,
            .anchorView = made.terms.anchorView,
            .constants = makeCascadeConstants(view, cascade),
            .lensX = lens.x,
            .lensY = lens.y,
            .minDepth = made.slice.min,
            .maxDepth = made.slice.max,
            .depthFormat = device.depthFormat(options.technique.format),
            .depthCompare = static_cast<VkCompareOp>(depthCompareOf(options.technique.mapping))};
}

} // namespace

void requireRecordable(const gpu::Device& device, const RenderOptions& options, const HostFrame& host) {
    require(options.submission != Submission::primaries,
            "submission primaries needs command buffers of its own");
    require(host.commands != VK_NULL_HANDLE, "there is no command buffer");
    require(host.done != VK_NULL_HANDLE, "there is no semaphore that says when it is done");
    require(host.doneValue > 0, "the semaphore has the value 0 from the start");
    if (host.color.image != VK_NULL_HANDLE || !host.linear) {
        requireColor(device, host.color, options);
    }
    if (host.linear) {
        require(options.linear, "linear light is asked for of a renderer that keeps none");
        requireFloats(device, *host.linear, options, "linear", 3, false);
    }
    if (host.depth) {
        requireDepth(*host.depth, options);
    }
    if (host.motion) {
        require(options.motion, "motion is asked for of a renderer that works out none");
        requireFloats(device, *host.motion, options, "motion", 2, true);
    }
    requireDraws(host, options);
}

HostCommands hostCommands(const gpu::Device& device, const RenderOptions& options, const FrameView& view,
                          const HostFrame& host) {
    HostCommands commands{.into = host.commands, .draw = {}};
    if (host.draw) {
        commands.draw = [&device, &options, &view, &host](vk::CommandBuffer into, std::size_t cascade) {
            setCascadeViewport(into, view, cascade);
            host.draw(hostCascadeOf(device, options, view, cascade, into));
        };
    }
    return commands;
}

} // namespace cdr::render
