#include "rank_sweep.h"

#include <cdr/base/format_error.h>
#include <cdr/gpu/memory.h>
#include <cdr/platform/stopwatch.h>
#include <cdr/render/part_scene.h>
#include <cdr/render/renderer.h>
#include <scenes/cubes.h>

#include <fmt/format.h>
#include <output/aov.h>
#include <runs/part_frames.h>
#include <runs/units.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

namespace cdr::experiments {

namespace {

/// Waits for all ranks.
void meet(ranks::Ranks& ranks) {
    ranks.merge([] { return platform::Bytes(); }, [](const platform::Bytes&) {});
}

/// Those of all ranks, in their order; on the other ranks less.
std::vector<RankShare> gathered(ranks::Ranks& ranks, std::vector<RankShare> shares) {
    ranks.merge([&]() -> platform::Bytes { return runs::packed(shares).get_binary(); },
                [&](const platform::Bytes& later) {
                    const auto theirs = runs::unpacked<RankShare>(output::Json::binary(later));
                    shares.insert(shares.end(), theirs.begin(), theirs.end());
                });
    return shares;
}

output::Json jsonOf(const RankShare& share) {
    return {{"rank", share.rank},
            {"draw_ms", share.drawMs},
            {"bytes_sent", share.bytesSent},
            {"device_bytes", share.deviceBytes}};
}

/// This rank's part of a frame that so many ranks draw; the others look on.
class RankPart {
  public:
    RankPart(const gpu::Device& device, const scene::SceneSetup& setup, render::RenderOptions options,
             std::size_t ranks, const ranks::Place& place)
        : m_camera(setup.path.at(0)),
          m_takesPart(place.index < ranks) {
        if (!m_takesPart) {
            return;
        }
        const std::uint64_t before = gpu::allocatedDeviceBytes(device);
        platform::WorkerPool workers(1);
        options.part = {.index = place.index, .count = ranks};
        m_scene = setup.scene;
        dropOtherParts(m_scene, options, {&m_camera, 1}, workers);
        m_onDevice = std::make_unique<render::GpuScene>(device, m_scene);
        m_renderer = std::make_unique<render::Renderer>(device, m_scene, *m_onDevice, options);
        m_renderer->render(m_camera);
        m_deviceBytes = gpu::allocatedDeviceBytes(device) - before;
    }

    /// Milliseconds until the first rank has the frame.
    double draw(ranks::Ranks& ranks) {
        meet(ranks);
        const platform::Stopwatch watch;
        m_bytesSent = 0;
        if (m_takesPart) {
            m_frame = m_renderer->render(m_camera);
            m_drawMs.push_back(watch.milliseconds());
            runs::mergeParts(ranks, m_frame, m_bytesSent);
        } else {
            meet(ranks);
        }
        return watch.milliseconds();
    }

    std::string hash() const { return output::hashOf(m_frame); }

    /// Empty where it takes no part.
    std::vector<RankShare> share(std::size_t rank) const {
        if (!m_takesPart) {
            return {};
        }
        return {{.rank = rank,
                 .drawMs = measure::median(m_drawMs),
                 .bytesSent = m_bytesSent,
                 .deviceBytes = m_deviceBytes}};
    }

  private:
    scene::Camera m_camera;
    bool m_takesPart;
    scene::Scene m_scene;
    std::unique_ptr<render::GpuScene> m_onDevice;
    std::unique_ptr<render::Renderer> m_renderer;
    render::Frame m_frame;
    std::vector<double> m_drawMs;
    std::size_t m_bytesSent = 0;
    std::uint64_t m_deviceBytes = 0;
};

render::RenderOptions sweptOptions(const image::PictureSize& size, unsigned cascades) {
    depth::Technique technique = depth::parseTechnique("cdr");
    technique.split = depth::SplitCount{cascades};
    return {.width = size.width,
            .height = size.height,
            .technique = technique,
            .targets = render::TargetsKind::layers};
}

/// Every number of ranks of one size and number of cascades, in turn, so that what slows the machine slows all.
std::vector<RankPoint> sweepRanks(const gpu::Device& device, const RankSweepOptions& options,
                                  const scene::SceneSetup& setup, const RankPoint& common,
                                  ranks::Ranks& ranks) {
    const std::vector<std::size_t> steps = rankSteps(ranks.place().count);
    std::vector<std::unique_ptr<RankPart>> parts;
    for (const std::size_t step : steps) {
        parts.push_back(std::make_unique<RankPart>(device, setup, sweptOptions(common.size, common.cascades),
                                                   step, ranks.place()));
    }
    std::vector<std::vector<double>> times(steps.size());
    for (std::uint32_t repeat = 0; repeat < options.repeats; ++repeat) {
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const std::size_t which = (repeat + i) % steps.size();
            times[which].push_back(parts[which]->draw(ranks));
        }
    }
    std::vector<RankPoint> points;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        std::vector<double> ratios;
        for (std::size_t repeat = 0; repeat < times[i].size(); ++repeat) {
            ratios.push_back(times.front()[repeat] / times[i][repeat]);
        }
        RankPoint point = common;
        point.ranks = steps[i];
        point.frameMs = measure::median(times[i]);
        point.frameInterval = measure::bootstrapMedian(times[i], options.seed);
        point.speedUp = measure::median(ratios);
        point.speedUpInterval = measure::bootstrapMedian(ratios, options.seed);
        point.shares = gathered(ranks, parts[i]->share(ranks.place().index));
        point.sameImage = !ranks.isFirst() || parts[i]->hash() == parts.front()->hash();
        points.push_back(std::move(point));
    }
    return points;
}

} // namespace

