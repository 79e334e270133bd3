#include <cdr/image/srgb.h>
#include <cdr/render/shading/finish.h>
#include <cdr/shaders/shared.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace cdr::render {

namespace {

float gainOf(const Finish& finish) {
    return static_cast<float>(std::exp2(finish.exposure));
}

bool isNeutral(const Finish& finish, Daylight daylight) {
    return finish.toneMap == ToneMap::neutral ||
           (finish.toneMap == ToneMap::scene && daylight == Daylight::present);
}

glm::vec3 neutralOf(glm::vec3 color) {
    constexpr float kCompressed = 0.8f - 0.04f;
    const float least = std::min({color.r, color.g, color.b});
    color -= least < 0.08f ? least - 6.25f * least * least : 0.04f;
    const float peak = std::max({color.r, color.g, color.b});
    if (peak < kCompressed) {
        return color;
    }
    constexpr float kRoom = 1.0f - kCompressed;
    const float lower = 1.0f - kRoom * kRoom / (peak + kRoom - kCompressed);
    const float white = 1.0f - 1.0f / (0.15f * (peak - lower) + 1.0f);
    return glm::mix(color * (lower / peak), glm::vec3(lower), white);
}

} // namespace

std::array<std::uint32_t, 2> finishConstants(const Finish& finish, Daylight daylight) {
    std::uint32_t kind = finish.exposure != 0.0 ? shaders::kFinishExposed : shaders::kFinishNone;
    if (isNeutral(finish, daylight)) {
        kind = shaders::kFinishNeutral;
    }
    return {kind, std::bit_cast<std::uint32_t>(gainOf(finish))};
}

std::array<std::uint32_t, 2> finishLaterConstants() {
    return {shaders::kFinishLater, std::bit_cast<std::uint32_t>(1.0f)};
}

glm::vec3 finished(glm::vec3 color, const Finish& finish, Daylight daylight) {
    color *= gainOf(finish);
    return isNeutral(finish, daylight) ? neutralOf(glm::min(color, 65504.0f)) : color;
}

glm::vec3 shownBackground(const glm::vec3& background, const Finish& finish, Daylight daylight) {
    glm::vec3 color = finished(background, finish, daylight);
    for (int i = 0; i < 3; ++i) {
        color[i] = static_cast<float>(image::linearOfSrgb()[image::srgbOfLinear(color[i])]);
    }
    return color;
}

} // namespace cdr::render
