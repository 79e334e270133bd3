#include "rank_machine.h"

#include <cdr/base/format_error.h>
#include <cdr/gpu/device.h>
#include <cdr/platform/process_cpus.h>
#include <cdr/platform/thread_placement.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace cdr::cli {

namespace {

constexpr const char* kThreads = "LP_NUM_THREADS";

/// By rank of the machine, how many processors its drawing may keep busy.
std::vector<std::size_t> processorsOf(const ranks::Place& place) {
    const std::size_t all = std::max<std::size_t>(std::thread::hardware_concurrency(), 1);
    std::vector<std::size_t> counts(place.countOnNode, std::max<std::size_t>(all / place.countOnNode, 1));
    if (place.cpus.choice != ranks::CpuChoice::unknown) {
        std::transform(place.cpus.parts.begin(), place.cpus.parts.end(), counts.begin(),
                       [](const ranks::Cpus& part) { return part.size(); });
    }
    return counts;
}

/// "1 thread", or "1 to 2 threads" where ranks have unlike parts.
std::string threadsText(const ranks::Place& place) {
    const char* threads = std::getenv(kThreads);
    const std::vector<std::size_t> counts = processorsOf(place);
    const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
    // What the first rank has been told, be it by the user, holds for all where their parts are alike.
    const std::string text = *least == *most || threads != std::to_string(counts[place.indexOnNode])
                                 ? threads
                                 : fmt::format("{} to {}", *least, *most);
    return fmt::format("{} thread{}", text, text == "1" ? "" : "s");
}

/// How the ranks of this machine came to their processors; empty where that is not known.
std::string choiceText(const ranks::Place& place, ProcessorUse use) {
    std::set<std::size_t> all;
    for (const ranks::Cpus& part : place.cpus.parts) {
        all.insert(part.begin(), part.end());
    }
    const std::string processors = fmt::format("{} processor{}", all.size(), all.size() == 1 ? "" : "s");
    const std::string kept = use == ProcessorUse::bound ? ", and each keeps to its part" : "";
    switch (place.cpus.choice) {
    case ranks::CpuChoice::shared:
        return fmt::format("; they share {}{}", processors, kept);
    case ranks::CpuChoice::followed:
        return place.countOnNode == 1 ? "" : fmt::format("; MPI bound each to its own of {}", processors);
    case ranks::CpuChoice::overlapping:
        return fmt::format("; MPI bound them to overlapping parts of {}{}", processors, kept);
    case ranks::CpuChoice::unknown:
        break;
    }
    return "";
}

/// base::RunError where the system does not do it.
void keepTo(const ranks::Cpus& part) {
    platform::allowCpus(part);
    if (platform::allowedCpus() != part) {
        throw base::runError("--bind: the system does not allow this rank to use processor{} {}",
                             part.size() == 1 ? "" : "s", fmt::join(part, ", "));
    }
}

} // namespace

std::string deviceOf(const std::string& choice, const ranks::Place& place) {
    if (choice != kEachDevice) {
        return choice;
    }
    std::vector<gpu::DeviceInfo> devices = gpu::listDevices(gpu::Instance({.extensions = {}}));
    std::erase_if(devices, [](const gpu::DeviceInfo& info) { return !info.missing.empty(); });
    const auto isProcessor = [](const gpu::DeviceInfo& info) { return info.kind == gpu::DeviceKind::cpu; };
    if (!std::all_of(devices.begin(), devices.end(), isProcessor)) {
        std::erase_if(devices, isProcessor);
    }
    return devices.empty() ? "" : std::to_string(devices[place.indexOnNode % devices.size()].index);
}

void divideProcessors(const ranks::Place& place, ProcessorUse use) {
    if (place.countOnNode > 1) {
        ::setenv(kThreads, std::to_string(processorsOf(place)[place.indexOnNode]).c_str(), 0);
        if (use == ProcessorUse::bound && place.cpus.choice != ranks::CpuChoice::unknown) {
            keepTo(place.cpus.parts[place.indexOnNode]);
        }
    }
}

std::string textOf(const ranks::Place& place, ProcessorUse use) {
    std::string text = fmt::format("{} ranks, {} of them on this machine", place.count, place.countOnNode);
    if (std::getenv(kThreads) == nullptr) {
        return text;
    }
    return fmt::format("{}; lavapipe draws with {} in each{}", text, threadsText(place),
                       choiceText(place, use));
}

} // namespace cdr::cli
