#include "command.h"
#include "commands.h"

#include <cdr/base/error.h>
#include <cdr/gpu/device_query.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace cdr::cli {

namespace {

struct NoArguments {};

nlohmann::ordered_json toJson(const gpu::DeviceInfo& info) {
    return {{"index", info.index},
            {"name", info.name},
            {"driver", info.driver},
            {"api", info.api},
            {"kind", info.kind},
            {"usable", info.missing.empty()},
            {"missing", info.missing},
            {"queues", info.queues},
            {"depth_formats", depth::namesOf(info.depthFormats)},
            {"sub_pixel_bits", info.subPixelBits},
            {"gpu_driven_missing", info.gpuDrivenMissing},
            {"max_image_side", info.maxImageSide},
            {"max_storage_buffer_bytes", info.maxStorageBufferBytes},
            {"timestamp_period_ns", info.timestampPeriodNs}};
}

/// base::InputError when --device names none of them.
void requireListed(const std::string& choice, const std::vector<gpu::DeviceInfo>& devices) {
    if (!choice.empty() && std::none_of(devices.begin(), devices.end(), [&](const gpu::DeviceInfo& info) {
            return gpu::isChosen(info, choice);
        })) {
        throw base::InputError(fmt::format("no Vulkan device matches '{}'", choice.substr(0, 60)));
    }
}

void runDevices(Command& command, NoArguments&) {
    const gpu::Instance instance({.validate = command.global().validate, .extensions = {}});
    auto document = command.makeDocument(nlohmann::ordered_json::object());
    std::vector<std::vector<std::string>> rows;
    const std::vector<gpu::DeviceInfo> devices = gpu::listDevices(instance);
    requireListed(command.global().device, devices);
    for (const gpu::DeviceInfo& info : devices) {
        rows.push_back(
            {fmt::format("{} {}", info.index, info.name), info.kind, info.driver, info.api,
             std::to_string(info.queues),
             fmt::format("{}", fmt::join(depth::namesOf(info.depthFormats), " ")),
             std::to_string(info.subPixelBits), std::to_string(info.maxImageSide),
             info.missing.empty() ? "yes" : fmt::format("no: lacks {}", fmt::join(info.missing, ", "))});
        document["results"].push_back(toJson(info));
    }
    if (rows.empty()) {
        command.console().line("no Vulkan device found; for a software one install mesa-vulkan-drivers");
    } else {
        command.console().table({{"device", "kind", "driver", "Vulkan", "queues", "depth formats",
                                  "sub-pixel bits", "largest side", "usable"},
                                 rows});
    }
    command.writeDocument(document);
}

} // namespace

void addDevices(CLI::App& program, const GlobalOptions& global) {
    addCommand<NoArguments>(
        program, global, "devices", "List every Vulkan device and what it can do here",
        [](CLI::App&, NoArguments&) {}, runDevices);
}

} // namespace cdr::cli
