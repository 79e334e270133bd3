#pragma once

#include "soak_input.h"

#include <viewer/session/player.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cdr::viewer {

/// Plays seeded random input, one step per frame of the interface, as fast as frames come, and watches the
/// memory. Memory is always read in the same view, first after a warm-up, then at each tenth of the rest. What
/// the Vulkan driver keeps for later depends on what it drew last, and differs by tens of megabytes. For instance llvmpipe
/// keeps up to 36 MiB of bins for each of the passes that it once worked on together. So the renderer's device is
/// made again for each measurement.
class Soak : public Player {
  public:
    /// The share of the steps that warms up.
    static constexpr double kWarmUp = 0.25;
    /// Times the memory is measured after that, evenly apart, the last at the end. A soak of less than a minute measures
    /// less often: its memory says nothing.
    static constexpr std::uint64_t kMeasurements = 10;
    static constexpr std::uint64_t kShortMeasurements = 4;
    /// The least of so many measurements counts at the beginning and at the end, since noise only adds.
    static constexpr std::ptrdiff_t kCompared = 4;

    /// @param seconds' worth of input.
    Soak(double seconds, SoakOptions input);

    /// Plays a step, if the renderer has taken the last one.
    PlayerState step(const PlayedViewer& viewer) override;
    /// "soak: 1800 steps, ...", one line.
    std::string report() const;
    /// By how many percent memory grew from the warm-up to the end: what is allocated or what is resident, whichever grew more.
    /// Empty where the soak ended early.
    std::optional<double> growth() const;

  private:
    /// Playing, then at rest on the device as it was played on, then on a new one.
    enum class Phase { playing, resting, renewed };
    struct Memory {
        std::uint64_t before = 0; ///< bytes resident before the device was made again
        std::uint64_t resident = 0;
        std::uint64_t allocated = 0;
    };
    /// The view in which memory is measured.
    struct Home {
        ViewSettings settings;
        ResizeInput size;
    };
    bool isDone() const { return m_memory.size() > m_measurements; }
    /// The least of the first measurements and of the last.
    struct Change {
        std::uint64_t warm = 0;
        std::uint64_t end = 0;

        double percent() const;
    };
    Change changeOf(std::uint64_t Memory::*bytes) const;
    std::string growthOf(std::uint64_t Memory::*bytes) const;
    void enter(Phase phase, const Session& session);
    void play(const PlayedViewer& viewer);
    void rest(Window& window, const Session& session, ViewerModel& model);
    void measure(Window& window, Session& session, ViewerModel& model);
    std::uint64_t stepsBeforeRest() const; ///< played before the next measurement

    std::uint64_t m_steps;
    std::uint64_t m_measurements; ///< after the warm-up
    std::uint64_t m_rest;         ///< pictures, and then frames, that are drawn before memory is measured
    std::uint64_t m_done = 0;
    std::uint64_t m_restedFrames = 0;
    SoakInput m_input;
    std::optional<Home> m_home; ///< what the viewer showed at the first step
    std::uint64_t m_minimisedFor = 0;
    Phase m_phase = Phase::playing;
    std::vector<Memory> m_memory; ///< of each measurement
    std::uint64_t m_before = 0;   ///< for the next
    std::uint64_t m_results = 0;
};

} // namespace cdr::viewer
