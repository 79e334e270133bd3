#pragma once

#include "view_settings.h"

#include <cdr/scene/camera.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace cdr::viewer {

/// One picture on the screen.
struct ReproducedView {
    ViewSettings settings;
    std::size_t side = 0; ///< of a split screen: 0 left, 1 right
    scene::Camera camera;
    scene::Camera sceneCamera; ///< the scene's own at `frame`: what agrees with it is left out
    PictureExtent extent;
    std::uint32_t frame = 0; ///< at which a scene that moves is shown
    std::string device{};    ///< as `--device` names it; empty: the first that can
};

/// The `cdr render` line that draws the same picture without a window, quoted for a POSIX shell, writing to
/// `output`. The camera is the same to the bit if its pose and its field of view are each the scene's own or
/// scene::canonical(). Controllers and recordings keep them so. Otherwise the camera differs by roundings.
///
/// A technique with a fitted split depends on the frames before. There the picture is that of a renderer which
/// begins with this camera. The wrong view is compared with a float64 ray cast instead of the anchored answer.
/// Flips need time, so that view becomes the shaded picture. The ids view has a colour for each object, where the line
/// writes the bits of the ids. In the distance view a pixel may differ by a step of grey.
std::string renderCommand(const ReproducedView& view, std::string_view output = "view.png");

/// The view that renderCommand() calls so. base::InputError with a suggestion for another name.
ViewKind viewOfAov(std::string_view aov);

/// "x,y,z" with as many digits as bring each back to the bit.
std::string exactText(const glm::dvec3& point);

} // namespace cdr::viewer
