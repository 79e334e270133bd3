#include "timed_ranks.h"

#include <cdr/platform/thread_placement.h>

#include <runs/units.h>

namespace cdr::runs {

void TimedRanks::forEachUnit(std::size_t count, const std::function<output::Json(std::size_t unit)>& time,
                             const std::function<void(std::size_t unit, const output::Json& timed)>& take) {
    m_timers.clear();
    const ranks::Place& place = m_ranks.place();
    runs::forEachUnit(
        m_ranks, count,
        [&](std::size_t unit) {
            return output::Json{{"rank", place.index},
                                {"node", place.node.value_or("")},
                                {"ranks_on_node", place.countOnNode},
                                {"cpus", platform::allowedCpus()},
                                {"timed", time(unit)}};
        },
        [&](std::size_t unit, const output::Json& made) {
            Timer& timer = m_timers[made.at("rank").get<std::size_t>()];
            timer.node = made.at("node").get<std::string>();
            timer.ranksOnNode = made.at("ranks_on_node").get<std::size_t>();
            timer.cpus = made.at("cpus");
            timer.units.push_back(unit);
            take(unit, made.at("timed"));
        });
}

output::Json TimedRanks::measuredBy(const std::string& units) const {
    output::Json rows = output::Json::array();
    for (const auto& [rank, timer] : m_timers) {
        rows.push_back({{"rank", rank},
                        {"node", timer.node},
                        {"ranks_on_node", timer.ranksOnNode},
                        {"cpus", timer.cpus},
                        {units, timer.units}});
    }
    return rows;
}

void addMeasuredBy(output::Json& document, const ranks::Ranks& ranks, const output::Json& measuredBy) {
    if (!ranks.isAlone()) {
        document["measured_by"] = measuredBy;
        document["cpu_choice"] = ranks::nameOf(ranks.place().cpus.choice);
    }
}

} // namespace cdr::runs
