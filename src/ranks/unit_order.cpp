#include <ranks/unit_order.h>

namespace cdr::ranks {

void UnitOrder::handOn(const Ranks::Take& take) {
    while (!m_waiting.empty() && m_waiting.begin()->first == m_next) {
        const auto first = m_waiting.extract(m_waiting.begin());
        ++m_next;
        take(first.key(), first.mapped());
    }
}

} // namespace cdr::ranks
