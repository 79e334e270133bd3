#include "timing_command.h"

#include <experiments/timing/tables.h>

#include <fmt/format.h>
#include <output/columns.h>
#include <output/gnuplot.h>

namespace cdr::cli {

void timeStages(Command& command, const TimingArguments& arguments) {
    experiments::TimingOptions options = arguments.options;
    options.frames = arguments.frames.value_or(kStageFrames);
    // Standard is there once: its second mode, the noise floor, is left out.
    std::vector<experiments::TimingMode> modes{options.modes.front()};
    if (!arguments.modes.empty()) {
        modes.insert(modes.end(), options.modes.begin() + 2, options.modes.end());
    }
    for (const experiments::TimingMode& mode : modes) { // before anything is measured
        experiments::requireStages(mode);
    }
    auto rows = output::Json::array();
    auto measuredBy = output::Json::array();
    runs::TimedRanks ranks(command.ranks());
    std::vector<experiments::ModeStages> plotted;
    for (const experiments::TimingMode& mode : modes) {
        options.modes = {mode};
        const std::vector<experiments::StageCost> stages = experiments::runStages(
            command.device(), options, command.progressOf("frames of " + mode.name), ranks);
        command.endProgress();
        if (!ranks.isFirst()) {
            continue;
        }
        for (output::Json row : ranks.measuredBy("frames")) {
            row["mode"] = mode.name;
            measuredBy.push_back(std::move(row));
        }
        const auto columns = experiments::stageColumns(mode.name);
        command.console().table(output::tableOf(columns, stages));
        for (const output::Json& row : output::jsonOf(columns, stages)) {
            rows.push_back(row);
        }
        plotted.push_back({mode.name, stages});
    }
    if (!ranks.isFirst()) {
        return;
    }
    if (!arguments.plot.empty()) {
        output::writePlot(arguments.plot, experiments::stagesPlot(plotted, command.opened().text()));
    }
    command.console().line(fmt::format("\n{}; {} frames of each variant in turns; {}",
                                       command.opened().text(), options.frames,
                                       experiments::machineText(arguments.machine)));
    auto document = command.makeDocument({{"width", options.width},
                                          {"height", options.height},
                                          {"frames", options.frames},
                                          {"threads", options.threads},
                                          {"seed", options.seed}});
    document["machine"] = experiments::machineJson(arguments.machine);
    document["results"] = rows;
    runs::addMeasuredBy(document, command.ranks(), measuredBy);
    command.writeDocument(document);
}

} // namespace cdr::cli
