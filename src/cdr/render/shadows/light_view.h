#pragma once

#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/shadows/receiver_slices.h>
#include <cdr/scene/scene.h>
#include <cdr/shaders/shadows_shared.h>

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace cdr::render {

/// What a light sees of the surfaces of a slice, and of all that lies between. Positions are relative to `origin`, which is
/// subtracted in float64. So what is near it keeps its place, however far away the light and the world's origin are.
struct LightView {
    std::size_t slice = 0;   ///< of the frame's
    std::size_t channel = 0; ///< of the mask: the light's place in scene::shadowLights()
    double nearView = 0.0;   ///< ReceiverSlice
    double farView = 0.0;
    glm::dvec3 origin{0.0};          ///< world space
    glm::dvec3 right{1.0, 0.0, 0.0}; ///< world axes, unit, as all three
    glm::dvec3 up{0.0, 1.0, 0.0};
    glm::dvec3 ahead{0.0, 0.0, 1.0}; ///< away from the light
    double wOffset = 1.0;            ///< w: wOffset + wPerUnit * ahead
    double wPerUnit = 0.0;
    glm::dvec2 low{0.0};    ///< of right / w and up / w, at the map's first texel's corner
    double texel = 1.0;     ///< in those units; a power of two, or 1.5 times one
    vk::Extent2D size;      ///< texels
    double nearAhead = 0.0; ///< of what is drawn, the nearest to the light
    double farAhead = 0.0;  ///< of the receivers, the farthest from it
    bool isPart = false;    ///< its map decides about what it shows alone: dividedView()

    bool isDistant() const { return wOffset != 0.0; }
    /// A place relative to the origin, along the three axes.
    glm::dvec3 toLight(const glm::dvec3& relative) const {
        return {glm::dot(right, relative), glm::dot(up, relative), glm::dot(ahead, relative)};
    }
    double w(double distanceAhead) const { return wOffset + wPerUnit * distanceAhead; }
    /// @param nearAhead of the nearest caster; behind it nothing is drawn.
    shaders::LightLens lens() const;
};

/// Of a convex body, right / w and up / w.
using SeenCorners = std::array<glm::dvec2, 8>;

/// A convex body as a view sees it; nothing where it reaches behind the light.
/// @param shift from what corners are relative to, to the view's origin.
std::optional<SeenCorners> seenBy(const LightView& view, const std::array<glm::dvec3, 8>& corners,
                                  const glm::dvec3& shift);

/// Texels around what is read: of the two by two that a receiver reads, and of roundings.
inline constexpr std::uint32_t kMapBorder = 2;

/// The views of a light that show a slice's surfaces. One from a distance, else one for each side of the light that faces
/// some. None where the slice's surfaces fill no space, or where the light's cone and range leave them dark.
/// @param camera position that the slice is relative to.
/// @param footprintSlope scene::Frustum: no texel is much smaller than a pixel.
/// @param maxTexels of a side of a map.
std::vector<LightView> lightViews(const scene::PointLight& light, const glm::dvec3& camera,
                                  const ReceiverSlice& slice, double footprintSlope, std::uint32_t maxTexels);
} // namespace cdr::render
