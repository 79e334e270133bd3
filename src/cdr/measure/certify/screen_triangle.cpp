#include <cdr/measure/certify/screen_triangle.h>
#include <cdr/measure/truth/lens.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace cdr::measure {

namespace {

/// What the device snaps by, so many times, is the most that a drawn distance is off for its corners' sake. A corner close to the
/// eye may be off by more, but that hardly moves the plane between the corners.
constexpr double kMostSnaps = 4.0;

double cross2(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

double sumOf(const glm::dvec2& v) {
    return std::abs(v.x) + std::abs(v.y);
}

glm::dmat3 magnitudesOf(const glm::dmat3& m) {
    return {glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2])};
}

/// A triangle's plane in view space, formed at a corner.
struct Plane {
    glm::dvec3 corner;
    glm::dvec3 u; ///< edges from there
    glm::dvec3 v;
    glm::dvec3 normal = glm::cross(u, v);
    double distance = glm::dot(normal, corner);

    /// By how much the view distance along a ray may be off up to `mostView`, since float64 rounds the plane. A sliver's normal
    /// is rounded most, and counts most far from the corner.
    double rounding(double mostView) const {
        const double lengthU = glm::length(u);
        const double lengthV = glm::length(v);
        const double turned = lengthU * lengthV * std::max(lengthU, lengthV);
        const double moved = glm::length(normal) * glm::length(corner);
        return kDoubleOperation * (turned + moved) * mostView / std::abs(distance);
    }
};

} // namespace

InstanceTriangles::InstanceTriangles(const scene::Camera& camera, std::uint32_t width, std::uint32_t height,
                                     const DeviceBound& bound, const DeviceBound& device)
    : m_camera(camera),
      m_bound(bound),
      m_device(device),
      m_clipView(0.5 * camera.nearView),
      m_pixelsPerSlope(pixelsPerSlope(camera, height)),
      m_axis(axisPixel(camera, width, height)) {}

glm::dvec2 InstanceTriangles::pixelOf(const glm::dvec3& view) const {
    const double scale = m_pixelsPerSlope / view.z;
    return {m_axis.x + view.x * scale, m_axis.y - view.y * scale};
}

TriangleBound InstanceTriangles::boundOf(const DeviceBound& bound, double leastView, double mostView) const {
    return bound.of({.leastView = leastView,
                     .mostView = mostView,
                     .acrossView = m_acrossView,
                     .alongView = m_alongView,
                     .summedView = m_summedView,
                     .layer = m_layer});
}

void InstanceTriangles::place(const scene::Instances& instances, std::size_t instance,
                              const MeshOutline& outline) {
    const glm::dmat3 basis(instances.basis[instance]);
    const glm::dmat3 toView = glm::transpose(glm::dmat3(m_camera.right, m_camera.up, -m_camera.back));
    const glm::dmat3 objectToView = toView * basis;
    const glm::dvec3 fromCamera = instances.position(instance) - m_camera.position;
    m_centre = toView * fromCamera;
    m_offsets.resize(outline.positions.size());
    std::transform(outline.positions.begin(), outline.positions.end(), m_offsets.begin(),
                   [&](const glm::dvec3& position) { return objectToView * position; });
    const glm::dvec3 products = magnitudesOf(objectToView) * outline.reach;
    m_acrossView = std::max(std::abs(m_centre.x) + products.x, std::abs(m_centre.y) + products.y);
    m_alongView = products.z;
    // What cancels in the products of the two matrices was rounded all the same.
    const glm::dvec3 sums =
        magnitudesOf(toView) * (glm::abs(fromCamera) + magnitudesOf(basis) * outline.reach);
    m_summedView = std::max({sums.x, sums.y, sums.z});
}

InstanceTriangles::Side InstanceTriangles::sideOf(const MeshOutline::Face& face, const MeshOutline& outline,
                                                  const glm::dvec3& eye) const {
    const auto& [a, b, c] = face.corners;
    const glm::dvec3& origin = outline.positions[a];
    // In object space, so a basis that mirrors keeps its fronts.
    const glm::dvec3 normal = glm::cross(outline.positions[b] - origin, outline.positions[c] - origin);
    const Side side = glm::dot(normal, eye - origin) > 0.0 ? Side::front : Side::back;
    const Polygon polygon = clipped(face, {});
    bool isThin = polygon.count > 2;
    for (std::size_t i = 2; i < polygon.count; ++i) {
        isThin = isThin && partOf({polygon.corners[0], polygon.corners[i - 1], polygon.corners[i]}).isThin;
    }
    return isThin ? Side::thin : side;
}

void InstanceTriangles::decideSides(const MeshOutline& outline, const glm::dvec3& eye) {
    m_sides.resize(outline.faces.size());
    std::transform(outline.faces.begin(), outline.faces.end(), m_sides.begin(),
                   [&](const MeshOutline::Face& face) { return sideOf(face, outline, eye); });
}

