#include "stages.h"
#include "timing.h"

#include <fmt/format.h>
#include <output/gnuplot.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

namespace cdr::experiments {

namespace {

/// In data, where gnuplot draws nothing for NaN.
std::string numberOf(const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : "NaN";
}

/// Two columns, both ends.
std::string endsOf(const std::optional<measure::Interval>& interval) {
    return interval ? fmt::format("{} {}", interval->low, interval->high) : "NaN NaN";
}

/// A grey band over all bars; nothing where the noise is not known.
std::string bandOf(const std::optional<measure::Interval>& noise) {
    return noise ? fmt::format("set object 1 rectangle from graph 0, first {} to graph 1, first {} fillcolor "
                               "rgb '#eeeeee' fillstyle solid noborder behind\n",
                               noise->low, noise->high)
                 : "";
}

} // namespace

std::string timingPlot(const std::vector<TimingResult>& results, const std::string& measuredOn) {
    std::string rows;
    for (std::size_t i = 1; i < results.size(); ++i) {
        const TimingResult& result = results[i];
        // In data, unlike in commands, only double quotes make a string.
        const std::string over = result.mode.isRival() ? " over " + result.over : "";
        rows += fmt::format("{} \"{}{}\" {} {} {}\n", i, result.mode.name, over, result.overheadPercent,
                            endsOf(result.overheadPercent95), numberOf(result.mode.thesisPercent));
    }
    const std::optional<measure::Interval>& noise = results.at(1).overheadPercent95;
    return fmt::format(
        "set title {}\n"
        "set ylabel 'overhead over standard, % (median of ratios per frame, 95 % interval)'\n"
        "set xtics rotate by -40 nomirror\n"
        "set grid ytics lc rgb '#dddddd'\n"
        "set key top left\n"
        "set xrange [0.3:{}]\n"
        "set yrange [*<0:0<*]\n" // without intervals gnuplot begins at the smallest bar
        "set xzeroaxis lt -1\n"
        "{}"
        "$data << END\n{}END\n"
        "plot $data using 1:3:4:5:(0.6):xtic(2) with boxerrorbars fillstyle solid 0.6 linecolor rgb "
        "'#0072b2' title 'measured{}', "
        "$data using 1:6 with points pointtype 7 pointsize 1.4 linecolor rgb '#d55e00' "
        "title 'thesis, Figure 6.4'\n",
        output::gnuplotQuote("Frame time over standard, " + measuredOn),
        static_cast<double>(results.size()) - 0.3, bandOf(noise), rows,
        noise ? "; grey band: the noise floor" : "");
}

std::string stagesPlot(const std::vector<ModeStages>& modes, const std::string& measuredOn) {
    const std::size_t parts = modes.front().stages.size() - 1; // the last is the whole frame
    std::string rows = "mode";
    for (std::size_t i = 0; i < parts; ++i) {
        rows += fmt::format(" \"{}\"", modes.front().stages[i].name);
    }
    for (const ModeStages& mode : modes) {
        rows += fmt::format("\n\"{}\"", mode.mode);
        for (std::size_t i = 0; i < parts; ++i) {
            rows += fmt::format(" {}", std::max(0.0, mode.stages[i].medianUs / 1000.0));
        }
    }
    return fmt::format("set title {}\n"
                       "set ylabel 'milliseconds a frame, medians'\n"
                       "set yrange [0:]\n"
                       "set xtics rotate by -40 nomirror\n"
                       "set grid ytics lc rgb '#dddddd'\n"
                       "set key outside right reverse Left invert\n"
                       "set style data histograms\n"
                       "set style histogram rowstacked\n"
                       "set style fill solid 0.8 border rgb '#ffffff'\n"
                       "set boxwidth 0.6\n"
                       "$data << END\n{}\nEND\n"
                       "plot for [i=2:{}] $data using i:xtic(1) title columnheader\n",
                       output::gnuplotQuote("What each stage of a frame costs, " + measuredOn), rows,
                       parts + 1);
}

} // namespace cdr::experiments
