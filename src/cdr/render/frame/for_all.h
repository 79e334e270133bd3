#pragma once

#include <exception>

namespace cdr::render {

/// Does it for all of a range, also after one for which it throws. Throws the first error once all had their turn.
template <typename Range, typename Action>
void forAll(const Range& range, const Action& action) {
    std::exception_ptr first;
    for (const auto& each : range) {
        try {
            action(*each);
        } catch (...) {
            first = first ? first : std::current_exception();
        }
    }
    if (first) {
        std::rethrow_exception(first);
    }
}

} // namespace cdr::render
