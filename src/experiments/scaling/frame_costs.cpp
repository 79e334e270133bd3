#include "frame_costs.h"

#include <cdr/image/codec.h>
#include <cdr/platform/file.h>
#include <cdr/platform/stopwatch.h>
#include <cdr/render/renderer.h>
#include <scenes/cubes.h>

#include <runs/units.h>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace cdr::experiments {

namespace {

/// Frames of each rank that the run is compared with.
constexpr std::size_t kFramesPerRank = 12;
constexpr std::size_t kClaimsPerRank = 64;
constexpr std::size_t kMessageBytes = 4'000'000;
constexpr int kMessages = 7;

/// As `render` makes and takes a frame.
class CostedFrame {
  public:
    CostedFrame(const gpu::Device& device, const RankSweepOptions& options, const image::PictureSize& size)
        : m_setup(
              scenes::makeCrowd(options.seed, options.cubes, static_cast<double>(size.width) / size.height)),
          m_onDevice(device, m_setup.scene),
          m_renderer(
              device, m_setup.scene, m_onDevice,
              {.width = size.width, .height = size.height, .technique = depth::parseTechnique("anchored")}) {}

    output::Json make() {
        const render::Frame frame = m_renderer.render(m_setup.path.at(0));
        return {{"file", output::Json::binary(image::encodeImage("frame.png", frame.color))}};
    }

  private:
    scene::SceneSetup m_setup;
    render::GpuScene m_onDevice;
    render::Renderer m_renderer;
};

/// Milliseconds until an empty unit is claimed, made and taken. Ranks claim at once, so each has its share of the units.
double claimMs(ranks::Ranks& ranks) {
    const platform::Stopwatch watch;
    ranks.forEachUnit(
        kClaimsPerRank * ranks.place().count, [](std::size_t) { return platform::Bytes(); },
        [](std::size_t, const platform::Bytes&) {});
    return ranks.isAlone() ? 0.0 : watch.milliseconds() / kClaimsPerRank;
}

/// Milliseconds of a byte's way from the second rank to the first. Each message is sent several times, since a busy machine
/// makes some late; the quickest counts.
double byteMs(ranks::Ranks& ranks) {
    const bool sends = ranks.place().index == 1;
    const auto quickest = [&](std::size_t bytes) {
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < kMessages; ++i) {
            const platform::Stopwatch watch;
            ranks.merge([&] { return platform::Bytes(sends ? bytes : 0); }, [](const platform::Bytes&) {});
            least = std::min(least, watch.milliseconds());
        }
        return least;
    };
    const double nothing = quickest(0);
    return ranks.isAlone() ? 0.0 : std::max(quickest(kMessageBytes) - nothing, 0.0) / kMessageBytes;
}

} // namespace

MeasuredCosts measureFrameCosts(const gpu::Device& device, const RankSweepOptions& options,
                                ranks::Ranks& ranks) {
    CostedFrame frame(device, options, options.sizes.front());
    const platform::PendingFile file(platform::scratchPath(".png")); // never committed
    frame.make();                                                    // warms up
    MeasuredCosts measured;
    FrameCosts& costs = measured.costs;
    costs.claimMs = claimMs(ranks);
    costs.msPerByte = byteMs(ranks);
    const auto makeTimed = [&](std::size_t) {
        const platform::Stopwatch watch;
        output::Json made = frame.make();
        made["ms"] = watch.milliseconds();
        return made;
    };
    const auto take = [&](const output::Json& made) {
        const platform::Stopwatch watch;
        platform::writeFile(file.temporary(), made.at("file").get_binary());
        costs.takeMs.push_back(watch.milliseconds());
        costs.makeMs.push_back(made.at("ms").get<double>());
        costs.bytes = static_cast<double>(made.at("file").get_binary().size());
    };
    runs::forEachUnit(ranks, options.repeats * ranks.place().count, makeTimed,
                      [&](std::size_t, const output::Json& made) { take(made); });
    measured.run.frames = kFramesPerRank * ranks.place().count;
    const platform::Stopwatch watch;
    runs::forEachUnit(
        ranks, measured.run.frames, [&](std::size_t) { return frame.make(); },
        [&](std::size_t, const output::Json& made) {
            platform::writeFile(file.temporary(), made.at("file").get_binary());
        });
    measured.run.seconds = watch.seconds();
    return measured;
}

} // namespace cdr::experiments
