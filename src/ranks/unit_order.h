#pragma once

#include <ranks/ranks.h>

#include <map>

namespace cdr::ranks {

/// Results that arrive in any order, handed on in the order of their units.
class UnitOrder {
  public:
    void put(std::size_t unit, host::Bytes made);

    /// Hands on what has arrived, as far as no earlier unit is missing. Each result goes before the next is handed on.
    void handOn(const Ranks::Take& take);

    /// How many were handed on.
    std::size_t done() const { return m_next; }

  private:
    std::map<std::size_t, host::Bytes> m_waiting;
    std::size_t m_next = 0;
};

} // namespace cdr::ranks
