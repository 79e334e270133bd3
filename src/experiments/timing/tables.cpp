#include "tables.h"

#include <fmt/format.h>
#include <output/readable.h>
#include <program/machine_state.h>

namespace cdr::experiments {

output::Columns<Comparison> againstColumns() {
    return {
        {.key = "name", .value = &Comparison::name, .heading = "mode"},
        {.key = "here_us", .value = &Comparison::hereUs, .heading = "here us"},
        {.key = "against_us", .value = &Comparison::againstUs, .heading = "against us"},
        {.key = "ratio", .value = &Comparison::ratio, .heading = "ratio"},
        output::intervalColumn(&Comparison::ratio95),
        {.key = "noise_pct",
         .value = &Comparison::noisePercent,
         .heading = "noise",
         .format = {.pattern = "±{} %", .missing = "-"}},
        {.key = "seen", .value = &Comparison::isSeen, .heading = "over the other build", .text = verdictOf}};
}

output::Columns<StageCost> stageColumns(const std::string& mode) {
    return {{.key = "mode", .value = [mode](const StageCost&) { return mode; }, .heading = "mode"},
            {.key = "stage", .value = &StageCost::name, .heading = "stage"},
            {.key = "how", .value = &StageCost::how, .heading = "left out"},
            {.key = "median_us", .value = &StageCost::medianUs, .heading = "us"},
            output::intervalColumn(&StageCost::us95),
            {.key = "frame_pct",
             .value = &StageCost::framePercent,
             .heading = "of the frame",
             .format = {"{} %"}}};
}

output::Columns<MemoryCost> memoryColumns() {
    return {{.key = "what", .value = &MemoryCost::what, .heading = "what"},
            {.key = "per", .value = &MemoryCost::per, .heading = "per"},
            {.key = "on", .value = &MemoryCost::on, .heading = "on"},
            {.key = "predicted_bytes", .value = &MemoryCost::predictedBytes, .heading = "predicted bytes"},
            {.key = "measured_bytes", .value = &MemoryCost::measuredBytes, .heading = "measured bytes"}};
}

output::Json machineJson(const program::MachineState& before) {
    return {{"governor", before.governor},
            {"load", before.load},
            {"load_after", program::machineState().load},
            {"busy", before.isBusy()}};
}

std::string machineText(const program::MachineState& before) {
    const auto text = [](const std::optional<double>& load) {
        return load ? fmt::format("{}", output::Readable{*load}) : "not known";
    };
    return fmt::format("governor {}, load {} before and {} after{}", before.governor.value_or("not known"),
                       text(before.load), text(program::machineState().load),
                       before.isBusy() ? "; other programs took time, so repeat this on a quiet machine"
                                       : "");
}

} // namespace cdr::experiments
