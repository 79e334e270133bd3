#pragma once

#include <cdr/platform/worker_pool.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cdr::visibility {

/// A set of instances for each bucket of DrawLists, a bit for each instance of the scene. Instances are put in in any
/// order and come out in order. Worth its scan where many are put in.
class InstanceSets {
  public:
    /// Instances whose bits share a word.
    static constexpr std::size_t kWord = 64;

    /// Room for instances [0, instances) in `buckets` sets, each `step`-th of which is used. All were empty, and are.
    void resize(std::size_t buckets, std::size_t step, std::size_t instances);

    void add(std::size_t bucket, std::uint32_t instance) {
        m_sets[bucket][instance / kWord] |= std::uint64_t{1} << instance % kWord;
    }
    /// Adds the instances of a cell's slots.
    void add(std::size_t bucket, const std::uint32_t* instances, std::uint64_t slots);
    std::size_t buckets() const { return m_sets.size(); }
    std::size_t words() const { return m_words; }

    /// Adds what the other holds in a range of words, and empties the other there.
    void merge(InstanceSets& other, std::size_t bucket, platform::IndexRange words);
    std::size_t count(std::size_t bucket, platform::IndexRange words) const;
    /// Writes the instances of a range of words in ascending order, and empties it.
    /// @param out as many as count() says.
    void drain(std::size_t bucket, platform::IndexRange words, std::span<std::uint32_t> out);

  private:
    std::vector<std::vector<std::uint64_t>> m_sets;
    std::size_t m_words = 0;
};

} // namespace cdr::visibility
