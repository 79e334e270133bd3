#pragma once

#include <experiments/timing/against.h>
#include <experiments/timing/memory_costs.h>
#include <experiments/timing/stages.h>

#include <output/columns.h>
#include <program/machine_state.h>

namespace cdr::experiments {

/// One build over another.
output::Columns<Comparison> againstColumns();
/// The stages of one mode's frame. @param mode its name
output::Columns<StageCost> stageColumns(const std::string& mode);

output::Columns<MemoryCost> memoryColumns();

/// Governor and load, for JSON: what else decides how long things take. @param before the runs.
output::Json machineJson(const program::MachineState& before);
/// The same in words: "governor performance, load 0.4 before and 1.1 after". Says if the machine was busy before.
std::string machineText(const program::MachineState& before);

} // namespace cdr::experiments
