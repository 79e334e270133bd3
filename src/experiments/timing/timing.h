#pragma once

#include <cdr/gpu/device.h>
#include <cdr/measure/statistics/statistics.h>
#include <cdr/platform/trace.h>
#include <cdr/render/render_options.h>
#include <cdr/render/targets/targets.h>
#include <experiments/progress.h>

#include <rivals/contender.h>
#include <runs/timed_ranks.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cdr::experiments {

/// How the cubes' triangles come.
enum class TimingMeshes : std::uint8_t {
    indexed,  ///< vertices shared, faces turned away culled
    unshared, ///< three vertices a triangle, nothing culled: what naive code draws
};

/// One way to render that Figure 6.4 compares.
struct TimingMode {
    std::string name;                ///< of no other mode, such as "cdr-3" or "cdr-3/one-pass"
    std::string preset;              ///< that it derives from: "cdr" for all numbers of cascades
    render::RenderOptions drawing{}; ///< but for size and threads, and how frames are timed
    TimingMeshes meshes = TimingMeshes::indexed;
    std::optional<double> thesisPercent; ///< overhead over standard that Figure 6.4 gives
    /// If set, it draws ids and distances alone, as rivals do, and nothing is shaded. Then only the names of the members
    /// above are used.
    std::optional<rivals::Competing> idsAlone{};

    bool isRival() const { return idsAlone && std::holds_alternative<rivals::Rival>(*idsAlone); }
};

/// The modes of Figure 6.4 and ours, each again under one-pass. The first is standard, the baseline; the
/// second is standard again, whose overhead is the noise floor.
std::vector<TimingMode> timingModes();

/// A mode for each rival, and in front standard/ids, over which they are: standard as rivals draw, by
/// rivals::DepthTestPass. None where there is no rival.
std::vector<TimingMode> rivalTimingModes(const std::vector<rivals::NamedRival>& rivals);

/// The modes of those names, standard twice in front whether named or not. A name is that of a technique in timingModes(),
/// "naive" or "log-fragment". Behind it may stand words of options, each after a "/": of batchings, submissions, surfaces,
/// targets and snapping, and "occlusion-culling". base::InputError with a suggestion for an unknown name or word.
std::vector<TimingMode> timingModesNamed(const std::vector<std::string>& names);

/// What modes are timed over.
enum class TimingScene : std::uint8_t {
    rotation, ///< the thesis' cubes
    traffic,  ///< cubes that move
    city,     ///< boxes of houses, most of them hidden
};
inline constexpr std::array kTimingScenes{TimingScene::rotation, TimingScene::traffic, TimingScene::city};

/// "rotation", "traffic" or "city".
std::string_view nameOf(TimingScene scene);
/// Of all of them.
std::span<const std::string_view> timingSceneNames();
/// base::InputError with a suggestion for an unknown name.
TimingScene parseTimingScene(std::string_view name);

/// Figure 6.4: what each technique costs over standard. 64,000 unit cubes in a 400^3 field, the camera in the
/// middle turning once about y over all frames. Every mode renders a camera before the next camera, in an
/// order shuffled again for each.
struct TimingOptions {
    TimingScene scene = TimingScene::rotation;
    std::uint32_t width = 1280;
    std::uint32_t height = 720;
    std::uint32_t frames = 10'000; ///< measured, without the warm-up
    std::size_t threads = 1;
    /// 1 times latency, waiting for each frame as the thesis does. More time throughput: runs of
    /// kThroughputRun frames of which so many may be in flight.
    std::size_t framesInFlight = 1;
    std::uint64_t seed = 2013;
    std::vector<TimingMode> modes = timingModes();
    platform::Trace* trace = nullptr; ///< receives the warm-up frames only, so measured ones stay as they are
};

/// Rendered and dropped before the first measured frame: pipelines compile, memory is touched, caches fill.
inline constexpr std::uint32_t kWarmUpFrames = 5;
/// Frames of one mode in a row where throughput is timed; their mean is one sample.
inline constexpr std::uint32_t kThroughputRun = 8;

/// Medians of a frame's parts, each by itself, microseconds.
struct TimingParts {
    double cullAndBinUs = 0.0;
    double recordUs = 0.0;
    double executeUs = 0.0;
    std::optional<double> deviceUs; ///< by the device's own clock, where it has one
    double draws = 0.0;
};

/// One bar of Figure 6.4. Times are microseconds of one frame, for latency from the camera to the device
/// being done.
struct TimingResult {
    TimingMode mode;
    std::size_t cascades = 0;         ///< of the first camera
    double medianUs = 0.0;            ///< whole frame: cull to the end of execute
    double lowUs = 0.0;               ///< 5th percentile of the same
    double highUs = 0.0;              ///< 95th
    std::optional<TimingParts> parts; ///< of latency; frames in flight have no parts of their own
    std::string over; ///< mode that the overhead is over: standard, or standard/ids of rivals, if it is there
    double overheadPercent = 0.0;                         ///< the median of the ratios frame by frame
    std::optional<measure::Interval> overheadPercent95{}; ///< bootstrapped
};

/// Results in the order of the modes. base::InputError for no frames or fewer than two modes, for an unknown scene, and
/// for a rival that the device cannot draw. A scene that moves is refused with frames in flight, unshared meshes, a
/// visibility buffer or ids alone. Ids alone are refused with frames in flight.
/// @param ranks that share the frames, or the runs of frames in flight; the first one alone has results, and traces.
std::vector<TimingResult> runTiming(const gpu::Device& device, const TimingOptions& options,
                                    const Progress& progress, runs::TimedRanks& ranks);

/// Whether an overhead is more than noise: its interval lies beyond the end of that of standard over itself which is farther
/// from 0, in either direction. Never without both.
bool liesApart(const std::optional<measure::Interval>& overhead,
               const std::optional<measure::Interval>& floor);

/// Figure 6.4 as a gnuplot script: overheads with their intervals, the thesis' beside them.
/// @param measuredOn goes under the title.
std::string timingPlot(const std::vector<TimingResult>& results, const std::string& measuredOn);

} // namespace cdr::experiments
