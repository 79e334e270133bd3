#pragma once

#include <cdr/depth/advice.h>
#include <cdr/gpu/device.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace cdr::experiments {

/// How depth::advise() is measured on a device: what each technique resolves by the probe's ladder at the
/// distance asked for, between the question's near and far planes. What it costs is measured by the
/// timing scene, 64,000 cubes, in frames that interleave all techniques.
///
/// The ladder brings its own lens and its own depth, 18 units and less below 1000 units; the question's are
/// in the prediction only.
struct MeasuredAdviceOptions {
    std::uint32_t width = 1280;
    std::uint32_t height = 720;
    std::uint32_t frames = 25; ///< timed per technique
    std::size_t threads = 1;
    std::uint64_t seed = 2013;
};

/// Called with how many pictures of all are done.
using AdviceProgress = std::function<void(std::size_t done, std::size_t all, const std::string& what)>;

/// The question without the depth formats that the device lacks; base::InputError when it lacks all of them.
depth::AdviceQuestion onDevice(const gpu::Device& device, depth::AdviceQuestion question);

/// Advice whose every row is measured. Costs are timed in the first of the question's formats and hold for
/// the technique's other formats. base::InputError as depth::advise() and runProbe().
depth::Advice measureAdvice(const gpu::Device& device, const depth::AdviceQuestion& question,
                            const MeasuredAdviceOptions& options, const AdviceProgress& progress);

} // namespace cdr::experiments
