#pragma once

#include <cdr/gpu/device.h>
#include <scenes/deform.h>

#include <options/cli_app.h>

#include <cstdint>
#include <optional>

namespace cdr::options {

/// Adds --deform.
void addDeform(CLI::App& command, std::optional<scenes::Deform>& deform);

/// Who reads the vertices of meshes that deform.
enum class VertexReaders : std::uint8_t {
    drawing,       ///< the device alone
    drawingAndCpu, ///< truth, certificates or facets too
};

/// Who deforms on a device. Unless told: the device, but the CPU where that is the device, or the device lacks what it takes.
/// base::InputError where it is told to and lacks something, which the message names.
scenes::Deform deformOn(const gpu::DeviceInfo& device, std::optional<scenes::Deform> told,
                        VertexReaders readers);

} // namespace cdr::options
