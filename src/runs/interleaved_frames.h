#pragma once

#include <cdr/render/frame.h>

#include <runs/shuffled_order.h>
#include <runs/timed_ranks.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace cdr::runs {

/// What drawing one frame took.
struct FrameSample {
    double frameMs = 0.0; ///< from the camera until the device is done
    double cullMs = 0.0;
    double binMs = 0.0;
    double cullAndBinMs = 0.0;
    double recordMs = 0.0;
    double executeMs = 0.0;
    double deviceMs = std::numeric_limits<double>::quiet_NaN(); ///< where frames are timed by the device
    double draws = 0.0;
};

/// Times one frame.
FrameSample timed(const std::function<render::FrameStats()>& draw);

/// Modes that draw the same frames in turns, and what each frame took. The order of the modes is shuffled again for
/// each frame, so that what slows the machine for a while slows all modes alike.
class InterleavedFrames {
  public:
    InterleavedFrames(std::size_t modes, std::uint64_t seed);

    /// Draws one frame of every mode.
    void draw(const std::function<FrameSample(std::size_t mode)>& draw) { add(row(draw)); }

    /// Draws `units` frames of every mode, each on some rank. The first rank has them all.
    /// @param draw draws one mode; a rank is given units in ascending order.
    void divide(TimedRanks& ranks, std::size_t units,
                const std::function<FrameSample(std::size_t mode, std::size_t unit)>& draw);

    /// Draws kWarmUp frames that are dropped, on every rank, then `frames` that count, each on some rank.
    /// @param step called before each of them.
    /// @param draw draws a frame of a mode, with Renderer::draw().
    void run(TimedRanks& ranks, std::uint32_t frames, const std::function<void()>& step,
             const std::function<render::FrameStats(std::size_t mode, std::uint32_t frame)>& draw);

    /// The same in this process alone, whatever ranks there are.
    void runAlone(std::uint32_t frames, const std::function<void()>& step,
                  const std::function<render::FrameStats(std::size_t mode, std::uint32_t frame)>& draw);

    /// Drops what was drawn so far.
    void forget();

    /// What was drawn so far.
    output::Json packedSamples() const;
    /// In its place, so many frames of the same modes that another object has packed. std::out_of_range where it has not.
    void takeSamples(const output::Json& packed, std::size_t frames);

    /// A part of each frame of a mode, in the order of the frames.
    std::vector<double> samples(std::size_t mode, double FrameSample::*part) const;
    /// The median of samples().
    double median(std::size_t mode, double FrameSample::*part) const;
    /// A mode's part over another's, frame by frame, so that what slows a whole frame cancels.
    std::vector<double> ratios(std::size_t mode, std::size_t over, double FrameSample::*part) const;

    /// Pipelines compile, memory is touched, caches fill.
    static constexpr std::uint32_t kWarmUp = 2;

  private:
    std::vector<FrameSample> row(const std::function<FrameSample(std::size_t mode)>& draw);
    void add(const std::vector<FrameSample>& row);

    ShuffledOrder m_order;
    std::vector<std::vector<FrameSample>> m_samples; ///< by mode, then frame
};

} // namespace cdr::runs
