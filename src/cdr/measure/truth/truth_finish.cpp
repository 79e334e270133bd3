#include <cdr/measure/truth/truth_finish.h>

#include <algorithm>
#include <cmath>

namespace cdr::measure {

namespace {

/// The tone mapper's paper has these numbers: what a dielectric mirrors, where compression begins, how fast highlights lose
/// their colour.
constexpr double kMirrored = 0.04;
constexpr double kBegin = 0.8 - kMirrored;
constexpr double kBleaching = 0.15;

double darkest(const glm::dvec3& color) {
    return std::min({color.r, color.g, color.b});
}

/// By how much a colour is moved down, so that what a dielectric mirrors does not make base colours pale.
double offsetOf(double least) {
    return least < 2.0 * kMirrored ? least - least * least / (4.0 * kMirrored) : kMirrored;
}

glm::dvec3 neutral(const glm::dvec3& color) {
    const glm::dvec3 moved = color - offsetOf(darkest(color));
    const double peak = std::max({moved.r, moved.g, moved.b});
    if (peak < kBegin) {
        return moved;
    }
    const double compressed = 1.0 - std::pow(1.0 - kBegin, 2.0) / (peak + 1.0 - 2.0 * kBegin);
    const double colorful = 1.0 / (kBleaching * (peak - compressed) + 1.0);
    return glm::mix(glm::dvec3(compressed), moved * (compressed / peak), colorful);
}

} // namespace

glm::dvec3 finished(const glm::dvec3& color, const TruthFinish& finish) {
    const glm::dvec3 exposed = color * std::exp2(finish.exposure);
    return finish.neutral ? neutral(exposed) : exposed;
}

} // namespace cdr::measure
