#pragma once

#include <cdr/gpu/pipeline.h>

namespace cdr::gpu {

/// A shader that rounds float32 and float64 to the nearest, ties to even, as the CPU does. Else Vulkan leaves the choice to
/// the device. glslang 12 keeps one rounding mode a shader, so both are declared here. The device must have
/// shaderRoundingModeRTEFloat32 and shaderRoundingModeRTEFloat64.
/// @param spirv of one entry point, which declares no rounding mode.
Spirv roundingToNearestEven(const Spirv& spirv);

} // namespace cdr::gpu
