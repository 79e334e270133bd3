#include "playback.h"

#include <cdr/base/format_error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace cdr::viewer {

void Playback::advance(double elapsed, double length) {
    if (!isPlaying) {
        return;
    }
    seconds += elapsed * speed;
    if (seconds <= length) {
        return;
    }
    isPlaying = loops && length > 0.0;
    seconds = isPlaying ? std::fmod(seconds, length) : length;
}

void Playback::toggle(double length) {
    isPlaying = !isPlaying;
    if (isPlaying && seconds >= length) {
        seconds = 0.0;
    }
}

double Playback::moment(const scene::GltfChoice& choice) const {
    return choice.seconds.value_or(0.0) + seconds;
}

void Playback::goTo(double moment, const scene::GltfChoice& choice) {
    seconds = std::max(moment - choice.seconds.value_or(0.0), 0.0);
}

std::uint32_t Playback::frame(const scene::GltfChoice& choice) const {
    const double frame = std::floor(seconds * choice.framesPerSecond.value_or(kPlaybackRate) + 0.5);
    return static_cast<std::uint32_t>(
        std::clamp(frame, 0.0, static_cast<double>(std::numeric_limits<std::uint32_t>::max())));
}

scene::GltfChoice withAnimation(scene::GltfChoice choice, const scene::OpenedScene& scene, int number) {
    choice.seconds.reset();
    choice.animation.reset();
    choice.framesPerSecond.reset();
    if (number >= 0) {
        const std::string text = std::to_string(number);
        const bool isItsOwn = scene::animationOf(scene.animations, text) == static_cast<std::size_t>(number);
        choice.animation = isItsOwn ? text : "#" + text; // else the name of another
        choice.framesPerSecond = kPlaybackRate;
    }
    return choice;
}

Playback playbackOf(scene::GltfChoice& choice, std::uint32_t frame) {
    Playback playback;
    if (choice.framesPerSecond) {
        playback.seconds = frame / *choice.framesPerSecond;
        if (!std::isfinite(playback.seconds)) {
            throw base::inputError("--frame {} at --fps {} is at no finite time", frame,
                                   *choice.framesPerSecond);
        }
    } else if (choice.animation || choice.seconds) {
        playback.seconds = choice.seconds.value_or(0.0);
        choice.seconds.reset();
        choice.framesPerSecond = kPlaybackRate;
    }
    return playback;
}

double playableSeconds(const scene::GltfChoice& choice, const scene::OpenedScene& scene) {
    const int number = chosenNumber(choice, scene);
    return number < 0 ? 0.0
                      : std::max(scene.animations[static_cast<std::size_t>(number)].seconds -
                                     choice.seconds.value_or(0.0),
                                 0.0);
}

int chosenNumber(const scene::GltfChoice& choice, const scene::OpenedScene& scene) {
    if (!choice.framesPerSecond || scene.animations.empty()) {
        return -1;
    }
    const auto number = choice.animation ? scene::animationOf(scene.animations, *choice.animation)
                                         : std::optional<std::size_t>(0);
    return number ? static_cast<int>(*number) : -1;
}

} // namespace cdr::viewer
