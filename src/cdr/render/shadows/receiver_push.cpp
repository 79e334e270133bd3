#include <cdr/render/shadows/receiver_push.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cdr::render {

namespace {

/// Of a distance, which may be beyond the range of floats.
float toFloat(double distance) {
    return static_cast<float>(std::min(distance, static_cast<double>(std::numeric_limits<float>::max())));
}

} // namespace

shaders::ReceiverPush receiverPush(const LightView& view, const FrameView& frame,
                                   const ReceiverOptions& options) {
    const scene::Camera& camera = frame.camera;
    const float referenceView = options.isPlain ? 0.0f : toFloat(camera.viewDistance(view.origin));
    const glm::dvec3 place =
        view.toLight((camera.position - view.origin) - camera.back * static_cast<double>(referenceView));
    const double halfStep = std::exp2(-1.0 - options.subPixelBits); // pixels, and texels
    // Of the map; the rest of the image is of other maps.
    const shaders::ivec2 last(static_cast<std::int32_t>(view.size.width) - 1,
                              static_cast<std::int32_t>(view.size.height) - 1);
    const auto row = [&](const glm::dvec3& axis, double offset) {
        return glm::vec4(glm::dot(axis, camera.right), glm::dot(axis, camera.up),
                         -glm::dot(axis, camera.back), offset);
    };
    return {.right = row(view.right, place.x),
            .up = row(view.up, place.y),
            .ahead = row(view.ahead, place.z),
            .low = view.low,
            .mapCorner = {options.corner.x, options.corner.y},
            .nearView = toFloat(view.nearView),
            .farView = toFloat(view.farView),
            .referenceView = referenceView,
            .lens = view.lens(),
            .snap = static_cast<float>(frame.frustum.footprintSlope * halfStep),
            .mapSnap = static_cast<float>(halfStep),
            .channel = static_cast<std::uint32_t>(view.channel),
            .isPlain = options.isPlain ? 1u : 0u,
            .mapLast = last,
            // A texel less than the border, so that neighbouring parts overlap.
            .part = view.isPart ? shaders::vec2(last) : shaders::vec2(0.0f)};
}

} // namespace cdr::render
