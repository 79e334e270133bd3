#pragma once

#include <cdr/scene/camera.h>
#include <cdr/shaders/rivals_shared.h>

#include <rivals/rival.h>

#include <cstdint>
#include <limits>

namespace cdr::rivals {

/// Of a pixel that nothing was drawn at: the largest key.
inline constexpr std::uint64_t kNoKey = std::numeric_limits<std::uint64_t>::max();

/// How a camera's distances become keys (shaders/rivals/key.glsl).
class KeyScale {
  public:
    /// @param camera with near and far in float32's range.
    KeyScale(const Rival& rival, const scene::Camera& camera);

    /// What shaders read. @param width of the picture, pixels.
    shaders::RivalPush pushFor(std::uint32_t width) const;

    /// The view distance that a key stands for; infinity of kNoKey. Of a log key without its id, which lies below it.
    double distanceView(std::uint64_t key) const;

  private:
    Rival m_rival;
    float m_stepsPerUnit;
    std::uint32_t m_originTop;
    std::uint32_t m_shift = 0;
};

} // namespace cdr::rivals
