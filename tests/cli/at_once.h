#pragma once

#include "../support/all_cases.h"

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace cdr::cli_test {

/// How many programs run at once: one for each processor where all cases are taken, else one.
inline std::size_t programsAtOnce() {
    return test::takesAllCases() ? std::max(std::thread::hardware_concurrency(), 1u) : 1;
}

/// Calls run(i) for each i below `count`, on a thread of its own, and returns when all have returned.
template <typename Run>
void runAtOnce(std::size_t count, const Run& run) {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < count; ++i) {
        threads.emplace_back([&run, i] { run(i); });
    }
}

} // namespace cdr::cli_test
