#pragma once

#include <algorithm>
#include <cmath>

namespace cdr::test {

/// The larger error; infinite for an error that is no finite number, which std::max() would pass over.
inline double worseOf(double worst, double error) {
    return std::isfinite(error) ? std::max(worst, error) : HUGE_VAL;
}

} // namespace cdr::test
