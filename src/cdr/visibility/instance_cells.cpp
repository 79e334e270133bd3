#include <cdr/visibility/blended.h>
#include <cdr/visibility/cell_seeds.h>
#include <cdr/visibility/instance_cells.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

namespace cdr::visibility {

namespace {

constexpr std::uint32_t kNoSlot = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kJobCells = 256;
/// Far enough ahead that memory answers in time.
constexpr std::size_t kPrefetched = 16;

/// Loose slots are tested one by one, which takes about a sixty-fourth of the time that building takes for an
/// instance. So building again once they were tested so often costs at most what was lost.
constexpr std::uint64_t kDebtPerInstance = 64;

/// After so many updates, sorting costs at most what testing all one by one took in each of them.
constexpr std::uint64_t kUpdatesBetweenSorts = kDebtPerInstance;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const InstanceCells::Box kNothing{glm::dvec3(kInfinity), glm::dvec3(-kInfinity), 0.0};

void include(InstanceCells::Box& box, const InstanceCells::Box& other) {
    box.low = glm::min(box.low, other.low);
    box.high = glm::max(box.high, other.high);
    box.radius = std::max(box.radius, other.radius);
}

/// The least and the largest of a cell's values. Four at a time, which compilers turn into vectors.
template <typename Value>
std::pair<Value, Value> endsOf(const std::array<Value, InstanceCells::kCellSlots>& values) {
    constexpr std::size_t kLanes = 4;
    std::array<Value, kLanes> low{values[0], values[1], values[2], values[3]};
    std::array<Value, kLanes> high = low;
    for (std::size_t i = kLanes; i < values.size(); i += kLanes) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const Value value = values[i + lane];
            low[lane] = value < low[lane] ? value : low[lane];
            high[lane] = value > high[lane] ? value : high[lane];
        }
    }
    return {*std::min_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end())};
}

} // namespace

bool InstanceCells::Home::holds(const glm::dvec3& position) const {
    const glm::dvec3 way = glm::abs(position - centre);
    return way.x <= reach && way.y <= reach && way.z <= reach;
}

void InstanceCells::resize(std::size_t cells) {
    m_spheres.resize(cells);
    m_instance.resize(cells * kCellSlots);
    m_held.resize(cells);
    m_marks.resize(cells);
}

void InstanceCells::place(const scene::Instances& instances, std::uint32_t instance, std::size_t slot) {
    CellSpheres& spheres = m_spheres[slot / kCellSlots];
    const std::size_t at = slot % kCellSlots;
    spheres.x[at] = instances.x[instance];
    spheres.y[at] = instances.y[instance];
    spheres.z[at] = instances.z[instance];
    spheres.radius[at] = instances.radius[instance];
}

void InstanceCells::put(const scene::Instances& instances, std::uint32_t instance, std::size_t slot) {
    place(instances, instance, slot);
    m_instance[slot] = instance;
    m_slotOf[instance] = static_cast<std::uint32_t>(slot);
    m_held[slot / kCellSlots] |= std::uint64_t{1} << slot % kCellSlots;
}

void InstanceCells::build(const scene::Scene& scene, platform::WorkerPool& workers) {
    *this = {};
    m_slotOf.assign(scene.instances.size(), kNoSlot);
    const std::vector<CellSeed> seeds = sortIntoCells(scene, kCellSlots, workers);
    m_builtCells = (seeds.size() + kCellSlots - 1) / kCellSlots;
    resize(m_builtCells);
    m_homes.resize(m_builtCells);
    m_levels.assign(m_builtCells > 0 ? 1 : 0, std::vector<Box>(m_builtCells));
    const std::size_t jobs = (m_builtCells + kJobCells - 1) / kJobCells;
    workers.run(jobs, [&](std::size_t job, std::size_t) {
        const platform::IndexRange range = platform::evenRange(m_builtCells, job, jobs);
        for (std::size_t cell = range.begin; cell < range.end; ++cell) {
            const std::size_t end = std::min((cell + 1) * kCellSlots, seeds.size());
            for (std::size_t slot = cell * kCellSlots; slot < end; ++slot) {
                put(scene.instances, seeds[slot].instance, slot);
            }
            const Box box = boxOf(cell);
            const glm::dvec3 size = box.high - box.low;
            m_levels[0][cell] = box;
            m_homes[cell] = {.centre = box.low + 0.5 * size,
                             .reach = std::max({size.x, size.y, size.z}) + box.radius};
        }
    });
    makeLevels();
}

