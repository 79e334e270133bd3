#include <cdr/measure/truth/surface_point.h>

#include <array>

namespace cdr::measure {

CornerWeights weightsOf(const Triangle& triangle, const PlacedCamera& camera, const PixelRay& pixel,
                        double shift) {
    const auto weights = [&](double right, double up) {
        const ObjectRay ray = camera.ray(pixel.slopeX + right * pixel.step, pixel.slopeY + up * pixel.step);
        return ShearedRay(ray.from(shift)).weights(triangle);
    };
    return {weights(0.0, 0.0), weights(0.5, 0.0), weights(-0.5, 0.0), weights(0.0, -0.5), weights(0.0, 0.5)};
}

glm::dvec4 SurfacePoint::sampleAt(const scene::TextureUse& use, const glm::dvec3& shares,
                                  double width) const {
    std::array<glm::dvec2, 3> places{};
    for (int c = 0; c < 3; ++c) {
        if (!use.second) {
            places[static_cast<std::size_t>(c)] = glm::dvec2(corner(c).uv);
        } else if (!mesh.details.empty()) {
            places[static_cast<std::size_t>(c)] = glm::dvec2(mesh.details[index(c)].uv);
        }
    }
    for (glm::dvec2& place : places) {
        place = glm::dmat3x2(use.transform) * glm::dvec3(place, 1.0);
    }
    const auto placeAt = [&](const glm::dvec3& at) {
        return at.x * places[0] + at.y * places[1] + at.z * places[2];
    };
    return textures.sample(use.texture, placeAt(shares),
                           {.right = width * placeAt(weights.right - weights.left),
                            .down = width * placeAt(weights.down - weights.up)});
}

glm::dvec4 SurfacePoint::baseColorAt(const glm::dvec3& shares, double width) const {
    glm::dvec4 color(glm::min(material.baseColorFactor, scene::kMaxBaseColor));
    color *=
        interpolateAt(shares, [](const scene::Vertex& vertex) { return glm::dvec4(vertex.color) / 255.0; });
    return material.baseColorTexture
               ? color * sampleAt({.texture = *material.baseColorTexture}, shares, width)
               : color;
}

} // namespace cdr::measure
