#include "commands.h"
#include "console.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace cdr::cli {

namespace {

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
            {"max_image_side", info.maxImageSide},
            {"max_storage_buffer_bytes", info.maxStorageBufferBytes},
            {"timestamp_period_ns", info.timestampPeriodNs}};
}

void runDevices(const GlobalOptions& global, const OutputOptions& output) {
    const gpu::Instance instance({.validate = global.validate, .extensions = {}});
    const Console console(global, output);
    auto document = base::makeDocument("devices", {}, nlohmann::ordered_json::object());
    std::vector<std::vector<std::string>> rows;
    for (const gpu::DeviceInfo& info : gpu::listDevices(instance)) {
        rows.push_back(
            {fmt::format("{} {}", info.index, info.name), info.kind, info.driver, info.api,
             std::to_string(info.queues),
             fmt::format("{}", fmt::join(depth::namesOf(info.depthFormats), " ")),
             std::to_string(info.maxImageSide),
             info.missing.empty() ? "yes" : fmt::format("no: lacks {}", fmt::join(info.missing, ", "))});
        document["results"].push_back(toJson(info));
    }
    if (rows.empty()) {
        console.line("no Vulkan device found; for a software one install mesa-vulkan-drivers");
    } else {
        console.table(
            {{"device", "kind", "driver", "Vulkan", "queues", "depth formats", "largest side", "usable"},
             rows});
    }
    writeJson(output, document);
}

} // namespace

void addDevices(CLI::App& program, const GlobalOptions& global) {
    CLI::App* command = program.add_subcommand("devices", "List every Vulkan device and what it can do here");
    auto output = std::make_shared<OutputOptions>();
    addJson(*command, *output);
    command->callback([&global, output] { runDevices(global, *output); });
}

} // namespace cdr::cli
