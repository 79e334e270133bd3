#include "stereo_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace cdr::viewer {

namespace {

constexpr double kEyeShare = 1.0 / 30.0; ///< of the distance that is looked at
constexpr double kMostEyeShare = 0.1;    ///< of half the picture's height at that distance

/// So that a copied command line is short.
double threeDigits(double value) {
    return std::strtod(fmt::format("{:.3g}", value).c_str(), nullptr);
}

double convergenceAt(const LookedAt& at) {
    const bool isUsable = std::isfinite(at.surfaceView) && at.surfaceView > 0.0;
    return threeDigits(isUsable ? at.surfaceView : 1.0);
}

} // namespace

std::optional<options::StereoPicture> stereoPictureOf(const ViewSettings& settings) {
    return settings.views.stereo ? std::optional(settings.views.picture) : std::nullopt;
}

void fitEyes(ViewSettings& settings, const LookedAt& at) {
    const double share = std::min(kEyeShare, kMostEyeShare * std::tan(0.5 * at.fovY));
    settings.views.converge = convergenceAt(at);
    settings.views.eyeDistance = threeDigits(*settings.views.converge * share);
    settings.givenEyes = {};
}

ViewSettings withStereo(ViewSettings settings, std::optional<options::StereoPicture> picture,
                        const LookedAt& at) {
    if (!picture) {
        settings.views = {};
        return settings;
    }
    if (!stereoPictureOf(settings)) {
        settings.views = settings.givenEyes;
    }
    if (!stereoPictureOf(settings)) {
        settings.views.stereo = scene::StereoMode::parallel;
        fitEyes(settings, at);
    }
    settings.views.picture = *picture;
    return settings;
}

ViewSettings withNextStereo(ViewSettings settings, const LookedAt& at) {
    using options::StereoPicture;
    const std::optional<StereoPicture> now = stereoPictureOf(settings);
    const std::optional<StereoPicture> next = !now ? StereoPicture::sideBySide
                                              : *now == StereoPicture::sideBySide
                                                  ? std::optional(StereoPicture::anaglyph)
                                                  : std::nullopt;
    return withStereo(std::move(settings), next, at);
}

PictureExtent extentOfEye(const ViewSettings& settings, const PictureExtent& picture) {
    const std::uint32_t eyes = stereoPictureOf(settings) == options::StereoPicture::sideBySide ? 2 : 1;
    return {.width = std::max(picture.width / eyes, 1u), .height = picture.height};
}

glm::dvec2 inEye(const ViewSettings& settings, const PictureExtent& picture, const glm::dvec2& pixel) {
    const double width = extentOfEye(settings, picture).width;
    const bool isInRight = width < picture.width && pixel.x >= width;
    return {isInRight ? std::min(pixel.x - width, width - 0.5) : pixel.x, pixel.y};
}

glm::dvec2 middleOf(const render::Frame& frame) {
    const double views = frame.views.empty() ? 1.0 : static_cast<double>(frame.views.size());
    return {frame.width() / (2.0 * views), frame.height() / 2.0};
}

std::uint32_t columnsShown(const ViewSettings& settings, const render::Frame& frame) {
    const bool isAnaglyph = stereoPictureOf(settings) == options::StereoPicture::anaglyph;
    return isAnaglyph && !frame.views.empty()
               ? frame.gbuffer.width / static_cast<std::uint32_t>(frame.views.size())
               : frame.width();
}

std::string_view explanationOf(std::optional<options::StereoPicture> picture) {
    if (!picture) {
        return "One eye.";
    }
    return *picture == options::StereoPicture::anaglyph
               ? "Two eyes in one picture: for glasses with a red left and a cyan right lens."
               : "Two eyes side by side, the left one at the left: look through the window until they meet.";
}

ViewSettings withEyes(ViewSettings settings, scene::StereoMode mode, const LookedAt& at) {
    settings.views.stereo = mode;
    const bool lookAhead = settings.givenEyes.stereo && !settings.givenEyes.converge;
    if (mode == scene::StereoMode::parallel && lookAhead) {
        settings.views.converge.reset(); // as on the command line
    } else if (mode != scene::StereoMode::parallel && !settings.views.converge) {
        settings.views.converge = convergenceAt(at);
    }
    return settings;
}

ViewSettings withOtherEyes(ViewSettings settings, const LookedAt& at) {
    if (!settings.views.stereo) {
        return settings;
    }
    const auto& modes = scene::kStereoModes;
    const auto next = std::find(modes.begin(), modes.end(), *settings.views.stereo) + 1;
    return withEyes(std::move(settings), next == modes.end() ? modes.front() : *next, at);
}

} // namespace cdr::viewer
