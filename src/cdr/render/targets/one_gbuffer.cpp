#include "one_gbuffer.h"

#include <cdr/render/targets/gbuffer_rendering.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace cdr::render {

namespace {

/// Octaves of normal float32 in [0, 1], less those of one mantissa, which the lowest slice keeps for itself.
constexpr std::size_t kSharedOctaves = 126 - 24;
/// At more octaves than the mantissa has bits, adding the slice's lower end would round instead of shift.
constexpr std::size_t kMaxOctaves = 24;
/// Values left out between slices of integers; float32 viewports round by less than one of 24 bits.
constexpr double kGuardValues = 4.0;

/// Slice `slice` from depth 0 up, by exponent.
DepthSlice floatSlice(std::size_t slice, std::size_t slices) {
    const auto octaves = static_cast<int>(std::min(kMaxOctaves, kSharedOctaves / slices));
    const int above = static_cast<int>(slices - 1 - slice);
    const float below = std::ldexp(1.0f, -octaves * (above + 1));
    return {.min = slice == 0 ? 0.0f : std::nextafter(below, 1.0f),
            .max = std::ldexp(1.0f, -octaves * above)};
}

/// Slice `slice` from depth 0 up, of equal numbers of values.
DepthSlice integerSlice(std::size_t slice, std::size_t slices, int bits) {
    const double values = std::ldexp(1.0, bits);
    const double width = values / static_cast<double>(slices);
    const double first = width * static_cast<double>(slice);
    const double last = slice + 1 == slices ? values - 1.0 : first + width - kGuardValues;
    return {.min = static_cast<float>(first / (values - 1.0)),
            .max = static_cast<float>(last / (values - 1.0))};
}

} // namespace

OneGBufferTargets::OneGBufferTargets(const gpu::Device& device, TargetsKind kind,
                                     const TargetsOptions& options)
    : m_options(options),
      m_gbuffer(makeGBuffer(device, options.extent, "G-buffer", options.format)),
      m_emission(makeEmission(device, options, "emission")),
      m_depth(makeDepthBuffer(device, options.extent, options.depthFormat, "depth", options.format)),
      m_zeroFill(makeZeroFill(device, options)) {
    if (kind == TargetsKind::single) {
        m_depthClear = makeDepthClear(device, options);
    }
}

DepthSlice OneGBufferTargets::depthSlice(std::size_t cascade, std::size_t cascades) const {
    if (m_depthClear) {
        return {};
    }
    const std::size_t slice = m_options.reversedDepth ? cascades - 1 - cascade : cascade;
    const depth::DepthFormatTraits& format = traitsOf(m_options.depthFormat);
    return format.isFloat ? floatSlice(slice, cascades) : integerSlice(slice, cascades, format.bits);
}

GBufferScope OneGBufferTargets::scope(const glm::vec4& clearColor) const {
    return {.gbuffer = m_gbuffer,
            .depth = m_depth,
            .emission = m_emission.get(),
            .reversedDepth = m_options.reversedDepth,
            .clearColor = clearColor,
            .zeroFill = m_zeroFill.get(),
            .depthClear = m_depthClear ? &*m_depthClear : nullptr};
}

void OneGBufferTargets::begin(vk::CommandBuffer primary) const {
    beginGBuffer(primary, scope());
}

void OneGBufferTargets::record(CascadeCommands& commands, const FrameView& view) {
    std::vector<std::size_t> order(view.cascades.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (m_depthClear) {
        order = commands.drawnCascades(view.cascades.size());
        std::reverse(order.begin(), order.end());
    }
    commands.drawScope(scope(view.clearColor), order);
}

} // namespace cdr::render
