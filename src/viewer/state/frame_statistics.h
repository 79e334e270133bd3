#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace cdr::viewer {

/// The parts of a frame, in the order in which they come about.
enum class FrameStage : std::uint8_t { cull, split, bin, record, execute, composite, present };
inline constexpr std::array kFrameStages{FrameStage::cull,   FrameStage::split,   FrameStage::bin,
                                         FrameStage::record, FrameStage::execute, FrameStage::composite,
                                         FrameStage::present};
std::string_view nameOf(FrameStage stage);

/// How long each part of a frame took, milliseconds.
struct StageTimes {
    std::array<float, kFrameStages.size()> ms{};

    float& operator[](FrameStage stage) { return ms[static_cast<std::size_t>(stage)]; }
    float operator[](FrameStage stage) const { return ms[static_cast<std::size_t>(stage)]; }
};

/// Of the frames in the window, milliseconds; percentiles as measure::percentile() has them.
struct StageSummary {
    float last = 0.0f;
    float median = 0.0f;
    float p95 = 0.0f;
    float p99 = 0.0f;
    float max = 0.0f;
};

/// The last frames' times. Allocates when made, never after.
class FrameStatistics {
  public:
    /// @param window frames that are kept, at least 1.
    explicit FrameStatistics(std::size_t window = 240);

    void add(const StageTimes& times);
    void clear();

    std::size_t frames() const { return m_frames; } ///< at most the window
    /// All zero without a frame.
    StageSummary summary(FrameStage stage) const { return summarise(static_cast<std::size_t>(stage)); }
    /// Of all parts together, frame by frame.
    StageSummary total() const { return summarise(kSeries - 1); }

    /// The kept frames' times as a ring: the oldest is at oldest(), what follows wraps around.
    std::span<const float> ring(FrameStage stage) const;
    std::span<const float> totalRing() const { return std::span(m_rings.back()).first(m_frames); }
    std::size_t oldest() const { return m_frames < m_window ? 0 : m_next; }

  private:
    static constexpr std::size_t kSeries = kFrameStages.size() + 1; ///< the last one is the total
    StageSummary summarise(std::size_t series) const;

    std::size_t m_window;
    std::size_t m_frames = 0;
    std::size_t m_next = 0;
    std::array<std::vector<float>, kSeries> m_rings;
    mutable std::vector<float> m_sorted; ///< scratch
};

} // namespace cdr::viewer
