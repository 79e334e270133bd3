#include "drawing_options.h"

#include "parsed_option.h"

#include <CLI/CLI.hpp>
#include <cdr/base/enum_names.h>
#include <cdr/platform/worker_pool.h>

namespace cdr::options {

depth::Technique TechniqueParts::technique() const {
    return {.mapping = mapping.value_or(depth::Mapping::standard),
            .split = split.value_or(depth::Split(depth::SplitNone{}))};
}

void addTechniqueParts(CLI::App& command, TechniqueParts& parts) {
    addParsed(command, "--depth", parts.mapping, depth::parseMapping,
              "Depth mapping, instead of a preset: " + base::listNames(depth::kMappings));
    addParsed(command, "--split", parts.split, depth::parseSplit,
              "How cascades are cut: none, ratio:R, count:K, at:a,b,..., minimax:K or "
              "fitted[:TARGET[px][,max=K]]");
}

void addDepthFormat(CLI::App& command, std::optional<depth::DepthFormat>& format) {
    addParsed(command, "--format", format, depth::parseDepthFormat, "Depth buffer: d16, d24 or d32f");
}

void addTargets(CLI::App& command, render::TargetsChoice& targets) {
    addNamed(command, "--targets", targets, render::parseTargets,
             "How cascades reach the G-buffer, pool as pool:LAYERS too: " +
                 base::listNames(render::kTargetsKinds));
}

void addSubmission(CLI::App& command, render::RenderOptions& options) {
    addNamed(command, "--submission", options.submission, render::parseSubmission,
             "How draws reach the device: secondaries, primaries or gpu-driven");
    addNamed(command, "--batching", options.batching, render::parseBatching,
             "How draws become commands: per-object, push-constants or instanced");
}

void addDetail(CLI::App& command, visibility::Detail& detail) {
    addNamed(command, "--detail", detail, visibility::parseDetail,
             "Level of detail by projected error: none, object[:PIXELS], cascade[:PIXELS] or "
             "cluster[:PIXELS]");
}

void addSnapBits(CLI::App& command, std::uint32_t& snapBits) {
    command
        .add_option("--snap-bits", snapBits,
                    "Round vertices to this many sub-pixel bits, as graphics cards do; 0: the device decides")
        ->check(CLI::Range(0u, render::kMaxSnapBits))
        ->capture_default_str();
}

void addSnapping(CLI::App& command, render::Snapping& snapping) {
    addNamed(
        command, "--snapping", snapping, render::parseSnapping,
        "How vertices get to sub-pixels: by-device, which rounds them, or in-plane, which moves them in the "
        "plane of their facet, so that depth stays exact");
}

void addThreads(CLI::App& command, std::size_t& threads, const std::string& help) {
    command.add_option("--threads", threads, help)
        ->check(CLI::Range(std::size_t{1}, platform::WorkerPool::kMaxThreads))
        ->capture_default_str();
}

} // namespace cdr::options