InstanceTriangles::Polygon InstanceTriangles::clipped(const MeshOutline::Face& face,
                                                      const std::array<bool, 3>& goesOn) const {
    Polygon polygon;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 from = m_centre + m_offsets[face.corners[i]];
        const glm::dvec3 to = m_centre + m_offsets[face.corners[(i + 1) % 3]];
        const bool isFromIn = from.z >= m_clipView;
        const bool isToIn = to.z >= m_clipView;
        if (isFromIn) {
            polygon.corners[polygon.count++] = {from, goesOn[i]};
        }
        if (isFromIn != isToIn) {
            const double along = (m_clipView - from.z) / (to.z - from.z);
            const glm::dvec3 cut(from.x + (to.x - from.x) * along, from.y + (to.y - from.y) * along,
                                 m_clipView);
            // The edge along the clip plane lies before near, where nothing is drawn.
            polygon.corners[polygon.count++] = {cut, isToIn ? goesOn[i] : true};
        }
    }
    return polygon;
}

ScreenTriangle InstanceTriangles::partOf(const std::array<Corner, 3>& corners) const {
    ScreenTriangle part;
    part.leastView = std::min({corners[0].view.z, corners[1].view.z, corners[2].view.z});
    part.mostView = std::max({corners[0].view.z, corners[1].view.z, corners[2].view.z});
    part.bound = boundOf(m_bound, part.leastView, part.mostView);
    for (std::size_t i = 0; i < 3; ++i) {
        part.corners[i] = pixelOf(corners[i].view);
        part.goesOn[i] = corners[i].goesOn;
    }
    const glm::dvec2 u = part.corners[1] - part.corners[0];
    const glm::dvec2 v = part.corners[2] - part.corners[0];
    const double off = part.bound.pixels;
    // By how much moving each corner can change twice the area.
    const double change = 1.5 * off * (sumOf(u) + sumOf(v) + sumOf(v - u)) + 8.0 * off * off;
    const double area = cross2(u, v);
    part.isThin = !(std::abs(area) > change);
    if (area < 0.0) {
        std::swap(part.corners[1], part.corners[2]);
        std::swap(part.goesOn[0], part.goesOn[2]); // the middle edge stays between the same corners
    }
    return part;
}

void InstanceTriangles::append(const MeshOutline::Face& face, Side side) {
    std::array<bool, 3> goesOn{};
    for (std::size_t edge = 0; edge < 3; ++edge) {
        const std::uint32_t across = face.neighbours[edge];
        goesOn[edge] = side != Side::thin && across != MeshOutline::kNoNeighbour && m_sides[across] == side;
    }
    const glm::dvec3& origin = m_offsets[face.corners[0]];
    const Plane plane{.corner = m_centre + origin,
                      .u = m_offsets[face.corners[1]] - origin,
                      .v = m_offsets[face.corners[2]] - origin};
    const glm::dvec3 perSlope = plane.normal / plane.distance;
    const double alongX = perSlope.x / m_pixelsPerSlope;
    const double alongY = -perSlope.y / m_pixelsPerSlope;
    const std::array<double, 3> inverse{perSlope.z - alongX * m_axis.x - alongY * m_axis.y, alongX, alongY};
    const Polygon polygon = clipped(face, goesOn);
    for (std::size_t i = 2; i < polygon.count; ++i) {
        std::array corners{polygon.corners[0], polygon.corners[i - 1], polygon.corners[i]};
        // Between the two parts of a polygon the surface goes on.
        corners[0].goesOn = i > 2 || corners[0].goesOn;
        corners[2].goesOn = i + 1 < polygon.count || corners[2].goesOn;
        ScreenTriangle& part = m_triangles.emplace_back(partOf(corners));
        part.inverse = inverse;
        part.first = face.first;
        part.drawnBound =
            &m_device == &m_bound ? part.bound : boundOf(m_device, part.leastView, part.mostView);
        part.drawnBound.pixels = std::min(part.drawnBound.pixels, kMostSnaps * m_device.snapPixels());
        // Of a thin one nothing is taken for sure.
        if (!part.isThin) {
            const double rounding = plane.rounding(part.mostView);
            part.bound.distanceView += rounding;
            part.drawnBound.distanceView += rounding;
        }
    }
}

const std::vector<ScreenTriangle>& InstanceTriangles::of(const scene::Instances& instances,
                                                         std::size_t instance, const MeshOutline& outline,
                                                         const LayerOffset& layer, Sidedness sides) {
    m_layer = layer;
    m_triangles.clear();
    const std::optional<InverseBasis> inverse = invertBasis(instances.basis[instance]);
    if (!inverse) {
        return m_triangles;
    }
    place(instances, instance, outline);
    decideSides(outline, inverse->worldToObject * (m_camera.position - instances.position(instance)));
    for (std::size_t i = 0; i < outline.faces.size(); ++i) {
        if (m_sides[i] != Side::back || sides == Sidedness::both) {
            append(outline.faces[i], m_sides[i]);
        }
    }
    return m_triangles;
}

} // namespace cdr::measure
