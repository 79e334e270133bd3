#pragma once

#include <cdr/host/machine_state.h>
#include <experiments/columns.h>
#include <experiments/timing/against.h>
#include <experiments/timing/memory_costs.h>
#include <experiments/timing/stages.h>

namespace cdr::experiments {

/// One build over another.
Columns<Comparison> againstColumns();
/// The stages of one mode's frame. @param mode its name
Columns<StageCost> stageColumns(const std::string& mode);

Columns<MemoryCost> memoryColumns();

/// Governor and load, for JSON: what else decides how long things take. @param before the runs.
Json machineJson(const host::MachineState& before);
/// The same in words: "governor performance, load 0.4 before and 1.1 after". Says if the machine was busy before.
std::string machineText(const host::MachineState& before);

} // namespace cdr::experiments
