#include "rank_machine.h"

#include <cdr/gpu/device.h>

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <thread>
#include <vector>

namespace cdr::cli {

namespace {

constexpr const char* kThreads = "LP_NUM_THREADS";

/// Processors that this rank's drawing may keep busy: its part of the machine, and no more than MPI bound it to.
unsigned processorsOf(const ranks::Place& place) {
    const auto machine = static_cast<unsigned>(std::max(::sysconf(_SC_NPROCESSORS_ONLN), 1L));
    const unsigned bound = std::max(std::thread::hardware_concurrency(), 1u);
    return std::clamp(machine / static_cast<unsigned>(place.countOnNode), 1u, bound);
}

} // namespace

std::string dealtDevice(const ranks::Place& place) {
    std::vector<gpu::DeviceInfo> devices = gpu::listDevices(gpu::Instance({.extensions = {}}));
    std::erase_if(devices, [](const gpu::DeviceInfo& info) { return !info.missing.empty(); });
    const auto isProcessor = [](const gpu::DeviceInfo& info) { return info.kind == gpu::DeviceKind::cpu; };
    if (!std::all_of(devices.begin(), devices.end(), isProcessor)) {
        std::erase_if(devices, isProcessor);
    }
    return devices.empty() ? "" : std::to_string(devices[place.indexOnNode % devices.size()].index);
}

void divideProcessors(const ranks::Place& place) {
    if (place.countOnNode > 1) {
        ::setenv(kThreads, std::to_string(processorsOf(place)).c_str(), 0);
    }
}

std::string textOf(const ranks::Place& place) {
    const char* threads = std::getenv(kThreads);
    return fmt::format("{} ranks, {} of them on this machine{}", place.count, place.countOnNode,
                       threads != nullptr ? fmt::format("; lavapipe draws with {} thread{} in each", threads,
                                                        std::string(threads) == "1" ? "" : "s")
                                          : "");
}

} // namespace cdr::cli
