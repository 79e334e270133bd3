#include "interleaved_frames.h"

#include <cdr/measure/statistics/statistics.h>
#include <cdr/platform/stopwatch.h>

#include <ranks/one_process.h>
#include <runs/units.h>

#include <algorithm>
#include <utility>

namespace cdr::runs {

FrameSample timed(const std::function<render::FrameStats()>& draw) {
    const platform::Stopwatch watch;
    const render::FrameStats stats = draw();
    return {.frameMs = watch.milliseconds(),
            .cullMs = stats.times.cullMs,
            .binMs = stats.times.binMs,
            .cullAndBinMs = stats.times.cullMs + stats.times.binMs,
            .recordMs = stats.times.recordMs,
            .executeMs = stats.times.executeMs,
            .deviceMs = stats.times.deviceMs.value_or(FrameSample{}.deviceMs),
            .draws = static_cast<double>(stats.draws)};
}

InterleavedFrames::InterleavedFrames(std::size_t modes, std::uint64_t seed)
    : m_order(modes, seed),
      m_samples(modes) {}

std::vector<FrameSample> InterleavedFrames::row(const std::function<FrameSample(std::size_t)>& draw) {
    std::vector<FrameSample> row(m_samples.size());
    for (const std::size_t mode : m_order.next()) {
        row[mode] = draw(mode);
    }
    return row;
}

void InterleavedFrames::add(const std::vector<FrameSample>& row) {
    for (std::size_t mode = 0; mode < m_samples.size(); ++mode) {
        m_samples[mode].push_back(row.at(mode));
    }
}

void InterleavedFrames::divide(TimedRanks& ranks, std::size_t units,
                               const std::function<FrameSample(std::size_t, std::size_t)>& draw) {
    ranks.forEachUnit(
        units,
        [&](std::size_t unit) { return packed(row([&](std::size_t mode) { return draw(mode, unit); })); },
        [&](std::size_t, const output::Json& timed) { add(unpacked<FrameSample>(timed)); });
}

void InterleavedFrames::run(TimedRanks& ranks, std::uint32_t frames, const std::function<void()>& step,
                            const std::function<render::FrameStats(std::size_t, std::uint32_t)>& draw) {
    for (std::uint32_t i = 0; i < kWarmUp; ++i) {
        step();
        this->draw([&](std::size_t mode) { return timed([&] { return draw(mode, i % frames); }); });
    }
    forget();
    std::size_t stepped = frames; // the last unit that was
    divide(ranks, frames, [&](std::size_t mode, std::size_t unit) {
        if (std::exchange(stepped, unit) != unit) {
            step();
        }
        return timed([&] { return draw(mode, static_cast<std::uint32_t>(unit)); });
    });
}

void InterleavedFrames::runAlone(std::uint32_t frames, const std::function<void()>& step,
                                 const std::function<render::FrameStats(std::size_t, std::uint32_t)>& draw) {
    ranks::OneProcess alone;
    TimedRanks here(alone);
    run(here, frames, step, draw);
}

void InterleavedFrames::forget() {
    for (std::vector<FrameSample>& samples : m_samples) {
        samples.clear();
    }
}

output::Json InterleavedFrames::packedSamples() const {
    output::Json all = output::Json::array();
    for (const std::vector<FrameSample>& samples : m_samples) {
        all.push_back(packed(samples));
    }
    return all;
}

void InterleavedFrames::takeSamples(const output::Json& packed, std::size_t frames) {
    for (std::size_t mode = 0; mode < m_samples.size(); ++mode) {
        m_samples[mode] = unpacked<FrameSample>(packed.at(mode), frames);
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
    // On a coarse clock a part may take no time.
    std::transform(ratios.begin(), ratios.end(), base.begin(), ratios.begin(),
                   [](double time, double ofBase) { return ofBase > 0.0 ? time / ofBase : 1.0; });
    return ratios;
}

} // namespace cdr::runs
