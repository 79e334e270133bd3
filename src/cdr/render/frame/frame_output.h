#pragma once

#include <cdr/render/frame/frame_passes.h>

namespace cdr::render {

/// How a frame leaves a renderer: by its images, by a host's images, or by main memory.

/// Where the last frame is. @param last null before the first.
Surfaces surfacesOf(const FramePasses& passes, const FrameSlot* last);

/// Into the images of a host.
void recordOutputs(const gpu::Device& device, FramePasses& passes, FrameSlot& slot, const HostFrame& host);

/// To main memory.
void recordReadback(const gpu::Device& device, const FramePasses& passes, VkCommandBuffer commands,
                    FrameCopy copy);

/// What recordReadback() copied, once the frame is done.
Frame fetch(const FramePasses& passes, const FrameSlot& slot);

} // namespace cdr::render
