#include "playback.h"

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

std::uint32_t Playback::frame(const scene::GltfChoice& choice) const {
    const double frame = std::floor(seconds * choice.framesPerSecond.value_or(kPlaybackRate) + 0.5);
    return static_cast<std::uint32_t>(
        std::clamp(frame, 0.0, static_cast<double>(std::numeric_limits<std::uint32_t>::max())));
}

scene::GltfChoice withAnimation(scene::GltfChoice choice, int number) {
    choice.seconds.reset();
    choice.animation.reset();
    choice.framesPerSecond.reset();
    if (number >= 0) {
        choice.animation = std::to_string(number);
        choice.framesPerSecond = kPlaybackRate;
    }
    return choice;
}

Playback playbackOf(scene::GltfChoice& choice, std::uint32_t frame) {
    Playback playback;
    if (choice.framesPerSecond) {
        playback.seconds = frame / *choice.framesPerSecond;
    } else if (choice.animation || choice.seconds) {
        playback.seconds = choice.seconds.value_or(0.0);
        choice.seconds.reset();
        choice.animation = choice.animation.value_or("0");
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
    const std::string asked = choice.animation.value_or("0");
    const auto count = static_cast<int>(scene.animations.size());
    for (int i = 0; i < count; ++i) {
        if (scene.animations[static_cast<std::size_t>(i)].name == asked) {
            return i;
        }
    }
    for (int i = 0; i < count; ++i) {
        if (std::to_string(i) == asked) {
            return i;
        }
    }
    return -1;
}

} // namespace cdr::viewer
