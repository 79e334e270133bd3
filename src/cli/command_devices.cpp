#include "command.h"
#include "commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <ranks/join.h>

namespace cdr::cli {

namespace {

struct NoArguments {};

const output::Columns<gpu::DeviceInfo>& deviceColumns() {
    using Info = gpu::DeviceInfo;
    static const output::Columns<Info> kColumns{
        {.heading = "device",
         .text = [](const Info& info) { return fmt::format("{} {}", info.index, info.name); }},
        {.key = "index", .value = &Info::index},
        {.key = "name", .value = &Info::name},
        {.key = "driver", .value = &Info::driver, .heading = "driver"},
        {.key = "api", .value = &Info::api, .heading = "Vulkan"},
        {.key = "kind",
         .value = [](const Info& info) { return gpu::nameOf(info.kind); },
         .heading = "kind",
         .before = "driver"},
        {.key = "usable", .value = [](const Info& info) { return info.missing.empty(); }},
        {.key = "missing", .value = &Info::missing},
        {.key = "queues", .value = &Info::queues, .heading = "queues"},
        {.key = "depth_formats",
         .value = [](const Info& info) { return depth::namesOf(info.depthFormats); },
         .heading = "depth formats",
         .text =
             [](const Info& info) {
                 return fmt::format("{}", fmt::join(depth::namesOf(info.depthFormats), " "));
             }},
        {.key = "sub_pixel_bits", .value = &Info::subPixelBits, .heading = "sub-pixel bits"},
        {.key = "gpu_driven_missing", .value = &Info::gpuDrivenMissing},
        {.key = "deform_missing", .value = &Info::deformMissing},
        {.key = "max_image_side", .value = &Info::maxImageSide, .heading = "largest side"},
        {.key = "max_buffer_bytes", .value = &Info::maxBufferBytes},
        {.key = "max_index", .value = &Info::maxIndex},
        {.key = "max_storage_buffer_bytes", .value = &Info::maxStorageBufferBytes},
        {.key = "timestamp_period_ns", .value = &Info::timestampPeriodNs},
        {.heading = "usable", .text = [](const Info& info) {
             return info.missing.empty() ? "yes" : fmt::format("no: lacks {}", fmt::join(info.missing, ", "));
         }}};
    return kColumns;
}

void runDevices(Command& command, NoArguments&) {
    const gpu::Instance instance({.validate = command.global().validate, .extensions = {}});
    const std::vector<gpu::DeviceInfo> devices = gpu::listDevices(instance);
    if (devices.empty()) {
        command.console().line("no Vulkan device found; for a software one install mesa-vulkan-drivers");
    } else {
        command.console().table(output::tableOf(deviceColumns(), devices));
    }
    const std::string mpi = ranks::mpiLibrary();
    command.console().line(mpi.empty() ? "built without MPI: runs on one machine" : "built with " + mpi);
    auto document = command.makeDocument(nlohmann::ordered_json::object());
    document["results"] = output::jsonOf(deviceColumns(), devices);
    document["mpi"] = mpi.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(mpi);
    command.writeDocument(document);
}

} // namespace

void addDevices(CLI::App& program, const GlobalOptions& global) {
    addCommand<NoArguments>(
        program, global, "devices", "List every Vulkan device and what it can do here",
        [](CLI::App&, NoArguments&) {}, runDevices, RankUse::first);
}

} // namespace cdr::cli
