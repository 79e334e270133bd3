#include <scenes/degree.h>
#include <scenes/orbit/station.h>
#include <scenes/solids.h>

#include <array>
#include <cmath>

namespace cdr::scenes {

namespace {

/// Half angles of the window's opening, as the eye sees it.
const double kHalfWidth = kWindowDistance * std::tan(41.0 * kDegree);
const double kHalfHeight = kWindowDistance * std::tan(39.0 * kDegree);

/// The space of a window: x right, y up along the glass, z back to the eye, which is the origin.
class WindowSpace {
  public:
    WindowSpace(SceneBuilder& builder, const StationPose& pose) : m_builder(builder), m_eye(pose.eye) {
        const double tilt = kWindowTilt * kDegree;
        const glm::dvec3 ahead = std::cos(tilt) * pose.forward - std::sin(tilt) * pose.up;
        const glm::dvec3 right = glm::normalize(glm::cross(pose.forward, pose.up));
        m_axes = glm::dmat3(right, glm::cross(right, ahead), -ahead);
    }

    void box(std::uint32_t material, const glm::dvec3& centre, const glm::dvec3& halfSides,
             double turnDegrees = 0.0) const {
        const double turn = turnDegrees * kDegree;
        const glm::dmat3 turned(std::cos(turn), std::sin(turn), 0.0, -std::sin(turn), std::cos(turn), 0.0,
                                0.0, 0.0, 1.0);
        m_builder.addBox(material, m_eye + m_axes * centre, halfSides, m_axes * turned);
    }

