#pragma once

#include <cdr/measure/certify/device_bound.h>
#include <cdr/measure/certify/mesh_outline.h>
#include <cdr/measure/truth/object_ray.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cdr::measure {

/// A triangle as the picture has it, in float64. Pixel (i, j) has its centre at (i, j).
struct ScreenTriangle {
    std::array<glm::dvec2, 3> corners; ///< pixels, in the order in which the area is positive
    /// Whether the surface goes on across the edge from corner i to the next, seen from the same side.
    std::array<bool, 3> goesOn{};
    /// Seen so flatly that the device may take it for its other side: it may cover pixels near its edges, and no other.
    bool isThin = false;
    double leastView = 0.0; ///< view distance of the nearest corner
    double mostView = 0.0;  ///< of the farthest
    /// Along a ray, 1 / distance is inverse[0] + inverse[1] * x + inverse[2] * y.
    std::array<double, 3> inverse{};
    TriangleBound bound;
    TriangleBound
        drawnBound;          ///< how far off the distance may be that the device drew, whatever `bound` is of
    std::uint32_t first = 0; ///< MeshOutline::Face::first
};

/// Makes an instance's triangles that face the camera, or may.
class InstanceTriangles {
  public:
    /// @param bound of the triangles: the device's, or float64's.
    /// @param device that drew the picture.
    InstanceTriangles(const scene::Camera& camera, std::uint32_t width, std::uint32_t height,
                      const DeviceBound& bound, const DeviceBound& device);

    /// The triangles of an instance, until the next call.
    /// @param outline of the instance's mesh.
    /// @param layer of its material.
    /// @param sides which are drawn.
    const std::vector<ScreenTriangle>& of(const scene::Instances& instances, std::size_t instance,
                                          const MeshOutline& outline, const LayerOffset& layer,
                                          Sidedness sides);

  private:
    enum class Side : std::int8_t { back = -1, thin = 0, front = 1 };
    /// A corner of a polygon, and of the edge that begins there whether the surface goes on beyond it.
    struct Corner {
        glm::dvec3 view; ///< right, up, ahead
        bool goesOn;
    };
    struct Polygon {
        std::array<Corner, 4> corners;
        std::size_t count = 0;
    };

    void place(const scene::Instances& instances, std::size_t instance, const MeshOutline& outline);
    void decideSides(const MeshOutline& outline, const glm::dvec3& eye);
    Side sideOf(const MeshOutline::Face& face, const MeshOutline& outline, const glm::dvec3& eye) const;
    void append(const MeshOutline::Face& face, Side side);
    Polygon clipped(const MeshOutline::Face& face, const std::array<bool, 3>& goesOn) const;
    /// Its place in the picture, but for `inverse`.
    ScreenTriangle partOf(const std::array<Corner, 3>& corners) const;
    TriangleBound boundOf(const DeviceBound& bound, double leastView, double mostView) const;
    glm::dvec2 pixelOf(const glm::dvec3& view) const;

    const scene::Camera& m_camera;
    const DeviceBound& m_bound;
    const DeviceBound& m_device;
    double m_clipView;
    double m_pixelsPerSlope;
    glm::dvec2 m_axis;         ///< axisPixel()
    glm::dvec3 m_centre{0.0};  ///< view space, of the instance
    double m_acrossView = 0.0; ///< TriangleReach, of the instance
    double m_alongView = 0.0;
    double m_summedView = 0.0;
    LayerOffset m_layer;
    std::vector<glm::dvec3> m_offsets; ///< of corners from the centre, along the view's axes
    std::vector<Side> m_sides;
    std::vector<ScreenTriangle> m_triangles;
};

} // namespace cdr::measure
