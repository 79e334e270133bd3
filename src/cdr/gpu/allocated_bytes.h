#pragma once

#include <cdr/gpu/device.h>

#include <cstdint>

namespace cdr::gpu {

/// Bytes of all buffers and images that the device's allocator holds now, each as large as the driver made it. Counts what
/// others made where the allocator is lent (BorrowedDevice::allocator).
std::uint64_t allocatedBytes(const Device& device);

} // namespace cdr::gpu
