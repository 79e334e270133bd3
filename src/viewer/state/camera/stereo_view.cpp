#include "stereo_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace cdr::viewer {

namespace {

constexpr double kEyeShare = 1.0 / 30.0;

/// So that a copied command line is short.
double threeDigits(double value) {
    return std::strtod(fmt::format("{:.3g}", value).c_str(), nullptr);
}

} // namespace

std::optional<options::StereoPicture> stereoPictureOf(const ViewSettings& settings) {
    return settings.views.stereo ? std::optional(settings.views.picture) : std::nullopt;
}

void fitEyes(ViewSettings& settings, double surfaceView) {
    const bool isUsable = std::isfinite(surfaceView) && surfaceView > 0.0;
    settings.views.converge = threeDigits(isUsable ? surfaceView : 1.0);
    settings.views.eyeDistance = threeDigits(*settings.views.converge * kEyeShare);
    settings.givenEyes = {};
}

ViewSettings withStereo(ViewSettings settings, std::optional<options::StereoPicture> picture,
                        double surfaceView) {
    if (!picture) {
        settings.views = {};
        return settings;
    }
    if (!stereoPictureOf(settings)) {
        settings.views = settings.givenEyes;
    }
    if (!stereoPictureOf(settings)) {
        settings.views.stereo = scene::StereoMode::parallel;
        fitEyes(settings, surfaceView);
    }
    settings.views.picture = *picture;
    return settings;
}

ViewSettings withNextStereo(ViewSettings settings, double surfaceView) {
    using options::StereoPicture;
    const std::optional<StereoPicture> now = stereoPictureOf(settings);
    const std::optional<StereoPicture> next = !now ? StereoPicture::sideBySide
                                              : *now == StereoPicture::sideBySide
                                                  ? std::optional(StereoPicture::anaglyph)
                                                  : std::nullopt;
    return withStereo(std::move(settings), next, surfaceView);
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

ViewSettings withOtherEyes(ViewSettings settings) {
    if (settings.views.stereo) {
        const auto& modes = scene::kStereoModes;
        const auto now = std::find(modes.begin(), modes.end(), *settings.views.stereo);
        settings.views.stereo = now + 1 == modes.end() ? modes.front() : *(now + 1);
    }
    return settings;
}

} // namespace cdr::viewer
