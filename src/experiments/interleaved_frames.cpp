#include "interleaved_frames.h"

#include <cdr/measure/statistics/statistics.h>

#include <algorithm>
#include <chrono>

namespace cdr::experiments {

FrameSample timed(const std::function<render::FrameStats()>& draw) {
    const auto begin = std::chrono::steady_clock::now();
    const render::FrameStats stats = draw();
    const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
    return {.frameMs = passed.count(),
            .cullAndBinMs = stats.times.cullMs + stats.times.binMs,
            .recordMs = stats.times.recordMs,
            .executeMs = stats.times.executeMs,
            .draws = static_cast<double>(stats.draws)};
}

InterleavedFrames::InterleavedFrames(std::size_t modes, std::uint64_t seed)
    : m_order(modes, seed),
      m_samples(modes) {}

void InterleavedFrames::draw(const std::function<FrameSample(std::size_t)>& draw) {
    for (const std::size_t mode : m_order.next()) {
        m_samples[mode].push_back(draw(mode));
    }
}

void InterleavedFrames::run(std::uint32_t frames, const std::function<void()>& step,
                            const std::function<render::FrameStats(std::size_t, std::uint32_t)>& draw) {
    for (std::uint32_t i = 0; i < kWarmUp + frames; ++i) {
        if (i == kWarmUp) {
            forget();
        }
        const std::uint32_t frame = i < kWarmUp ? i % frames : i - kWarmUp;
        step();
        this->draw([&](std::size_t mode) { return timed([&] { return draw(mode, frame); }); });
    }
}

void InterleavedFrames::forget() {
    for (std::vector<FrameSample>& samples : m_samples) {
        samples.clear();
    }
}

std::vector<double> InterleavedFrames::samples(std::size_t mode, double FrameSample::*part) const {
    std::vector<double> values;
    for (const FrameSample& sample : m_samples[mode]) {
        values.push_back(sample.*part);
    }
    return values;
}

double InterleavedFrames::median(std::size_t mode, double FrameSample::*part) const {
    return measure::median(samples(mode, part));
}

std::vector<double> InterleavedFrames::ratios(std::size_t mode, std::size_t over,
                                              double FrameSample::*part) const {
    std::vector<double> ratios = samples(mode, part);
    const std::vector<double> base = samples(over, part);
    std::transform(ratios.begin(), ratios.end(), base.begin(), ratios.begin(), std::divides<>());
    return ratios;
}

} // namespace cdr::experiments
