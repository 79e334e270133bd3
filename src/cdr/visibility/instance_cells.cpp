#include <cdr/visibility/blended.h>
#include <cdr/visibility/cell_seeds.h>
#include <cdr/visibility/instance_cells.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace cdr::visibility {

namespace {

constexpr std::uint32_t kNoSlot = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kJobCells = 256;

/// Loose slots are tested one by one, which takes about a sixty-fourth of the time that building takes for an
/// instance. So building anew once they were tested so often costs at most what was lost.
constexpr std::uint64_t kDebtPerInstance = 64;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const InstanceCells::Box kNothing{glm::dvec3(kInfinity), glm::dvec3(-kInfinity), 0.0};

void include(InstanceCells::Box& box, const InstanceCells::Box& other) {
    box.low = glm::min(box.low, other.low);
    box.high = glm::max(box.high, other.high);
    box.radius = std::max(box.radius, other.radius);
}

} // namespace

bool InstanceCells::Home::holds(const glm::dvec3& position) const {
    const glm::dvec3 way = glm::abs(position - centre);
    return std::max({way.x, way.y, way.z}) <= reach;
}

void InstanceCells::resize(std::size_t cells) {
    const std::size_t slots = cells * kCellSlots;
    m_x.resize(slots);
    m_y.resize(slots);
    m_z.resize(slots);
    m_radius.resize(slots, scene::kNoRadius);
    m_instance.resize(slots);
    m_held.resize(cells);
    m_isStale.resize(cells);
}

void InstanceCells::put(const scene::Instances& instances, std::uint32_t instance, std::size_t slot) {
    m_x[slot] = instances.x[instance];
    m_y[slot] = instances.y[instance];
    m_z[slot] = instances.z[instance];
    m_radius[slot] = instances.radius[instance];
    m_instance[slot] = instance;
    m_slotOf[instance] = static_cast<std::uint32_t>(slot);
    m_held[slot / kCellSlots] |= std::uint64_t{1} << slot % kCellSlots;
}

void InstanceCells::build(const scene::Scene& scene, host::WorkerPool& workers) {
    *this = {};
    m_slotOf.assign(scene.instances.size(), kNoSlot);
    const std::vector<CellSeed> seeds = sortIntoCells(scene, kCellSlots, workers);
    m_builtCells = (seeds.size() + kCellSlots - 1) / kCellSlots;
    resize(m_builtCells);
    m_homes.resize(m_builtCells);
    m_levels.assign(m_builtCells > 0 ? 1 : 0, std::vector<Box>(m_builtCells));
    const std::size_t jobs = (m_builtCells + kJobCells - 1) / kJobCells;
    workers.run(jobs, [&](std::size_t job, std::size_t) {
        const host::IndexRange range = host::evenRange(m_builtCells, job, jobs);
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

InstanceCells::Box InstanceCells::boxOf(std::size_t cell) const {
    Box box = kNothing;
    for (std::uint64_t held = m_held[cell]; held != 0; held &= held - 1) {
        const std::size_t slot = cell * kCellSlots + static_cast<std::size_t>(std::countr_zero(held));
        const glm::dvec3 centre(m_x[slot], m_y[slot], m_z[slot]);
        include(box, {centre, centre, static_cast<double>(m_radius[slot])});
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

void InstanceCells::markStale(std::size_t cell) {
    if (!m_isStale[cell]) {
        m_isStale[cell] = true;
        m_stale.push_back(static_cast<std::uint32_t>(cell));
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

void InstanceCells::follow(const scene::Scene& scene, std::uint32_t instance) {
    const scene::Instances& instances = scene.instances;
    const std::uint32_t before = m_slotOf[instance];
    const bool isDrawn = instances.radius[instance] != scene::kNoRadius && !isBlended(scene, instance);
    const bool stays =
        isDrawn && before != kNoSlot && m_homes[before / kCellSlots].holds(instances.position(instance));
    if (before != kNoSlot) {
        markStale(before / kCellSlots);
        if (!stays) {
            m_held[before / kCellSlots] &= ~(std::uint64_t{1} << before % kCellSlots);
            m_radius[before] = scene::kNoRadius;
            m_slotOf[instance] = kNoSlot;
        }
    }
    if (isDrawn) {
        const std::size_t slot = stays ? before : looseSlot();
        put(instances, instance, slot);
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
        m_isStale[cell] = false;
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
                           host::WorkerPool& workers) {
    m_slotOf.resize(scene.instances.size(), kNoSlot);
    for (const std::uint32_t instance : changed) {
        follow(scene, instance);
    }
    m_debt += m_loose;
    if (m_debt > kDebtPerInstance * m_slotOf.size()) {
        build(scene, workers);
        return;
    }
    refreshBoxes();
}

std::uint64_t InstanceCells::bytes() const {
    const auto bytesOf = [](const auto& values) { return values.capacity() * sizeof(values[0]); };
    std::uint64_t bytes = bytesOf(m_x) + bytesOf(m_y) + bytesOf(m_z) + bytesOf(m_radius) +
                          bytesOf(m_instance) + bytesOf(m_slotOf) + bytesOf(m_held) + bytesOf(m_homes);
    for (const std::vector<Box>& level : m_levels) {
        bytes += bytesOf(level);
    }
    return bytes;
}

} // namespace cdr::visibility
