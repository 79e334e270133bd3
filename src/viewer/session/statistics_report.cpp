#include "statistics_report.h"

#include <cdr/base/quantity_text.h>
#include <cdr/measure/statistics/statistics.h>

#include <fmt/format.h>

namespace cdr::viewer {

namespace {

std::string plain(double value) {
    return base::quantityText(value, base::NumberStyle::plain);
}

} // namespace

std::string statisticsReport(const PerformanceModel& performance, std::uint64_t results, double seconds,
                             const std::vector<double>& intervals) {
    std::string text = fmt::format(
        "{}\n{} frames rendered in {} s, {} a second, at the end {}\n", performance.device, results,
        plain(seconds), plain(static_cast<double>(results) / seconds), plain(performance.framesPerSecond));
    const auto line = [&](std::string_view name, const StageSummary& ms) {
        text += fmt::format("{:<10} ms  p50 {:>8}  p95 {:>8}  p99 {:>8}\n", name, plain(ms.median),
                            plain(ms.p95), plain(ms.p99));
    };
    for (const FrameStage stage : kFrameStages) {
        line(nameOf(stage), performance.statistics.summary(stage));
    }
    line("all", performance.statistics.total());
    if (!intervals.empty()) {
        text += fmt::format(
            "interface  {} frames, interval ms  p50 {}  p95 {}  p99 {}  max {}\n", intervals.size(),
            plain(measure::percentile(intervals, 50.0)), plain(measure::percentile(intervals, 95.0)),
            plain(measure::percentile(intervals, 99.0)), plain(measure::percentile(intervals, 100.0)));
    }
    return text;
}

} // namespace cdr::viewer
