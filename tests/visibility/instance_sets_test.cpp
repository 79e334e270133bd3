#include <cdr/visibility/instance_sets.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <span>
#include <vector>

namespace {

using cdr::visibility::InstanceSets;

constexpr std::uint32_t kUntouched = 0xffffffff;

/// Drains the words from `begin` on into the middle of a larger piece of memory, all of which is returned.
std::vector<std::uint32_t> drained(const std::vector<std::uint32_t>& instances, std::size_t begin) {
    constexpr std::size_t kInstances = 1000; // the last word is not full
    InstanceSets sets;
    sets.resize(1, 1, kInstances);
    for (const std::uint32_t instance : instances) {
        sets.add(0, instance);
    }
    const cdr::platform::IndexRange words{begin, sets.words()};
    const std::size_t count = sets.count(0, words);
    std::vector<std::uint32_t> memory(count + 32, kUntouched);
    sets.drain(0, words, std::span(memory).subspan(16, count));
    EXPECT_EQ(sets.count(0, words), 0u);
    return memory;
}

std::vector<std::uint32_t> wanted(const std::vector<std::uint32_t>& instances, std::size_t begin) {
    std::vector<std::uint32_t> memory(16, kUntouched);
    std::copy_if(instances.begin(), instances.end(), std::back_inserter(memory),
                 [&](std::uint32_t instance) { return instance >= begin * InstanceSets::kWord; });
    memory.insert(memory.end(), 16, kUntouched);
    return memory;
}

TEST(InstanceSetsTest, ComeOutInOrderAndNothingElseIsWritten) {
    std::vector<std::uint32_t> all(1000);
    std::iota(all.begin(), all.end(), 0u);
    std::mt19937 random(2013); // NOLINT(cert-msc32-c,cert-msc51-cpp): the same numbers each time
    for (const std::size_t count : {0u, 1u, 7u, 60u, 500u, 997u, 1000u}) {
        std::vector<std::uint32_t> some = all;
        std::shuffle(some.begin(), some.end(), random);
        some.resize(count);
        std::sort(some.begin(), some.end());
        for (const std::size_t begin : {0u, 3u, 15u}) {
            EXPECT_EQ(drained(some, begin), wanted(some, begin)) << count << " from word " << begin;
        }
    }
}

} // namespace
