#pragma once

#include <cstdlib>

namespace cdr::test {

/// Whether tests take all their cases, which tools/check.sh asks for, instead of a sample of them.
inline bool takesAllCases() {
    return std::getenv("CDR_ALL_CASES") != nullptr;
}

} // namespace cdr::test
