#include "statistics_report.h"

#include <cdr/measure/statistics/statistics.h>

#include <fmt/format.h>

namespace cdr::viewer {

std::string statisticsReport(const ViewerModel& model, std::uint64_t results, double seconds,
                             std::vector<double> intervals) {
    std::string text =
        fmt::format("{}\n{} frames rendered in {:.1f} s, {:.1f} a second, at the end {:.1f}\n", model.device,
                    results, seconds, static_cast<double>(results) / seconds, model.framesPerSecond);
    const auto line = [&](std::string_view name, const StageSummary& ms) {
        text += fmt::format("{:<10} ms  p50 {:8.2f}  p95 {:8.2f}  p99 {:8.2f}\n", name, ms.median, ms.p95,
                            ms.p99);
    };
    for (const FrameStage stage : kFrameStages) {
        line(nameOf(stage), model.statistics.summary(stage));
    }
    line("all", model.statistics.total());
    if (!intervals.empty()) {
        text += fmt::format(
            "interface  {} frames, interval ms  p50 {:.1f}  p95 {:.1f}  p99 {:.1f}  max {:.1f}\n",
            intervals.size(), measure::percentile(intervals, 50.0), measure::percentile(intervals, 95.0),
            measure::percentile(intervals, 99.0), measure::percentile(intervals, 100.0));
    }
    return text;
}

} // namespace cdr::viewer
