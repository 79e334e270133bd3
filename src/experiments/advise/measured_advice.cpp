#include "measured_advice.h"

#include <cdr/base/error.h>
#include <experiments/probe/probe.h>
#include <experiments/timing/timing.h>

#include <ranks/one_process.h>

#include <algorithm>

namespace cdr::experiments {

namespace {

/// Each technique once, in the order of the rows.
std::vector<depth::NamedTechnique> techniquesToMeasure(const depth::Advice& advice) {
    std::vector<depth::NamedTechnique> techniques;
    for (const depth::AdviceRow& row : advice.rows) {
        const std::string name = nameOf(row.technique);
        const bool known = std::any_of(techniques.begin(), techniques.end(),
                                       [&](const auto& other) { return other.name == name; });
        if (!known) {
            techniques.push_back({name, row.technique});
        }
    }
    return techniques;
}

std::vector<ProbeResult> probe(const gpu::Device& device, const depth::AdviceQuestion& question,
                               const std::vector<depth::NamedTechnique>& techniques,
                               const MeasuredAdviceOptions& options, const NamedProgress& progress) {
    const ProbeOptions probing{
        .distancesView = {question.scene.atView},
        .techniques = techniques,
        .nearView = question.scene.nearView,
        .farView = question.scene.farView,
        .formats = question.formats,
        .drawing = {.width = options.width, .height = options.height, .threads = options.threads},
        .seed = options.seed};
    ranks::OneProcess alone;
    return runProbe(device, probing, progress, alone);
}

std::vector<TimingResult> time(const gpu::Device& device,
                               const std::vector<depth::NamedTechnique>& techniques,
                               const MeasuredAdviceOptions& options, const NamedProgress& progress) {
    TimingOptions timing{.width = options.width,
                         .height = options.height,
                         .frames = options.frames,
                         .threads = options.threads,
                         .seed = options.seed};
    timing.modes = {{.name = "baseline",
                     .preset = "standard",
                     .drawing = {.technique = depth::parseTechnique("standard")},
                     .thesisPercent = {}}};
    timing.modes.front().drawing.technique.format = techniques.front().technique.format;
    for (const auto& [name, technique] : techniques) {
        timing.modes.push_back(
            {.name = name, .preset = name, .drawing = {.technique = technique}, .thesisPercent = {}});
    }
    ranks::OneProcess alone;
    runs::TimedRanks here(alone);
    return runTiming(
        device, timing, [&](std::size_t done, std::size_t all) { progress(done, all, "what they cost"); },
        here);
}

} // namespace

depth::AdviceQuestion onDevice(const gpu::Device& device, depth::AdviceQuestion question) {
    const std::vector<depth::DepthFormat>& has = device.info().depthFormats;
    std::erase_if(question.formats,
                  [&](depth::DepthFormat format) { return std::ranges::find(has, format) == has.end(); });
    if (question.formats.empty()) {
        throw base::InputError(device.info().name + " has none of the depth formats asked for");
    }
    question.subPixelBits = device.info().subPixelBits;
    return question;
}

depth::Advice measureAdvice(const gpu::Device& device, const depth::AdviceQuestion& question,
                            const MeasuredAdviceOptions& options, const NamedProgress& progress) {
    const depth::Advice predicted = depth::advise(question);
    const std::vector<depth::NamedTechnique> techniques = techniquesToMeasure(predicted);
    const std::vector<ProbeResult> probed = probe(device, question, techniques, options, progress);
    const std::vector<TimingResult> timed = time(device, techniques, options, progress);
    std::vector<std::optional<depth::Measurement>> measurements;
    for (const depth::AdviceRow& row : predicted.rows) {
        const auto result = std::find_if(probed.begin(), probed.end(), [&](const ProbeResult& candidate) {
            return candidate.technique == nameOf(row.technique) && candidate.format == row.technique.format;
        });
        const auto cost = std::find_if(timed.begin(), timed.end(), [&](const TimingResult& candidate) {
            return candidate.mode.name == nameOf(row.technique);
        });
        const auto ratio = [](double percent) { return 1.0 + 0.01 * percent; };
        // In a picture so small that no pixel tells, no separation was tried.
        measurements.emplace_back(
            depth::Measurement{.resolvedView = result->resolvedView,
                               .largestView = result->pairsSeen > 0 ? result->largestView : 0.0,
                               .timeRatio = ratio(cost->overheadPercent),
                               .timeRatio95 = {},
                               .resolvesAll = result->pairsSeen > 0 && result->resolvesAll});
        if (const auto& percent95 = cost->overheadPercent95) {
            measurements.back()->timeRatio95 = {.low = ratio(percent95->low), .high = ratio(percent95->high)};
        }
    }
    return depth::advise(question, measurements);
}

} // namespace cdr::experiments
