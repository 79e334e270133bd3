#include "timing_command.h"

#include <experiments/timing/tables.h>

#include <fmt/format.h>
#include <output/columns.h>

namespace cdr::cli {

void measureMemory(Command& command, const TimingArguments& arguments) {
    const experiments::MemoryOptions options{
        .width = arguments.options.width, .height = arguments.options.height, .seed = arguments.options.seed};
    const std::vector<experiments::MemoryCost> costs = experiments::measureMemory(command.device(), options);
    command.endProgress();
    command.console().table(output::tableOf(experiments::memoryColumns(), costs));
    command.console().line(fmt::format(
        "\n{}; {} instances over half as many, {}x{} over half the width; {} cascades",
        command.opened().text(), 2 * options.instances, 2 * options.width, options.height, options.cascades));
    auto document = command.makeDocument({{"width", options.width},
                                          {"height", options.height},
                                          {"instances", options.instances},
                                          {"cascades", options.cascades},
                                          {"seed", options.seed}});
    document["results"] = output::jsonOf(experiments::memoryColumns(), costs);
    command.writeDocument(document);
}

} // namespace cdr::cli
