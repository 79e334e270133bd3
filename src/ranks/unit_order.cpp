#include <ranks/unit_order.h>

#include <utility>

namespace cdr::ranks {

void UnitOrder::put(std::size_t unit, platform::Bytes made) {
    m_waiting.emplace(unit, std::move(made));
}

void UnitOrder::handOn(const Ranks::Take& take) {
    while (!m_waiting.empty() && m_waiting.begin()->first == m_next) {
        const auto first = m_waiting.extract(m_waiting.begin());
        ++m_next;
        take(first.key(), first.mapped());
    }
}

} // namespace cdr::ranks
