#pragma once

#include <cdr/gpu/device.h>

#include <cstdint>

namespace cdr::gpu {

/// Device-local bytes of all buffers and images that the device's allocator holds now, each as large as the driver made it.
/// Counts what others made where the allocator is lent (BorrowedDevice::allocator). What a graphics card keeps in the host's
/// memory, such as what is read back, is not counted.
std::uint64_t allocatedDeviceBytes(const Device& device);

} // namespace cdr::gpu
