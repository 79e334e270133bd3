#include <cdr/measure/truth/triangle_bvh_builder.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

namespace cdr::measure {

namespace {

struct Bin {
    Bounds bounds;
    std::uint32_t count = 0;
};

float halfArea(const Bounds& bounds) {
    const glm::vec3 size = glm::max(bounds.upper - bounds.lower, 0.0f);
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

/// Where along an axis the centres lie, and which bin each falls into.
struct BinAxis {
    int axis;
    float lower;
    float binsPerUnit;
    std::size_t bins;

    std::size_t bin(const glm::vec3& centre) const {
        return std::min(static_cast<std::size_t>((centre[axis] - lower) * binsPerUnit), bins - 1);
    }
};

/// The number of leading bins that go to the first child at the least cost; none when all lie in one bin.
template <std::size_t N>
std::optional<std::size_t> cheapestCut(const std::array<Bin, N>& bins) {
    std::array<float, N> costBehind{};
    Bin behind;
    for (std::size_t i = N - 1; i > 0; --i) {
        behind.bounds.add(bins[i].bounds);
        behind.count += bins[i].count;
        costBehind[i] = behind.count ? halfArea(behind.bounds) * static_cast<float>(behind.count) : -1.0f;
    }
    std::optional<std::size_t> best;
    float bestCost = std::numeric_limits<float>::infinity();
    Bin before;
    for (std::size_t i = 1; i < N; ++i) {
        before.bounds.add(bins[i - 1].bounds);
        before.count += bins[i - 1].count;
        if (before.count == 0 || costBehind[i] < 0.0f) {
            continue;
        }
        const float cost = halfArea(before.bounds) * static_cast<float>(before.count) + costBehind[i];
        if (cost < bestCost) {
            bestCost = cost;
            best = i;
        }
    }
    return best;
}

} // namespace

TriangleBvh::Builder::Builder(const std::vector<Triangle>& triangles, float pad)
    : order(triangles.size()),
      m_pad(pad) {
    std::iota(order.begin(), order.end(), 0u);
    m_bounds.reserve(triangles.size());
    m_centres.reserve(triangles.size());
    for (const Triangle& triangle : triangles) {
        Bounds bounds;
        for (const glm::vec3& corner : triangle) {
            bounds.add(corner);
        }
        m_bounds.push_back(bounds);
        m_centres.push_back(bounds.lower * 0.5f + bounds.upper * 0.5f);
    }
    if (triangles.empty()) {
        return;
    }
    nodes.reserve(triangles.size());
    nodes.emplace_back();
    std::vector<Task> open{{0, 0, static_cast<std::uint32_t>(triangles.size()), 0}};
    while (!open.empty()) {
        const Task task = open.back();
        open.pop_back();
        buildNode(task, open);
    }
}

void TriangleBvh::Builder::buildNode(const Task& task, std::vector<Task>& open) {
    Bounds bounds;
    for (std::uint32_t i = task.begin; i < task.end; ++i) {
        bounds.add(m_bounds[order[i]]);
    }
    Node& node = nodes[task.node];
    node.corners = {bounds.lower - m_pad, bounds.upper + m_pad};
    if (task.end - task.begin <= kLeafTriangles) {
        node.first = task.begin;
        node.count = task.end - task.begin;
        return;
    }
    const std::uint32_t middle = split(task);
    const auto child = static_cast<std::uint32_t>(nodes.size());
    node.first = child;
    node.count = 0;
    nodes.resize(nodes.size() + 2); // ends the life of `node`
    open.push_back({child, task.begin, middle, task.depth + 1});
    open.push_back({child + 1, middle, task.end, task.depth + 1});
}

std::uint32_t TriangleBvh::Builder::split(const Task& task) {
    Bounds centres;
    for (std::uint32_t i = task.begin; i < task.end; ++i) {
        centres.add(m_centres[order[i]]);
    }
    const glm::vec3 size = centres.upper - centres.lower;
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const float binsPerUnit = static_cast<float>(kBins) / size[axis];
    if (task.depth >= kMedianDepth || !std::isfinite(binsPerUnit)) {
        return splitAtMedian(task, axis);
    }
    const BinAxis binAxis{axis, centres.lower[axis], binsPerUnit, kBins};
    std::array<Bin, kBins> bins;
    for (std::uint32_t i = task.begin; i < task.end; ++i) {
        Bin& bin = bins[binAxis.bin(m_centres[order[i]])];
        bin.bounds.add(m_bounds[order[i]]);
        ++bin.count;
    }
    const std::optional<std::size_t> cut = cheapestCut(bins);
    if (!cut) {
        return splitAtMedian(task, axis);
    }
    const auto middle =
        std::partition(order.begin() + task.begin, order.begin() + task.end,
                       [&](std::uint32_t triangle) { return binAxis.bin(m_centres[triangle]) < *cut; });
    return static_cast<std::uint32_t>(middle - order.begin());
}

std::uint32_t TriangleBvh::Builder::splitAtMedian(const Task& task, int axis) {
    const std::uint32_t middle = task.begin + (task.end - task.begin) / 2;
    std::nth_element(
        order.begin() + task.begin, order.begin() + middle, order.begin() + task.end,
        [&](std::uint32_t a, std::uint32_t b) { return m_centres[a][axis] < m_centres[b][axis]; });
    return middle;
}

} // namespace cdr::measure
