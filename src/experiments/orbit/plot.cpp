#include "orbit.h"

#include <fmt/format.h>
#include <output/gnuplot.h>

#include <algorithm>
#include <array>
#include <optional>

namespace cdr::experiments {

namespace {

/// Percent that stands for none on the logarithmic axis.
constexpr double kNone = 1e-5;

/// Okabe and Ito 2008.
constexpr std::array<const char*, 6> kColors{"#d55e00", "#e69f00", "#cc79a7",
                                             "#0072b2", "#56b4e9", "#009e73"};

/// A line of its own for each: where the colours are used up, they come again with other points and dashes.
std::string lineStyle(std::size_t index) {
    constexpr std::array<int, 4> kPoints{7, 5, 9, 13}; // a disc, a square, triangles
    const std::size_t round = index / kColors.size();
    return fmt::format("pointtype {} dashtype {} linecolor rgb '{}'", kPoints[round % kPoints.size()],
                       round + 1, kColors[index % kColors.size()]);
}

} // namespace

std::string orbitPlot(const std::vector<OrbitResult>& results, const std::string& measuredOn) {
    std::vector<std::string> techniques;
    for (const OrbitResult& result : results) {
        if (std::find(techniques.begin(), techniques.end(), result.technique) == techniques.end()) {
            techniques.push_back(result.technique);
        }
    }
    std::string data;
    std::string plots;
    for (std::size_t i = 0; i < techniques.size(); ++i) {
        data += fmt::format("$data{} << END\n", i);
        for (const OrbitResult& result : results) {
            const std::optional<double> wrong = result.wrong.fraction();
            if (result.technique == techniques[i] && wrong) {
                data += fmt::format("{} {}\n", result.fovYDegrees, std::max(100.0 * *wrong, kNone));
            }
        }
        data += "END\n";
        plots += fmt::format("{}$data{} with linespoints pointsize 0.7 linewidth 2 {} title {}",
                             i == 0 ? "plot " : ", ", i, lineStyle(i), output::gnuplotQuote(techniques[i]));
    }
    return fmt::format("set title {}\n"
                       "set xlabel 'vertical field of view, degrees: from the window to the runway numbers'\n"
                       "set ylabel 'wrong pixels off edges, %'\n"
                       "set logscale xy\n"
                       "set format xy '%g'\n"
                       "set xrange [80:0.0015]\n"
                       "set yrange [{}:150]\n"
                       "set ytics add ('0' {})\n"
                       "set grid ytics lc rgb '#dddddd'\n"
                       "set key outside right\n"
                       "{}{}\n",
                       output::gnuplotQuote("Scene orbit, " + measuredOn), 0.7 * kNone, kNone, data, plots);
}

} // namespace cdr::experiments
