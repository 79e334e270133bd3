#pragma once

#include <output/columns.h>
#include <ranks/ranks.h>

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace cdr::runs {

/// The ranks that share what is timed, and which of them timed what.
class TimedRanks {
  public:
    explicit TimedRanks(ranks::Ranks& ranks) : m_ranks(ranks) {}

    bool isFirst() const { return m_ranks.isFirst(); }

    /// Forgets who timed what before, and lets each unit be timed on some rank. The first one takes what came of it, in the
    /// order of the units.
    void forEachUnit(std::size_t count, const std::function<output::Json(std::size_t unit)>& time,
                     const std::function<void(std::size_t unit, const output::Json& timed)>& take);

    /// A row for each rank that timed: its number, its node, how many ranks that node has, and its units.
    /// @param units their name in the row.
    output::Json measuredBy(const std::string& units) const;

  private:
    struct Timer {
        std::string node;
        std::size_t ranksOnNode = 1;
        output::Json cpus;
        std::vector<std::size_t> units;
    };

    ranks::Ranks& m_ranks;
    std::map<std::size_t, Timer> m_timers; ///< by rank
};

/// Adds "measured_by" to a command's document where several ranks timed, and "cpu_choice", how those of the first one's
/// machine came to their processors.
void addMeasuredBy(output::Json& document, const ranks::Ranks& ranks, const output::Json& measuredBy);

} // namespace cdr::runs
