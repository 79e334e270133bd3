#pragma once

#include <cdr/gpu/device.h>

#include <cstdint>
#include <string>
#include <vector>

namespace cdr::experiments {

/// What one instance, draw or pixel takes of memory.
struct MemoryCost {
    std::string what; ///< such as "cells" or "layers"
    std::string per;  ///< "instance", "draw" or "pixel"
    std::string on;   ///< "host" or "device"
    double predictedBytes = 0.0;
    double measuredBytes = 0.0;
};

struct MemoryOptions {
    std::uint32_t width = 1280;
    std::uint32_t height = 720;
    std::uint32_t instances = 200'000;
    unsigned cascades = 4; ///< of the pictures' technique, cdr
    std::uint64_t seed = 2013;
};

/// Instances of the timing scene, draws of the crowd, and pixels of each kind of targets. Measured is what a larger scene or
/// picture takes over a smaller one. So what there is once does not count: on the device by its allocator, in main memory by
/// the C library's. 0 in main memory where that does not tell. Main memory that the device reads counts as the device's.
std::vector<MemoryCost> measureMemory(const gpu::Device& device, const MemoryOptions& options);

} // namespace cdr::experiments
