#pragma once

#include <cdr/measure/certify/certifier.h>
#include <cdr/measure/certify/drawn_frame.h>
#include <cdr/render/frame.h>
#include <cdr/render/render_options.h>

#include <cstdint>

namespace cdr::output {

/// base::InputError for what a certificate cannot follow: effects, a focus and levels of detail.
void requireCertifiable(const render::RenderOptions& options);

/// A rendered frame as a certificate takes it.
/// @param subPixelBits of the device (gpu::DeviceInfo), 1 to 32.
measure::DrawnFrame drawnFrame(const render::Frame& frame, const render::RenderOptions& options,
                               std::uint32_t subPixelBits);

/// Puts the repairs of a certificate into the frame that it is of: object, distance, normal, albedo and colour. A repaired
/// pixel's G-buffer does not have its metallic and roughness; its colour has it.
void putRight(render::Frame& frame, const measure::Certificate& certificate);

} // namespace cdr::output
