#include <cdr/platform/vector_clones.h>
#include <cdr/visibility/instance_sets.h>

#include <array>
#include <bit>
#include <cstring>
#include <span>
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

constexpr std::size_t kByte = 8;

/// Two instances, one behind the other. A sum of pairs is the pair of sums, as long as instances are below 2^31.
constexpr std::uint64_t pairOf(std::uint32_t first, std::uint32_t second) {
    return std::bit_cast<std::uint64_t>(std::array{first, second});
}

/// The places of the bits that are set in a byte, the lowest first, two by two.
using BytePlaces = std::array<std::uint64_t, kByte / 2>;

constexpr std::array<BytePlaces, 256> makeBytePlaces() {
    std::array<BytePlaces, 256> all{};
    for (std::uint32_t byte = 0; byte < all.size(); ++byte) {
        std::array<std::uint32_t, kByte> places{};
        std::size_t next = 0;
        for (std::uint32_t bit = 0; bit < kByte; ++bit) {
            if ((byte >> bit & 1u) != 0) {
                places[next++] = bit;
            }
        }
        for (std::size_t i = 0; i < all[byte].size(); ++i) {
            all[byte][i] = pairOf(places[2 * i], places[2 * i + 1]);
        }
    }
    return all;
}

constexpr std::array<BytePlaces, 256> kBytePlaces = makeBytePlaces();

/// Writes the instances of a word of bits, the lowest of which is instance `first`, and returns the end of them. Each byte
/// writes kByte instances, so `out` has room for kWord. There is no branch for each bit, which is faster.
std::uint32_t* drainByBytes(std::uint64_t bits, std::uint32_t first, std::uint32_t* out) {
    for (; bits != 0; bits >>= kByte) {
        const std::uint64_t base = pairOf(first, first);
        const BytePlaces& places = kBytePlaces[bits % kBytePlaces.size()];
        for (std::size_t i = 0; i < places.size(); ++i) {
            const std::uint64_t pair = base + places[i];
            std::memcpy(out + 2 * i, &pair, sizeof(pair));
        }
        out += std::popcount(bits % kBytePlaces.size());
        first += kByte;
    }
    return out;
}

std::uint32_t* drainByBits(std::uint64_t bits, std::uint32_t first, std::uint32_t* out) {
    for (; bits != 0; bits &= bits - 1) {
        *out++ = first + static_cast<std::uint32_t>(std::countr_zero(bits));
    }
    return out;
}

CDR_VECTOR_CLONES
void drainWords(std::uint64_t* words, platform::IndexRange range, std::span<std::uint32_t> out) {
    std::uint32_t* next = out.data();
    const std::uint32_t* const end = next + out.size();
    for (std::size_t word = range.begin; word < range.end; ++word) {
        const auto first = static_cast<std::uint32_t>(word * InstanceSets::kWord);
        const std::uint64_t bits = std::exchange(words[word], 0);
        const auto room = static_cast<std::size_t>(end - next);
        next = room >= InstanceSets::kWord ? drainByBytes(bits, first, next) : drainByBits(bits, first, next);
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

void InstanceSets::drain(std::size_t bucket, platform::IndexRange words, std::span<std::uint32_t> out) {
    if (!m_sets[bucket].empty()) {
        drainWords(m_sets[bucket].data(), words, out);
    }
}

} // namespace cdr::visibility
