#include <cdr/visibility/instance_bags.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace cdr::visibility {

namespace {

/// Two digits do for 16 million instances.
constexpr std::size_t kDigitBits = 12;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
/// Below this the digits' places take longer than comparing.
constexpr std::size_t kMinSorted = 1024;

void sortByDigit(const std::vector<std::uint32_t>& from, std::size_t shift, std::uint32_t* to) {
    const auto digitOf = [shift](std::uint32_t instance) { return instance >> shift & (kDigits - 1); };
    std::array<std::uint32_t, kDigits> places{};
    for (const std::uint32_t instance : from) {
        ++places[digitOf(instance)];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& place : places) {
        sum += std::exchange(place, sum);
    }
    for (const std::uint32_t instance : from) {
        to[places[digitOf(instance)]++] = instance;
    }
}

} // namespace

void InstanceBags::add(std::size_t bucket, const std::uint32_t* instances, std::uint64_t slots) {
    std::vector<std::uint32_t>& bag = m_bags[bucket];
    const std::size_t before = bag.size();
    bag.resize(before + static_cast<std::size_t>(std::popcount(slots)));
    std::uint32_t* out = bag.data() + before;
    for (; slots != 0; slots &= slots - 1) {
        *out++ = instances[std::countr_zero(slots)];
    }
}

void InstanceBags::merge(InstanceBags& other, std::size_t bucket) {
    std::vector<std::uint32_t>& from = other.m_bags[bucket];
    m_bags[bucket].insert(m_bags[bucket].end(), from.begin(), from.end());
    from.clear();
}

void InstanceBags::drain(std::size_t bucket, std::size_t instances, std::uint32_t* out) {
    std::vector<std::uint32_t>& bag = m_bags[bucket];
    if (bag.size() < kMinSorted) {
        std::sort(bag.begin(), bag.end());
        std::copy(bag.begin(), bag.end(), out);
    } else {
        std::size_t shift = 0;
        for (; instances >> shift >= kDigits; shift += kDigitBits) {
            m_scratch.resize(bag.size());
            sortByDigit(bag, shift, m_scratch.data());
            bag.swap(m_scratch);
        }
        sortByDigit(bag, shift, out);
    }
    bag.clear();
}

} // namespace cdr::visibility
