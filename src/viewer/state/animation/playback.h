#pragma once

#include <cdr/scene/gltf/open_gltf.h>

#include <cstdint>

namespace cdr::viewer {

/// How finely a moment can be chosen by default: frames of a second.
inline constexpr double kPlaybackRate = 1000.0;

/// How an animation of a file is played.
struct Playback {
    bool isPlaying = false;
    bool loops = true;
    double speed = 1.0;   ///< above 0
    double seconds = 0.0; ///< since frame 0

    /// Goes on by so much time of the person at the window. Without a loop it stops at the end.
    /// @param length seconds that there are
    void advance(double elapsed, double length);
    /// Plays or pauses. At the end it begins again.
    /// @param length as for advance()
    void toggle(double length);

    /// The animation's own time that is shown, seconds: frame 0 may be later than its beginning.
    double moment(const scene::GltfChoice& choice) const;
    /// Goes to such a time, not before frame 0.
    void goTo(double moment, const scene::GltfChoice& choice);

    /// The frame at which the scene is shown.
    std::uint32_t frame(const scene::GltfChoice& choice) const;
};

/// What of a file is shown with an animation, or none. @param number of the animation; below 0 none
scene::GltfChoice withAnimation(scene::GltfChoice choice, const scene::OpenedScene& scene, int number);

/// The choice of a command line made ready for playing: a moment without a rate is where playing begins.
/// base::InputError for a frame at no finite moment.
/// @param frame of the command line
Playback playbackOf(scene::GltfChoice& choice, std::uint32_t frame);

/// Seconds that can be played: from frame 0 to the animation's end.
double playableSeconds(const scene::GltfChoice& choice, const scene::OpenedScene& scene);

/// The number of the animation that a choice names; below 0 where it names none.
int chosenNumber(const scene::GltfChoice& choice, const scene::OpenedScene& scene);

} // namespace cdr::viewer
