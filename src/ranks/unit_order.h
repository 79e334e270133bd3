#pragma once

#include <ranks/ranks.h>

#include <map>
#include <utility>

namespace cdr::ranks {

/// Takes results in any order, and passes them on in the order of their units.
class UnitOrder {
  public:
    void put(std::size_t unit, platform::Bytes made) { m_waiting.emplace(unit, std::move(made)); }

    /// Passes on results up to the first unit that is missing. The memory of each is freed before the next is passed on.
    void handOn(const Ranks::Take& take);

    /// How many were passed on.
    std::size_t done() const { return m_next; }

  private:
    std::map<std::size_t, platform::Bytes> m_waiting;
    std::size_t m_next = 0;
};

} // namespace cdr::ranks
