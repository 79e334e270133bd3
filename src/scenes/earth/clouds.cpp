#include <scenes/earth/clouds.h>

#include <algorithm>

namespace cdr::scenes {

namespace {

// Metres.
constexpr double kClearAround = 12e3; ///< of the airport: no cloud at all
constexpr double kUsualFrom = 120e3;  ///< of the airport
constexpr double kWindLength = 900e3;
constexpr double kWind = 110e3;
constexpr Waves kThickness{.longest = 900e3, .shortest = 250.0, .gain = 0.76, .seed = 101};

} // namespace

Clouds::Weather Clouds::weatherAt(const glm::dvec2& place, const Fineness& fineness) const {
    Weather weather;
    const Waves turns{.longest = kWindLength, .shortest = 0.2 * kWindLength, .gain = 0.5, .seed = 7};
    weather.wind = kWind * glm::dvec2(sumWaves(turns, place, fineness.texel),
                                      sumWaves(turns, place + 3e6, fineness.texel));
    const glm::dvec2 blown = place + weather.wind;
    const double clearing = 3.5 * (1.0 - smoothStep(kClearAround, kUsualFrom, glm::length(place)));
    weather.here = sumWaves(kThickness, blown, fineness, WavePart::ofGrid) - clearing;
    weather.sunwards = sumWaves(kThickness, blown + m_toShade, fineness, WavePart::ofGrid) - clearing;
    return weather;
}

Clouds::Cover Clouds::coverAt(const Weather& weather, const glm::dvec2& place,
                              const Fineness& fineness) const {
    // Shorter waves add less than this.
    constexpr double kMaxRest = 2.0;
    constexpr double kThin = 0.12;
    constexpr double kThick = 0.9;
    if (std::max(weather.here, weather.sunwards) < kThin - kMaxRest) {
        return {};
    }
    const glm::dvec2 blown = place + weather.wind;
    const double here = weather.here + sumWaves(kThickness, blown, fineness, WavePart::beyondGrid);
    const double sunwards =
        weather.sunwards + sumWaves(kThickness, blown + m_toShade, fineness, WavePart::beyondGrid);
    return {.share = smoothStep(kThin, kThick, here),
            .shade = 0.6 * smoothStep(kThin, kThick, sunwards),
            .bright = std::clamp(0.66 + 0.14 * here + 0.3 * (here - sunwards), 0.35, 1.0)};
}

} // namespace cdr::scenes
