#pragma once

#include <cdr/gpu/device.h>
#include <cdr/render/host_frame.h>
#include <cdr/render/render_options.h>
#include <cdr/render/submit/draw_path.h>

namespace cdr::render {

/// base::InputError that says what is wrong, unless a frame can be recorded into what the host hands in.
void requireRecordable(const gpu::Device& device, const RenderOptions& options, const HostFrame& host);

/// What a draw path needs of the host. The arguments must outlive it.
HostCommands hostCommands(const gpu::Device& device, const RenderOptions& options, const FrameView& view,
                          const HostFrame& host);

} // namespace cdr::render
