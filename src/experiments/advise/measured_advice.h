#pragma once

#include <cdr/depth/advice.h>
#include <cdr/gpu/device.h>
#include <experiments/progress.h>

#include <cstddef>
#include <cstdint>

namespace cdr::experiments {

/// How depth::advise() is measured on a device. The probe's ladder measures what each technique resolves at the
/// distance of the question, between its near and far planes. The timing scene, 64,000 cubes, measures the cost
/// of each, in frames that interleave all techniques.
///
/// The ladder has its own lens and its own depth, 18 units, and less below 1000 units. Lens and depth of the
/// question are in the prediction only.
struct MeasuredAdviceOptions {
    std::uint32_t width = 1280;
    std::uint32_t height = 720;
    std::uint32_t frames = 25; ///< timed per technique
    std::size_t threads = 1;
    std::uint64_t seed = 2013;
};

/// The question without the depth formats that the device lacks; base::InputError when it lacks all of them.
depth::AdviceQuestion onDevice(const gpu::Device& device, depth::AdviceQuestion question);

/// Advice whose every row is measured. Costs are timed in the first of the question's formats and hold for
/// the technique's other formats. base::InputError as depth::advise() and runProbe().
depth::Advice measureAdvice(const gpu::Device& device, const depth::AdviceQuestion& question,
                            const MeasuredAdviceOptions& options, const NamedProgress& progress);

} // namespace cdr::experiments
