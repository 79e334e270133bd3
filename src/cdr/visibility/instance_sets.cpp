#include <cdr/platform/vector_clones.h>
#include <cdr/visibility/instance_sets.h>

#include <bit>
#include <utility>

namespace cdr::visibility {

namespace {

CDR_VECTOR_CLONES
void addBits(const std::uint32_t* instances, std::uint64_t slots, std::uint64_t* words) {
    const auto add = [words](std::uint32_t instance) {
        words[instance / InstanceSets::kWord] |= std::uint64_t{1} << instance % InstanceSets::kWord;
    };
    if (slots == ~std::uint64_t{0}) {
        for (std::size_t slot = 0; slot < InstanceSets::kWord; ++slot) {
            add(instances[slot]);
        }
        return;
    }
    for (; slots != 0; slots &= slots - 1) {
        add(instances[std::countr_zero(slots)]);
    }
}

CDR_VECTOR_CLONES
std::size_t countBits(const std::uint64_t* words, std::size_t count) {
    std::size_t bits = 0;
    for (std::size_t word = 0; word < count; ++word) {
        bits += static_cast<std::size_t>(std::popcount(words[word]));
    }
    return bits;
}

CDR_VECTOR_CLONES
void drainBits(std::uint64_t* words, platform::IndexRange range, std::uint32_t* out) {
    for (std::size_t word = range.begin; word < range.end; ++word) {
        const auto first = static_cast<std::uint32_t>(word * InstanceSets::kWord);
        for (std::uint64_t bits = std::exchange(words[word], 0); bits != 0; bits &= bits - 1) {
            *out++ = first + static_cast<std::uint32_t>(std::countr_zero(bits));
        }
    }
}

} // namespace

void InstanceSets::resize(std::size_t buckets, std::size_t step, std::size_t instances) {
    m_words = (instances + kWord - 1) / kWord;
    m_sets.resize(buckets);
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
        m_sets[bucket].resize(bucket % step == 0 ? m_words : 0);
    }
}

void InstanceSets::add(std::size_t bucket, const std::uint32_t* instances, std::uint64_t slots) {
    addBits(instances, slots, m_sets[bucket].data());
}

void InstanceSets::merge(InstanceSets& other, std::size_t bucket, platform::IndexRange words) {
    if (m_sets[bucket].empty()) {
        return;
    }
    for (std::size_t word = words.begin; word < words.end; ++word) {
        m_sets[bucket][word] |= std::exchange(other.m_sets[bucket][word], 0);
    }
}

std::size_t InstanceSets::count(std::size_t bucket, platform::IndexRange words) const {
    return m_sets[bucket].empty() ? 0 : countBits(m_sets[bucket].data() + words.begin, words.size());
}

void InstanceSets::drain(std::size_t bucket, platform::IndexRange words, std::uint32_t* out) {
    if (!m_sets[bucket].empty()) {
        drainBits(m_sets[bucket].data(), words, out);
    }
}

std::uint64_t InstanceSets::bytes() const {
    std::uint64_t words = 0;
    for (const std::vector<std::uint64_t>& set : m_sets) {
        words += set.capacity();
    }
    return words * sizeof(std::uint64_t);
}

} // namespace cdr::visibility
