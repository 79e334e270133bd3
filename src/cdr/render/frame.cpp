#include <cdr/render/frame.h>
#include <cdr/scene/frustum.h>

#include <algorithm>
#include <limits>

namespace cdr::render {

std::uint32_t Frame::id(std::uint32_t x, std::uint32_t y) const {
    return gbuffer.at(x, y).id();
}

std::uint32_t Frame::cascade(std::uint32_t x, std::uint32_t y) const {
    return gbuffer.at(x, y).cascade();
}

double Frame::distanceView(std::uint32_t x, std::uint32_t y) const {
    const GBufferPixel& pixel = gbuffer.at(x, y);
    return pixel.id() == 0 ? std::numeric_limits<double>::infinity() : distanceView(pixel);
}

glm::vec3 Frame::normalView(std::uint32_t x, std::uint32_t y) const {
    return gbuffer.at(x, y).normalView();
}

std::optional<Pick> Frame::pick(std::uint32_t x, std::uint32_t y) const {
    if (x >= gbuffer.width || y >= gbuffer.height || id(x, y) == 0) {
        return std::nullopt;
    }
    const std::uint32_t viewWidth =
        views.empty() ? width() : width() / static_cast<std::uint32_t>(views.size());
    const JoinedView view = views.empty() ? JoinedView{.camera = camera} : views[x / viewWidth];
    const double column = static_cast<double>(x) - static_cast<double>(view.firstColumn);
    const scene::Frustum frustum = scene::frustumOf(view.camera, viewWidth, height());
    const double w = distanceView(x, y);
    const double right = (frustum.tanX * (2.0 * (column + 0.5) / viewWidth - 1.0) + frustum.centre.x) * w;
    const double up = (frustum.tanY * (1.0 - 2.0 * (y + 0.5) / height()) + frustum.centre.y) * w;
    const glm::dvec3 facing(normalView(x, y));
    return Pick{.object = id(x, y) - 1,
                .distanceView = w,
                .position = view.camera.position - w * view.camera.back +
                            (right * view.camera.right + up * view.camera.up),
                .normal = glm::dmat3(view.camera.right, view.camera.up, view.camera.back) * facing};
}

image::ImageU32 Frame::ids() const {
    image::ImageU32 ids(gbuffer.width, gbuffer.height);
    std::ranges::transform(gbuffer.pixels, ids.pixels.begin(), &GBufferPixel::id);
    return ids;
}

} // namespace cdr::render
