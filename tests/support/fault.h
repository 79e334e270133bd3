#pragma once

#include <fmt/format.h>
#include <vulkan/vulkan.h>

#include <ostream>
#include <string>
#include <string_view>

namespace cdr::test {

/// A Vulkan call that fails under tests/drivers/fault_layer.cpp. A lost device stays lost.
struct Fault {
    std::string_view call;
    std::string_view device = "any"; ///< "render", "window" or "any"
    long after = 0;                  ///< calls that succeed first
    long times = 1;                  ///< that fail then
    long result = VK_ERROR_DEVICE_LOST;

    /// Environment variables to put before a command, so that the call fails in its process.
    std::string environment() const {
        return fmt::format("VK_ADD_LAYER_PATH='" CDR_FAULT_LAYER "' VK_INSTANCE_LAYERS=VK_LAYER_CDR_fault "
                           "CDR_FAULT='{} {} {} {} {}'",
                           call, device, after, times, result);
    }

    /// The name of a test case. GoogleTest's own is the bytes, which hold addresses and differ in every process.
    friend std::ostream& operator<<(std::ostream& out, const Fault& fault) {
        return out << fault.call << " of " << fault.device << " after " << fault.after << ", " << fault.times
                   << " times " << fault.result;
    }
};

inline constexpr long kForever = 1'000'000'000;

} // namespace cdr::test