std::size_t RankPoint::bytesSent() const {
    return std::accumulate(shares.begin(), shares.end(), std::size_t{0},
                           [](std::size_t sum, const RankShare& share) { return sum + share.bytesSent; });
}

double RankPoint::slowestDrawMs() const {
    return std::accumulate(shares.begin(), shares.end(), 0.0,
                           [](double most, const RankShare& share) { return std::max(most, share.drawMs); });
}

std::uint64_t RankPoint::mostDeviceBytes() const {
    return std::accumulate(
        shares.begin(), shares.end(), std::uint64_t{0},
        [](std::uint64_t most, const RankShare& share) { return std::max(most, share.deviceBytes); });
}

void requireUsable(const RankSweepOptions& options) {
    if (options.sizes.empty() || options.cascades.empty()) {
        throw base::InputError("scaling --ranks: at least one size and one number of cascades is needed");
    }
    for (const unsigned cascades : options.cascades) {
        if (cascades < 1 || cascades > depth::kMaxCascades) {
            throw base::inputError("cascades must be 1 to {}, not {}", depth::kMaxCascades, cascades);
        }
    }
    if (options.cubes < 1 || options.cubes > scene::kMaxObjects || options.repeats < 1 ||
        options.repeats > 10'000) {
        throw base::InputError("scaling --ranks: draws or repeats are out of range");
    }
}

std::vector<std::size_t> rankSteps(std::size_t count) {
    std::vector<std::size_t> steps;
    for (std::size_t step = 1; step < count; step *= 2) {
        steps.push_back(step);
    }
    steps.push_back(count);
    return steps;
}

std::vector<RankPoint> runRankSweep(const gpu::Device& device, const RankSweepOptions& options,
                                    ranks::Ranks& ranks, const NamedProgress& progress) {
    requireUsable(options);
    std::vector<RankPoint> points;
    std::size_t done = 0;
    for (const image::PictureSize& size : options.sizes) {
        const scene::SceneSetup setup =
            scenes::makeCrowd(options.seed, options.cubes, static_cast<double>(size.width) / size.height);
        for (const unsigned cascades : options.cascades) {
            progress(done++, options.sizes.size() * options.cascades.size(),
                     fmt::format("{}x{}, {} cascades", size.width, size.height, cascades));
            RankPoint common;
            common.size = size;
            common.cascades = cascades;
            std::vector<RankPoint> swept = sweepRanks(device, options, setup, common, ranks);
            std::move(swept.begin(), swept.end(), std::back_inserter(points));
        }
    }
    return ranks.isFirst() ? points : std::vector<RankPoint>();
}

output::Columns<RankPoint> rankPointColumns() {
    const auto shares = [](const RankPoint& point) {
        output::Json all = output::Json::array();
        for (const RankShare& share : point.shares) {
            all.push_back(jsonOf(share));
        }
        return all;
    };
    return {
        {.key = "size",
         .value =
             [](const RankPoint& point) { return fmt::format("{}x{}", point.size.width, point.size.height); },
         .heading = "size"},
        {.key = "cascades", .value = &RankPoint::cascades, .heading = "cascades"},
        {.key = "ranks", .value = &RankPoint::ranks, .heading = "ranks"},
        {.key = "frame_ms", .value = &RankPoint::frameMs, .heading = "frame ms"},
        output::intervalColumn(&RankPoint::frameInterval, {.key = "frame_ms_ci95", .heading = ""}),
        {.key = "speedup", .value = &RankPoint::speedUp, .heading = "speed-up"},
        output::intervalColumn(&RankPoint::speedUpInterval, {.key = "speedup_ci95", .heading = "95 %"}),
        {.key = "efficiency", .value = &RankPoint::efficiency, .heading = "efficiency"},
        {.key = "slowest_draw_ms", .value = &RankPoint::slowestDrawMs, .heading = "slowest draw ms"},
        {.key = "bytes_sent", .value = &RankPoint::bytesSent, .heading = "bytes sent"},
        {.key = "most_device_bytes", .value = &RankPoint::mostDeviceBytes, .heading = "most device bytes"},
        {.key = "shares", .value = shares},
        {.key = "same_image",
         .value = &RankPoint::sameImage,
         .heading = "image",
         .text = [](const RankPoint& point) { return point.sameImage ? "same" : "DIFFERS"; }}};
}

} // namespace cdr::experiments