InstanceCells::Box InstanceCells::boxOfFull(std::size_t cell) const {
    const CellSpheres& spheres = m_spheres[cell];
    const auto [lowX, highX] = endsOf(spheres.x);
    const auto [lowY, highY] = endsOf(spheres.y);
    const auto [lowZ, highZ] = endsOf(spheres.z);
    return {{lowX, lowY, lowZ}, {highX, highY, highZ}, static_cast<double>(endsOf(spheres.radius).second)};
}

InstanceCells::Box InstanceCells::boxOf(std::size_t cell) const {
    if (m_held[cell] == ~std::uint64_t{0}) {
        return boxOfFull(cell);
    }
    const CellSpheres& spheres = m_spheres[cell];
    Box box = kNothing;
    for (std::uint64_t held = m_held[cell]; held != 0; held &= held - 1) {
        const auto at = static_cast<std::size_t>(std::countr_zero(held));
        const glm::dvec3 centre(spheres.x[at], spheres.y[at], spheres.z[at]);
        include(box, {centre, centre, static_cast<double>(spheres.radius[at])});
    }
    return box;
}

InstanceCells::Box InstanceCells::boxOver(std::size_t level, std::size_t node) const {
    const std::vector<Box>& below = m_levels[level - 1];
    Box box = kNothing;
    for (std::size_t child = node * kFan; child < std::min((node + 1) * kFan, below.size()); ++child) {
        include(box, below[child]);
    }
    return box;
}

void InstanceCells::makeLevels() {
    m_levels.resize(std::min<std::size_t>(m_levels.size(), 1));
    while (!m_levels.empty() && m_levels.back().size() > kFan) {
        const std::size_t level = m_levels.size();
        std::vector<Box>& boxes = m_levels.emplace_back((m_levels.back().size() + kFan - 1) / kFan);
        for (std::size_t node = 0; node < boxes.size(); ++node) {
            boxes[node] = boxOver(level, node);
        }
    }
}

std::size_t InstanceCells::looseSlot() {
    const std::size_t slot = m_builtCells * kCellSlots + m_loose++;
    if (slot / kCellSlots == cells()) {
        resize(cells() + 1);
        m_homes.push_back({.centre = glm::dvec3(0.0), .reach = kInfinity});
        if (m_levels.empty()) {
            m_levels.emplace_back();
        }
        m_levels[0].push_back(kNothing);
    }
    return slot;
}

void InstanceCells::leave(std::uint32_t instance) {
    const std::uint32_t before = m_slotOf[instance];
    markStale(before / kCellSlots);
    m_held[before / kCellSlots] &= ~(std::uint64_t{1} << before % kCellSlots);
    m_spheres[before / kCellSlots].radius[before % kCellSlots] = scene::kNoRadius;
    m_slotOf[instance] = kNoSlot;
}

/// What an opaque instance is nearly always: drawn, and in its cell, as before. False where it is not, and then nothing changed.
inline bool InstanceCells::followInside(const scene::Instances& instances, std::uint32_t instance) {
    const std::uint32_t slot = m_slotOf[instance];
    if (slot == kNoSlot || instances.radius[instance] == scene::kNoRadius ||
        !m_homes[slot / kCellSlots].holds(instances.position(instance))) {
        return false;
    }
    place(instances, instance, slot);
    markStale(slot / kCellSlots);
    return true;
}

