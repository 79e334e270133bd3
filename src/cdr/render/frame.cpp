#include <cdr/render/frame.h>
#include <cdr/scene/frustum.h>
#include <cdr/shaders/shared.h>

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <limits>

namespace cdr::render {

std::uint32_t Frame::id(std::uint32_t x, std::uint32_t y) const {
    return gbuffer.at(x, y).idAndCascade & shaders::kIdMask;
}

std::uint32_t Frame::cascade(std::uint32_t x, std::uint32_t y) const {
    return (gbuffer.at(x, y).idAndCascade >> shaders::kIdBits) & shaders::kCascadeMask;
}

double Frame::distanceView(std::uint32_t x, std::uint32_t y) const {
    if (id(x, y) == 0) {
        return std::numeric_limits<double>::infinity();
    }
    return anchorsView[cascade(x, y)] + static_cast<double>(gbuffer.at(x, y).ahead);
}

glm::vec3 Frame::normalView(std::uint32_t x, std::uint32_t y) const {
    if (id(x, y) == 0) {
        return glm::vec3(0.0f);
    }
    const glm::vec2 p = glm::unpackSnorm2x16(gbuffer.at(x, y).normal);
    glm::vec3 n(p, 1.0f - std::abs(p.x) - std::abs(p.y));
    if (n.z < 0.0f) {
        const float nx = n.x;
        n.x = (1.0f - std::abs(n.y)) * (n.x >= 0.0f ? 1.0f : -1.0f);
        n.y = (1.0f - std::abs(nx)) * (n.y >= 0.0f ? 1.0f : -1.0f);
    }
    return glm::normalize(n);
}

std::optional<Pick> Frame::pick(std::uint32_t x, std::uint32_t y) const {
    if (id(x, y) == 0) {
        return std::nullopt;
    }
    const scene::Frustum frustum = scene::frustumOf(camera, width(), height());
    const double w = distanceView(x, y);
    const double right = frustum.tanX * (2.0 * (x + 0.5) / width() - 1.0) * w;
    const double up = frustum.tanY * (1.0 - 2.0 * (y + 0.5) / height()) * w;
    const glm::dvec3 facing(normalView(x, y));
    return Pick{.object = id(x, y) - 1,
                .distanceView = w,
                .position = camera.position - w * camera.back + (right * camera.right + up * camera.up),
                .normal = glm::dmat3(camera.right, camera.up, camera.back) * facing};
}

image::ImageU32 Frame::ids() const {
    image::ImageU32 ids(gbuffer.width, gbuffer.height);
    std::transform(gbuffer.pixels.begin(), gbuffer.pixels.end(), ids.pixels.begin(),
                   [](const GBufferPixel& pixel) { return pixel.idAndCascade & shaders::kIdMask; });
    return ids;
}

} // namespace cdr::render
