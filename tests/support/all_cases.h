#pragma once

#include <cstddef>
#include <cstdlib>
#include <vector>

namespace cdr::test {

/// Whether tests take all their cases, which tools/check.sh asks for, instead of a sample of them.
inline bool takesAllCases() {
    return std::getenv("CDR_ALL_CASES") != nullptr;
}

/// One of all, another at each turn; all of them where tests take all their cases.
template <typename Value>
std::vector<Value> sampleOf(const std::vector<Value>& all, std::size_t turn) {
    return takesAllCases() ? all : std::vector<Value>{all[turn % all.size()]};
}

} // namespace cdr::test
