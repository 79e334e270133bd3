#include "scaling.h"

#include <fmt/format.h>
#include <output/gnuplot.h>

#include <algorithm>

namespace cdr::experiments {

namespace {

/// The points of one number of cubes as a data block of threads, ns per draw, and speed-up.
std::string dataBlock(const std::vector<ScalingPoint>& points, std::size_t index) {
    std::string block = fmt::format("$data{} << END\n", index);
    for (const ScalingPoint& point : points) {
        block += fmt::format("{} {} {}\n", point.threads, point.recordNsPerDraw(), point.recordSpeedUp);
    }
    return block + "END\n";
}

std::string plotLines(const std::vector<std::vector<ScalingPoint>>& sweeps, int column) {
    std::string lines;
    for (std::size_t i = 0; i < sweeps.size(); ++i) {
        lines += fmt::format("{}$data{} using 1:{} with linespoints linewidth 2 pointtype 7 title {}",
                             i == 0 ? "" : ", ", i, column,
                             output::gnuplotQuote(fmt::format("{} draws", sweeps[i].front().draws)));
    }
    return lines;
}

} // namespace

std::string scalingPlot(const ScalingResult& result, const std::string& measuredOn) {
    const ScalingVariant& first = result.points.front().variant;
    std::vector<std::vector<ScalingPoint>> sweeps;
    std::size_t mostThreads = 1;
    for (const ScalingPoint& point : result.points) {
        if (point.variant != first) {
            continue;
        }
        if (sweeps.empty() || sweeps.back().front().cubes != point.cubes) {
            sweeps.emplace_back();
        }
        sweeps.back().push_back(point);
        mostThreads = std::max(mostThreads, point.threads);
    }
    std::string blocks;
    for (std::size_t i = 0; i < sweeps.size(); ++i) {
        blocks += dataBlock(sweeps[i], i);
    }
    return fmt::format(
        "{}set multiplot layout 1,2 title {}\n"
        "set grid lc rgb '#dddddd'\n"
        "set xlabel 'threads'\n"
        "set xrange [0.8:{}]\n"
        "set xtics 1\n"
        "set yrange [0:*]\n"
        "set ylabel 'record, ns per draw'\n"
        "plot {}\n"
        "set ylabel 'record, times as fast as one thread'\n"
        "set key top left\n"
        "plot {}, x with lines dashtype 2 linecolor rgb '#888888' title 'ideal'\n"
        "unset multiplot\n",
        blocks,
        output::gnuplotQuote(fmt::format("Recording, targets {}, cascades {}, {}; {}", nameOf(first.targets),
                                         first.cascades, nameOf(first.submission), measuredOn)),
        static_cast<double>(mostThreads) + 0.2, plotLines(sweeps, 2), plotLines(sweeps, 3));
}

} // namespace cdr::experiments
