#include <rivals/key_scale.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace cdr::rivals {

namespace {

constexpr int kFixedBits = 63;
constexpr std::uint32_t kFloat32KeyShift = shaders::kLogKeyBits - 32;

std::uint64_t bitsOf(double value) {
    return std::bit_cast<std::uint64_t>(value);
}

/// Keys up to far fill their bits, unless a float32 ends before: then far is below 2.7e-20, and they fill fewer.
float stepsPerUnit(double farView) {
    constexpr int kLargestExponent = std::numeric_limits<float>::max_exponent - 1;
    return std::exp2(static_cast<float>(std::min(kFixedBits - 1 - std::ilogb(farView), kLargestExponent)));
}

/// A float32 whose bits were ordered as unsigned numbers.
float unordered(std::uint32_t ordered) {
    const bool isPositive = (ordered & 0x80000000u) != 0;
    return std::bit_cast<float>(isPositive ? ordered & 0x7fffffffu : ~ordered);
}

} // namespace

KeyScale::KeyScale(const Rival& rival, const scene::Camera& camera)
    : m_rival(rival),
      m_stepsPerUnit(stepsPerUnit(camera.farView)),
      m_originTop(static_cast<std::uint32_t>(bitsOf(camera.nearView) >> 32u)) {
    const std::uint64_t span = bitsOf(camera.farView) - (std::uint64_t{m_originTop} << 32u);
    const auto bits = static_cast<std::uint32_t>(std::bit_width(span));
    m_shift = bits > shaders::kLogKeyBits ? bits - shaders::kLogKeyBits : 0;
}

shaders::RivalPush KeyScale::pushFor(std::uint32_t width) const {
    return {.width = width, .scale = m_stepsPerUnit, .originTop = m_originTop, .shift = m_shift};
}

double KeyScale::distanceView(std::uint64_t key) const {
    if (key == kNoKey) {
        return std::numeric_limits<double>::infinity();
    }
    switch (m_rival.key) {
    case Key::log40: {
        const std::uint64_t steps = key >> shaders::kIdBits;
        if (m_rival.distance == Distance::view) {
            return static_cast<double>(
                std::bit_cast<float>(static_cast<std::uint32_t>(steps >> kFloat32KeyShift)));
        }
        return std::bit_cast<double>((steps << m_shift) + (std::uint64_t{m_originTop} << 32u));
    }
    case Key::fixed64:
        return static_cast<double>(key) / static_cast<double>(m_stepsPerUnit);
    case Key::pair64:
        break;
    }
    return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(key >> 32u))) +
           static_cast<double>(unordered(static_cast<std::uint32_t>(key)));
}

} // namespace cdr::rivals
