#pragma once

#include <cdr/render/frame.h>
#include <viewer/state/view_settings.h>

#include <optional>

namespace cdr::viewer {

/// How two eyes are shown; empty where there is one.
std::optional<options::StereoPicture> stereoPictureOf(const ViewSettings& settings);

/// What two eyes are fitted to.
struct LookedAt {
    double surfaceView = 0.0;           ///< of what is looked at; where nothing is, eyes are fitted to 1 unit
    double fovY = scene::Camera{}.fovY; ///< of the lens, radians
};

/// The settings with two eyes shown so, or with one. Eyes that were not there before are those of the command line, or else
/// fitted by fitEyes().
ViewSettings withStereo(ViewSettings settings, std::optional<options::StereoPicture> picture,
                        const LookedAt& at);
/// One eye, two side by side, an anaglyph, one eye.
ViewSettings withNextStereo(ViewSettings settings, const LookedAt& at);
/// Two eyes that are turned so. Their pictures coincide at what is looked at where they need a distance and have none.
ViewSettings withEyes(ViewSettings settings, scene::StereoMode mode, const LookedAt& at);
/// The same with the mode that follows. Nothing with one eye.
ViewSettings withOtherEyes(ViewSettings settings, const LookedAt& at);
/// Pictures of the eyes coincide at what is looked at. The eyes are a thirtieth of that distance apart, to three digits, at
/// which most people see one picture. With a narrow lens they are closer together, so that both see it. They take the place of those
/// of the command line.
void fitEyes(ViewSettings& settings, const LookedAt& at);

/// What one eye has of a picture: half of its width where two stand beside each other.
PictureExtent extentOfEye(const ViewSettings& settings, const PictureExtent& picture);
/// A pixel of the picture, in that of the eye that it belongs to.
glm::dvec2 inEye(const ViewSettings& settings, const PictureExtent& picture, const glm::dvec2& pixel);
/// The pixel in the middle of what a camera sees: of two eyes, the left one.
glm::dvec2 middleOf(const render::Frame& frame);
/// How many columns of a frame, from its first, the picture's width stands for: in an anaglyph those of the left eye.
std::uint32_t columnsShown(const ViewSettings& settings, const render::Frame& frame);

/// What a way to show two eyes, or one, means, in a sentence.
std::string_view explanationOf(std::optional<options::StereoPicture> picture);

} // namespace cdr::viewer
