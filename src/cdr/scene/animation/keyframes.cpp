#include <cdr/scene/animation/keyframes.h>

#include <algorithm>
#include <array>

namespace cdr::scene {

namespace {

/// Where a moment lies between two keyframes.
struct Moment {
    std::size_t before = 0;
    std::size_t after = 0; ///< the same where no keyframe is before or after
    double share = 0.0;    ///< of the way from one to the other, in [0, 1)
    double length = 0.0;   ///< of that way, seconds
};

Moment momentOf(const std::vector<float>& times, double seconds) {
    const auto after = std::ranges::upper_bound(
        times, seconds, [](double value, float time) { return value < static_cast<double>(time); });
    if (after == times.begin()) {
        return {};
    }
    const auto k = static_cast<std::size_t>(after - times.begin()) - 1;
    if (after == times.end()) {
        return {.before = k, .after = k};
    }
    const double begin = times[k];
    const double length = static_cast<double>(*after) - begin;
    return {.before = k, .after = k + 1, .share = (seconds - begin) / length, .length = length};
}

/// Number `i` of the part `part` of a keyframe; see Keyframes::values.
double numberOf(const Keyframes& keyframes, std::size_t keyframe, std::size_t part, std::size_t i) {
    const std::size_t parts = keyframes.interpolation == Interpolation::cubicSpline ? 3 : 1;
    return keyframes.values[(keyframe * parts + part) * keyframes.width + i];
}

double cubicAt(const Keyframes& keyframes, const Moment& moment, std::size_t i) {
    constexpr std::size_t kIn = 0;
    constexpr std::size_t kValue = 1;
    constexpr std::size_t kOut = 2;
    const double t = moment.share;
    const double t2 = t * t;
    const double t3 = t2 * t;
    return (2.0 * t3 - 3.0 * t2 + 1.0) * numberOf(keyframes, moment.before, kValue, i) +
           moment.length * (t3 - 2.0 * t2 + t) * numberOf(keyframes, moment.before, kOut, i) +
           (3.0 * t2 - 2.0 * t3) * numberOf(keyframes, moment.after, kValue, i) +
           moment.length * (t3 - t2) * numberOf(keyframes, moment.after, kIn, i);
}

double numberAt(const Keyframes& keyframes, const Moment& moment, std::size_t i) {
    switch (keyframes.interpolation) {
    case Interpolation::cubicSpline:
        return cubicAt(keyframes, moment, i);
    case Interpolation::linear: {
        const double before = numberOf(keyframes, moment.before, 0, i);
        return before + moment.share * (numberOf(keyframes, moment.after, 0, i) - before);
    }
    case Interpolation::step:
        break;
    }
    return numberOf(keyframes, moment.before, 0, i);
}

glm::dquat normalized(const glm::dquat& turn) {
    const double length = glm::length(turn);
    return length > 0.0 ? turn / length : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

glm::dquat quaternionOf(const Keyframes& keyframes, std::size_t keyframe) {
    const auto number = [&](std::size_t i) { return numberOf(keyframes, keyframe, 0, i); };
    return normalized(glm::dquat(number(3), number(0), number(1), number(2)));
}

} // namespace

void sampleAt(const Keyframes& keyframes, double seconds, std::span<double> value) {
    const Moment moment = momentOf(keyframes.times, seconds);
    for (std::size_t i = 0; i < value.size(); ++i) {
        value[i] = numberAt(keyframes, moment, i);
    }
}

glm::dquat rotationAt(const Keyframes& keyframes, double seconds) {
    if (keyframes.interpolation == Interpolation::linear) {
        const Moment moment = momentOf(keyframes.times, seconds);
        return normalized(glm::slerp(quaternionOf(keyframes, moment.before),
                                     quaternionOf(keyframes, moment.after), moment.share));
    }
    std::array<double, 4> value{};
    sampleAt(keyframes, seconds, value);
    return normalized(glm::dquat(value[3], value[0], value[1], value[2]));
}

} // namespace cdr::scene