void InstanceCells::follow(const scene::Scene& scene, std::uint32_t instance) {
    const bool isDrawn = scene.instances.radius[instance] != scene::kNoRadius && !isBlended(scene, instance);
    if (isDrawn && followInside(scene.instances, instance)) {
        return;
    }
    if (m_slotOf[instance] != kNoSlot) {
        leave(instance);
    }
    if (isDrawn) {
        const std::size_t slot = looseSlot();
        put(scene.instances, instance, slot);
        markStale(slot / kCellSlots);
    }
}

void InstanceCells::refreshBoxes() {
    std::size_t nodes = m_levels.empty() ? 0 : m_levels[0].size();
    bool hasGrown = false;
    for (std::size_t level = 1; level < m_levels.size(); ++level) {
        nodes = (nodes + kFan - 1) / kFan;
        hasGrown = hasGrown || m_levels[level].size() != nodes;
    }
    hasGrown = hasGrown || nodes > kFan;
    for (const std::uint32_t cell : m_stale) {
        m_levels[0][cell] = boxOf(cell);
        m_marks[cell] = Mark::fresh;
    }
    if (hasGrown) {
        makeLevels();
        m_stale.clear();
        return;
    }
    for (std::size_t level = 1; level < m_levels.size(); ++level) {
        for (std::uint32_t& node : m_stale) {
            node /= static_cast<std::uint32_t>(kFan);
        }
        std::sort(m_stale.begin(), m_stale.end());
        m_stale.erase(std::unique(m_stale.begin(), m_stale.end()), m_stale.end());
        for (const std::uint32_t node : m_stale) {
            m_levels[level][node] = boxOver(level, node);
        }
    }
    m_stale.clear();
}

void InstanceCells::update(const scene::Scene& scene, std::span<const std::uint32_t> changed,
                           platform::WorkerPool& workers) {
    if (scene.instances.size() < m_slotOf.size()) { // another world took the place of the one before
        build(scene, workers);
        return;
    }
    m_slotOf.resize(scene.instances.size(), kNoSlot);
    const bool mayBlend = std::ranges::any_of(scene.materials, [](const scene::Material& material) {
        return material.alphaMode == scene::AlphaMode::blend;
    });
    const std::size_t looseBefore = m_loose;
    for (std::size_t i = 0; i < changed.size(); ++i) {
        // Neighbours in the scene lie scattered over the cells, where the hardware foresees nothing.
        const std::uint32_t soon = m_slotOf[changed[std::min(i + kPrefetched, changed.size() - 1)]];
        if (soon != kNoSlot) {
            const CellSpheres& spheres = m_spheres[soon / kCellSlots];
            __builtin_prefetch(&spheres.x[soon % kCellSlots], 1);
            __builtin_prefetch(&spheres.y[soon % kCellSlots], 1);
            __builtin_prefetch(&spheres.z[soon % kCellSlots], 1);
            __builtin_prefetch(&spheres.radius[soon % kCellSlots], 1);
        }
        if (mayBlend || !followInside(scene.instances, changed[i])) {
            follow(scene, changed[i]);
        }
    }
    m_debt += m_loose;
    m_massWait -= std::min<std::uint64_t>(m_massWait, 1);
    // No edit may follow that adds to the debt.
    const bool isMass = m_loose - looseBefore > m_slotOf.size() / 2;
    if ((isMass && m_massWait == 0) || m_debt > kDebtPerInstance * m_slotOf.size()) {
        build(scene, workers);
        m_massWait = kUpdatesBetweenSorts;
        return;
    }
    refreshBoxes();
}

std::uint64_t InstanceCells::bytes() const {
    const auto bytesOf = [](const auto& values) { return values.capacity() * sizeof(values[0]); };
    std::uint64_t bytes =
        bytesOf(m_spheres) + bytesOf(m_instance) + bytesOf(m_slotOf) + bytesOf(m_held) + bytesOf(m_homes);
    for (const std::vector<Box>& level : m_levels) {
        bytes += bytesOf(level);
    }
    return bytes;
}

} // namespace cdr::visibility
