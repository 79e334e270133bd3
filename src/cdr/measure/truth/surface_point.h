#pragma once

#include <cdr/measure/truth/object_ray.h>
#include <cdr/measure/truth/triangle_hit.h>
#include <cdr/measure/truth/truth_texture.h>
#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>

namespace cdr::measure {

/// A pixel's ray, and those of its neighbours.
struct PixelRay {
    double slopeX = 0.0; ///< as PixelSlopes has them
    double slopeY = 0.0;
    double step = 0.0; ///< from a pixel to the next, either way
};

/// The weights of a triangle's corners, where a pixel's ray meets it and half a pixel to each side. What the triangle lies
/// in goes on beyond its edges.
struct CornerWeights {
    glm::dvec3 here;
    glm::dvec3 right;
    glm::dvec3 left;
    glm::dvec3 down;
    glm::dvec3 up;
};

/// @param shift along all of the rays, of where they start.
CornerWeights weightsOf(const Triangle& triangle, const PlacedCamera& camera, const PixelRay& pixel,
                        double shift);

/// A point of a triangle, which its material's textures are read at.
struct SurfacePoint {
    const scene::Scene& scene;
    const TruthTextures& textures; ///< of the scene
    const scene::Material& material;
    const scene::Mesh& mesh;
    std::size_t triangle; ///< the first of its three indices
    CornerWeights weights;

    const scene::Vertex& corner(int c) const { return mesh.vertices[index(c)]; }
    std::uint32_t index(int c) const { return mesh.indices[triangle + static_cast<std::size_t>(c)]; }

    /// A value of the vertices.
    template <typename Value>
    auto interpolate(Value valueOf) const {
        return interpolateAt(weights.here, valueOf);
    }
    template <typename Value>
    auto interpolateAt(const glm::dvec3& shares, Value valueOf) const {
        return shares.x * valueOf(corner(0)) + shares.y * valueOf(corner(1)) + shares.z * valueOf(corner(2));
    }

    /// What a texture of the material holds there, linear.
    glm::dvec4 sample(const scene::TextureUse& use) const { return sampleAt(use, weights.here, 1.0); }
    /// The same beside the point.
    /// @param shares of the corners. @param width of the pixel, as a share of its own: it decides which level is read.
    glm::dvec4 sampleAt(const scene::TextureUse& use, const glm::dvec3& shares, double width) const;

    /// Linear, straight alpha: factor, vertex colour and texture.
    glm::dvec4 baseColor() const { return baseColorAt(weights.here, 1.0); }
    /// The same beside the point, as sampleAt().
    glm::dvec4 baseColorAt(const glm::dvec3& shares, double width) const;
};

} // namespace cdr::measure
