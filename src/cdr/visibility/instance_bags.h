#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cdr::visibility {

/// The instances of each bucket of DrawLists, in any order, to be sorted. Worth it where few of a scene's instances are
/// put in.
class InstanceBags {
  public:
    /// All were empty, and are.
    void resize(std::size_t buckets) { m_bags.resize(buckets); }

    void add(std::size_t bucket, std::uint32_t instance) { m_bags[bucket].push_back(instance); }
    /// Adds the instances of a cell's slots.
    void add(std::size_t bucket, const std::uint32_t* instances, std::uint64_t slots);

    std::size_t count(std::size_t bucket) const { return m_bags[bucket].size(); }
    /// Takes what another holds.
    void merge(InstanceBags& other, std::size_t bucket);
    /// Writes the instances of a bucket in ascending order, in time by their number, and empties it.
    /// @param instances that the scene has.
    void drain(std::size_t bucket, std::size_t instances, std::uint32_t* out);

  private:
    std::vector<std::vector<std::uint32_t>> m_bags;
    std::vector<std::uint32_t> m_scratch;
};

} // namespace cdr::visibility