    /// A solid turned about its x axis, which goes to `axis`.
    void solid(std::uint32_t material, const scene::SourceMesh& mesh, const glm::dvec3& centre,
               const glm::dvec3& axis) const {
        const glm::dvec3 x = glm::normalize(axis);
        const glm::dvec3 other = std::abs(x.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
        const glm::dvec3 z = glm::normalize(glm::cross(x, other));
        const glm::dmat3 basis = m_axes * glm::dmat3(x, glm::cross(z, x), z);
        glm::dmat4 place(basis);
        place[3] = glm::dvec4(m_eye + m_axes * centre, 1.0);
        m_builder.addMesh(material, mesh, place);
    }

  private:
    SceneBuilder& m_builder;
    glm::dvec3 m_eye;
    glm::dmat3 m_axes;
};

scene::SourceMesh rod(std::string name, double length, double radius) {
    const double half = 0.5 * length;
    const std::array<glm::dvec2, 6> outline{{{-half, 0.0},
                                             {-half, radius},
                                             {-half, radius}, // twice for an edge
                                             {half, radius},
                                             {half, radius},
                                             {half, 0.0}}};
    return turnedSolid(std::move(name), outline, 24);
}

void addFrame(SceneBuilder& builder, const WindowSpace& window) {
    const std::uint32_t metal = builder.addMaterial("frame", glm::vec3(0.3f, 0.3f, 0.32f));
    const std::uint32_t seal = builder.addMaterial("seal", glm::vec3(0.04f));
    const std::uint32_t steel = builder.addMaterial("bolts", glm::vec3(0.55f));
    const double beam = 0.02;
    const double z = -kWindowDistance;
    builder.beginObject("window frame");
    for (const double side : {-1.0, 1.0}) {
        // Wide enough that no lens of 60 degrees looks past it.
        window.box(metal, {side * (kHalfWidth + 0.25), 0.0, z - 0.02}, {0.25, 0.6, 0.02});
        window.box(metal, {0.0, side * (kHalfHeight + 0.25), z - 0.02}, {kHalfWidth + 0.001, 0.25, 0.02});
        window.box(metal, {side * (kHalfWidth + beam), 0.0, z + 0.01}, {beam, kHalfHeight + 2 * beam, 0.01});
        window.box(metal, {0.0, side * (kHalfHeight + beam), z + 0.01}, {kHalfWidth, beam, 0.01});
    }
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
            window.box(metal, {x * (kHalfWidth - 0.01), y * (kHalfHeight - 0.01), z}, {0.05, 0.016, 0.02},
                       x * y * -45.0);
        }
    }
    builder.beginObject("window seal");
    for (const double side : {-1.0, 1.0}) {
        window.box(seal, {side * (kHalfWidth - 0.002), 0.0, z}, {0.003, kHalfHeight, 0.004});
        window.box(seal, {0.0, side * (kHalfHeight - 0.002), z}, {kHalfWidth, 0.003, 0.004});
    }
    builder.beginObject("window bolts");
    const scene::SourceMesh bolt = rod("bolt", 0.004, 0.005);
    for (int i = 0; i < 7; ++i) {
        const double along = (i - 3) / 3.5;
        for (const double side : {-1.0, 1.0}) {
            const glm::dvec3 axis(0.0, 0.0, 1.0);
            window.solid(steel, bolt, {side * (kHalfWidth + beam), along * kHalfHeight, z + 0.022}, axis);
            window.solid(steel, bolt, {along * kHalfWidth, side * (kHalfHeight + beam), z + 0.022}, axis);
        }
    }
}

void addHandrail(SceneBuilder& builder, const WindowSpace& window) {
    const std::uint32_t gold = builder.addMaterial("handrail", glm::vec3(0.75f, 0.55f, 0.12f));
    builder.beginObject("handrail");
    window.solid(gold, rod("rail", 0.9, 0.016), {0.62, 0.05, -1.0}, {0.25, 1.0, 0.0});
    for (const double along : {-0.4, 0.4}) {
        window.solid(gold, rod("post", 0.3, 0.012), {0.62 + 0.25 * along + 0.12, 0.05 + along, -1.02},
                     {1.0, 0.0, -0.2});
    }
}

/// A panel of cells in its own frame, the cells 2 mm proud of it.
void addPanel(SceneBuilder& builder, const WindowSpace& window, const glm::dvec3& centre, int columns,
              int rows) {
    const std::uint32_t back = builder.addMaterial("panel", glm::vec3(0.5f, 0.35f, 0.12f));
    const std::uint32_t cell = builder.addMaterial("cells", glm::vec3(0.02f, 0.03f, 0.12f));
    constexpr double kCell = 1.0;
    builder.beginObject("solar panel");
    window.box(back, centre, {0.5 * kCell * columns, 0.5 * kCell * rows, 0.03}, 8.0);
    builder.beginObject("solar cells");
    const double turn = 8.0 * kDegree;
    for (int column = 0; column < columns; ++column) {
        for (int row = 0; row < rows; ++row) {
            const double x = kCell * (column + 0.5 - 0.5 * columns);
            const double y = kCell * (row + 0.5 - 0.5 * rows);
            const glm::dvec3 aside(x * std::cos(turn) - y * std::sin(turn),
                                   x * std::sin(turn) + y * std::cos(turn), 0.031);
            window.box(cell, centre + aside, {0.47 * kCell, 0.47 * kCell, 0.001}, 8.0);
        }
    }
}

void addTruss(SceneBuilder& builder, const WindowSpace& window) {
    const std::uint32_t white = builder.addMaterial("truss", glm::vec3(0.6f));
    builder.beginObject("truss");
    for (const double y : {-0.4, 0.4}) {
        for (const double z : {-0.4, 0.4}) {
            window.box(white, {-11.0, 7.5 + y, -18.0 + z}, {6.0, 0.04, 0.04});
        }
    }
    for (int i = 0; i <= 12; ++i) {
        const double x = -17.0 + i;
        window.box(white, {x, 7.5, -17.6}, {0.03, 0.57, 0.03}, i % 2 == 0 ? 45.0 : -45.0);
        window.box(white, {x, 7.5, -18.4}, {0.03, 0.57, 0.03}, i % 2 == 0 ? -45.0 : 45.0);
    }
}

} // namespace

void addStation(SceneBuilder& builder, const StationPose& pose) {
    const WindowSpace window(builder, pose);
    addFrame(builder, window);
    addHandrail(builder, window);
    addTruss(builder, window);
    addPanel(builder, window, {-17.0, 12.0, -30.0}, 8, 5);
    addPanel(builder, window, {23.0, 9.0, -38.0}, 5, 9);
}

} // namespace cdr::scenes
