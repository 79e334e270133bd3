#include "frame_statistics.h"

#include <cdr/base/enum_names.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cdr::viewer {

namespace {

constexpr base::EnumNames<FrameStage, kFrameStages.size()> kStageNames{
    "stage", {"cull", "split", "bin", "record", "execute", "composite", "present"}};

/// As measure::percentile(), of samples in ascending order, without an allocation.
float percentileOfSorted(const std::vector<float>& sorted, double percent) {
    const double place = percent / 100.0 * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return static_cast<float>(std::lerp(static_cast<double>(sorted[below]),
                                        static_cast<double>(sorted[above]), place - std::floor(place)));
}

} // namespace

std::string_view nameOf(FrameStage stage) {
    return kStageNames.nameOf(stage);
}

FrameStatistics::FrameStatistics(std::size_t window) : m_window(std::max<std::size_t>(window, 1)) {
    for (std::vector<float>& ring : m_rings) {
        ring.resize(m_window);
    }
    m_sorted.reserve(m_window);
}

void FrameStatistics::add(const StageTimes& times) {
    for (std::size_t i = 0; i < kFrameStages.size(); ++i) {
        m_rings[i][m_next] = times.ms[i];
    }
    m_rings.back()[m_next] = std::accumulate(times.ms.begin(), times.ms.end(), 0.0f);
    m_next = (m_next + 1) % m_window;
    m_frames = std::min(m_frames + 1, m_window);
}

void FrameStatistics::clear() {
    m_frames = 0;
    m_next = 0;
}

StageSummary FrameStatistics::summarise(std::size_t series) const {
    if (m_frames == 0) {
        return {};
    }
    const std::vector<float>& ring = m_rings[series];
    m_sorted.assign(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(m_frames));
    std::sort(m_sorted.begin(), m_sorted.end());
    return {.last = ring[(m_next + m_window - 1) % m_window],
            .median = percentileOfSorted(m_sorted, 50.0),
            .p95 = percentileOfSorted(m_sorted, 95.0),
            .p99 = percentileOfSorted(m_sorted, 99.0),
            .max = m_sorted.back()};
}

StageSummary FrameStatistics::summary(FrameStage stage) const {
    return summarise(static_cast<std::size_t>(stage));
}

StageSummary FrameStatistics::total() const {
    return summarise(kSeries - 1);
}

std::span<const float> FrameStatistics::ring(FrameStage stage) const {
    return std::span(m_rings[static_cast<std::size_t>(stage)]).first(m_frames);
}

std::span<const float> FrameStatistics::totalRing() const {
    return std::span(m_rings.back()).first(m_frames);
}

} // namespace cdr::viewer
