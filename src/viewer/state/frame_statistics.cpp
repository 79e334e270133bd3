#include "frame_statistics.h"

#include <cdr/base/enum_names.h>
#include <cdr/measure/statistics/statistics.h>

#include <algorithm>
#include <numeric>

namespace cdr::viewer {

namespace {

constexpr base::EnumNames<FrameStage, kFrameStages.size()> kStageNames{
    "stage", {"cull", "split", "bin", "record", "execute", "composite", "present"}};

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
    const auto percentile = [&](double percent) {
        return static_cast<float>(measure::percentileOfSorted(m_sorted, percent));
    };
    return {.last = ring[(m_next + m_window - 1) % m_window],
            .median = percentile(50.0),
            .p95 = percentile(95.0),
            .p99 = percentile(99.0),
            .max = m_sorted.back()};
}

std::span<const float> FrameStatistics::ring(FrameStage stage) const {
    return std::span(m_rings[static_cast<std::size_t>(stage)]).first(m_frames);
}

} // namespace cdr::viewer
