#include "timed_ranks.h"

#include <cdr/host/thread_placement.h>
#include <experiments/units.h>

namespace cdr::experiments {

void TimedRanks::forEachUnit(std::size_t count, const std::function<Json(std::size_t unit)>& time,
                             const std::function<void(std::size_t unit, const Json& timed)>& take) {
    m_timers.clear();
    const ranks::Place& place = m_ranks.place();
    experiments::forEachUnit(
        m_ranks, count,
        [&](std::size_t unit) {
            return Json{{"rank", place.index},
                        {"node", place.node.value_or("")},
                        {"ranks_on_node", place.countOnNode},
                        {"cpus", host::allowedCpus()},
                        {"timed", time(unit)}};
        },
        [&](std::size_t unit, const Json& made) {
            Timer& timer = m_timers[made.at("rank").get<std::size_t>()];
            timer.node = made.at("node").get<std::string>();
            timer.ranksOnNode = made.at("ranks_on_node").get<std::size_t>();
            timer.cpus = made.at("cpus");
            timer.units.push_back(unit);
            take(unit, made.at("timed"));
        });
}

Json TimedRanks::measuredBy(const std::string& units) const {
    Json rows = Json::array();
    for (const auto& [rank, timer] : m_timers) {
        rows.push_back({{"rank", rank},
                        {"node", timer.node},
                        {"ranks_on_node", timer.ranksOnNode},
                        {"cpus", timer.cpus},
                        {units, timer.units}});
    }
    return rows;
}

void addMeasuredBy(Json& document, const ranks::Ranks& ranks, const Json& measuredBy) {
    if (!ranks.isAlone()) {
        document["measured_by"] = measuredBy;
        document["cpu_choice"] = ranks::nameOf(ranks.place().cpus.choice);
    }
}

} // namespace cdr::experiments
