#include "drawing_options.h"

#include "help_texts.h"
#include "parsed_option.h"

#include <CLI/CLI.hpp>
#include <cdr/base/enum_names.h>
#include <cdr/platform/worker_pool.h>

#include <fmt/format.h>

namespace cdr::options {

depth::Technique TechniqueParts::technique() const {
    return {.mapping = mapping.value_or(depth::Mapping::standard),
            .split = split.value_or(depth::Split(depth::SplitNone{}))};
}

void addTechniqueParts(CLI::App& command, TechniqueParts& parts) {
    addParsed(command, "--depth", parts.mapping, depth::parseMapping,
              mappingHelp() + ". With --split, instead of --technique");
    addParsed(command, "--split", parts.split, depth::parseSplit, kSplitHelp);
}

void addDepthFormat(CLI::App& command, std::optional<depth::DepthFormat>& format) {
    addParsed(command, "--format", format, depth::parseDepthFormat,
              "Format of the depth buffer: " + base::listNames(depth::kDepthFormats))
        ->default_str("d32f");
}

void addTargets(CLI::App& command, render::TargetsChoice& targets) {
    addNamed(command, "--targets", targets, render::parseTargets,
             fmt::format("How cascades are drawn into the G-buffer: {}; pool:N has N layers, {} to {}",
                         base::listNames(render::kTargetsKinds), render::kMinPoolLayers,
                         render::kMaxPoolLayers));
}

void addSubmission(CLI::App& command, render::RenderOptions& options) {
    addNamed(
        command, "--submission", options.submission, render::parseSubmission,
        "How draws are submitted: secondaries (secondary command buffers), primaries (primary ones only) or "
        "gpu-driven (indirect draws that compute shaders make)");
    addNamed(command, "--batching", options.batching, render::parseBatching,
             "How many draws a draw command has: one (per-object, push-constants) or several of one kind "
             "(instanced)");
}

void addDetail(CLI::App& command, visibility::Detail& detail) {
    addNamed(
        command, "--detail", detail, visibility::parseDetail,
        "Levels of detail, chosen by object, by cascade or by cluster: none, object[:PIXELS], cascade[:PIXELS] or "
        "cluster[:PIXELS]. Their error on screen is at most PIXELS, by default 0.5");
}

void addSnapBits(CLI::App& command, std::uint32_t& snapBits) {
    addValue(command, "--snap-bits", snapBits,
             fmt::format("Round vertices to this many sub-pixel bits, as graphics cards do, 0 to {}; with 0 "
                         "the device decides",
                         render::kMaxSnapBits))
        ->check(CLI::Range(0u, render::kMaxSnapBits));
}

void addSnapping(CLI::App& command, render::Snapping& snapping) {
    addNamed(
        command, "--snapping", snapping, render::parseSnapping,
        "How vertices move to sub-pixels: by-device (it rounds them) or in-plane (in the plane of their facet, so "
        "that depth stays exact)");
}

void addThreads(CLI::App& command, std::size_t& threads) {
    addValue(command, "--threads", threads,
             fmt::format("CPU threads that draw and measure, 1 to {}; scenes are opened by all processors",
                         platform::WorkerPool::kMaxThreads))
        ->check(CLI::Range(std::size_t{1}, platform::WorkerPool::kMaxThreads));
}

} // namespace cdr::options
