#pragma once

#include <cdr/platform/worker_pool.h>
#include <cdr/scene/scene.h>
#include <cdr/visibility/sphere_test.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cdr::visibility {

/// The opaque instances of a scene in cells of neighbours, and a tree of boxes over the cells. So culling and binning
/// need not look at instances one by one. It holds a copy of the bounding spheres, cell by cell.
///
/// A cell has kCellSlots places, some of which may hold nothing. Node n of a level of the tree has the nodes
/// [n * kFan, (n + 1) * kFan) of the level below. The lowest level is that of the cells.
class InstanceCells {
  public:
    static constexpr std::size_t kCellSlots = 64;
    static constexpr std::size_t kFan = 16;

    /// Encloses the centres of spheres. Without any, low is above high.
    struct Box {
        glm::dvec3 low{0.0};
        glm::dvec3 high{0.0};
        double radius = 0.0; ///< of the largest
    };

    /// Forgets what it held. Blended instances, and places without one, are left out.
    void build(const scene::Scene& scene, platform::WorkerPool& workers);
    /// Updates instances that changed, were added or were removed; any may be named twice. The time is proportional to
    /// their number. But all is built again once so many have left their cells for so long that this takes less time, and
    /// where most left theirs at once after updates in which they did not.
    void update(const scene::Scene& scene, std::span<const std::uint32_t> changed,
                platform::WorkerPool& workers);

    std::size_t cells() const { return m_held.size(); }
    /// How many instances the scene has, those that are left out included.
    std::size_t instances() const { return m_slotOf.size(); }
    /// Which slots of a cell hold an instance.
    std::uint64_t held(std::size_t cell) const { return m_held[cell]; }
    Spheres spheres(std::size_t cell) const {
        const CellSpheres& spheres = m_spheres[cell];
        return {spheres.x.data(), spheres.y.data(), spheres.z.data(), spheres.radius.data()};
    }
    /// Has the processor fetch a cell's spheres: cells that are tested lie apart, so it does not know to do so by itself.
    void fetchSpheres(std::size_t cell) const {
#if defined(__GNUC__)
        const Spheres spheres = this->spheres(cell);
        for (std::size_t i = 0; i < kCellSlots; i += 8) { // a line of doubles
            __builtin_prefetch(spheres.x + i);
            __builtin_prefetch(spheres.y + i);
            __builtin_prefetch(spheres.z + i);
            __builtin_prefetch(spheres.radius + i);
        }
#else
        static_cast<void>(cell);
#endif
    }
    /// The instances in a cell's slots.
    const std::uint32_t* instancesOf(std::size_t cell) const {
        return &m_instance[cell * kCellSlots];
    }
    /// Lowest level first; the last has kFan nodes at most. None where nothing is held.
    const std::vector<std::vector<Box>>& levels() const {
        return m_levels;
    }
    std::uint64_t bytes() const; ///< of main memory

  private:
    /// The bounding spheres of a cell by slot, together in memory: a test of a cell, and a change in it, touch one place.
    struct CellSpheres {
        std::array<double, kCellSlots> x{};
        std::array<double, kCellSlots> y{};
        std::array<double, kCellSlots> z{};
        std::array<float, kCellSlots> radius{};

        CellSpheres() { radius.fill(scene::kNoRadius); }
    };
    /// Where the instances of a cell may go without leaving it.
    struct Home {
        glm::dvec3 centre{0.0};
        double reach = 0.0;

        bool holds(const glm::dvec3& position) const;
    };
    enum class Mark : std::uint8_t { fresh, stale };
    void resize(std::size_t cells);
    void put(const scene::Instances& instances, std::uint32_t instance, std::size_t slot);
    void place(const scene::Instances& instances, std::uint32_t instance, std::size_t slot);
    bool followInside(const scene::Instances& instances, std::uint32_t instance);
    void follow(const scene::Scene& scene, std::uint32_t instance);
    void leave(std::uint32_t instance);
    void markStale(std::size_t cell) {
        if (m_marks[cell] != Mark::stale) {
            m_marks[cell] = Mark::stale;
            m_stale.push_back(static_cast<std::uint32_t>(cell));
        }
    }
    std::size_t looseSlot();
    Box boxOf(std::size_t cell) const;
    Box boxOfFull(std::size_t cell) const;
    Box boxOver(std::size_t level, std::size_t node) const;
    void makeLevels();
    void refreshBoxes();

    std::vector<CellSpheres> m_spheres;    ///< by cell
    std::vector<std::uint32_t> m_instance; ///< by slot
    std::vector<std::uint32_t> m_slotOf;   ///< by instance
    std::vector<std::uint64_t> m_held;     ///< by cell
    std::vector<Home> m_homes;
    std::vector<std::vector<Box>> m_levels;
    std::vector<std::uint32_t> m_stale; ///< cells whose box is to be made again
    std::vector<Mark> m_marks;          ///< by cell
    std::size_t m_loose = 0; ///< slots taken so far by what left its cell; they are in the last cells
    std::size_t m_builtCells = 0;
    std::uint64_t m_debt = 0;     ///< loose slots that were followed, summed over updates
    std::uint64_t m_massWait = 0; ///< updates after which most may leave their cells and all is built at once
};

} // namespace cdr::visibility
