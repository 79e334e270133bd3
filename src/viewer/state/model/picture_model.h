#pragma once

#include <viewer/state/picking.h>
#include <viewer/state/requests/render_request.h>
#include <viewer/state/wrong_view.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cdr::viewer {

/// The picture that is shown, and what is known of it.
struct PictureModel {
    std::shared_ptr<const RenderResult> shown; ///< the last that did not fail; null while there is none
    /// By side: the newest frame that picking can read.
    std::array<std::shared_ptr<const render::Frame>, 2> readable;
    std::array<std::optional<PickedPoint>, 2> underCursor;
    std::vector<WrongCount> wrong; ///< by side, the last that were counted with these techniques
    bool isWrongCurrent = false;   ///< of the picture that is shown
    bool seesNothing = false;      ///< no surface is in view
    Measuring measuring;
    std::vector<std::uint32_t> pickedMaterials; ///< in `shown`, of the object that was clicked on last
    std::optional<scene::Camera> clickedCamera; ///< of the picture that was clicked on last
    std::string device; ///< that draws, as `--device` names it; empty: the first that can
};

} // namespace cdr::viewer
