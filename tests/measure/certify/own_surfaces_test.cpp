#include "../test_scenes.h"
#include "drawn_by_rays.h"

#include <scenes/sheets.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace cdr::test {
namespace {

using measure::Certificate;
using measure::DrawnFrame;

constexpr RayDevice kOddPicture{.width = 161, .height = 91}; // the axis is at the centre of a pixel
constexpr std::uint32_t kMiddleColumn = 80;
constexpr std::uint32_t kMiddleRow = 45;

/// A wall, and a floor of the same object from before it to behind it, which is seen along its plane.
TEST(OwnSurfaces, ADistanceIsRepairedThatIsNeitherTheSurfacesNorAThinTriangles) {
    scene::Scene scene = makeEmptyScene();
    scene::Mesh& square = scene.meshes[kTriangleCube];
    const auto corner = [](float x, float z) {
        return scene::Vertex{.position = {x, 0.0f, z}, .normal = {0.0f, 1.0f, 0.0f}};
    };
    square.vertices = {corner(-1, 1), corner(1, 1), corner(1, -1), corner(-1, -1)};
    square.indices = {0, 1, 2, 0, 2, 3};
    scene::addInstance(scene, kCube, kSingleSided, 0, {0.0, 0.0, -550.0}, glm::mat3(100.0f));
    scene::addInstance(scene, kTriangleCube, kDoubleSided, 0, {0.0, -1e-5, -500.0}, glm::mat3(100.0f));
    DrawnFrame frame = drawnByRays(scene, makePlainCamera(), kEightBits, kOddPicture);
    ASSERT_EQ(frame.ids.at(kMiddleColumn, kMiddleRow), 1u);
    ASSERT_EQ(frame.distancesView.at(kMiddleColumn, kMiddleRow), 500.0);
    for (const double drawn : {399.0, 450.0, 550.0}) {
        frame.distancesView.at(kMiddleColumn, kMiddleRow) = drawn;
        const Certificate certificate = certified(scene, frame);
        EXPECT_EQ(certificate.refused, 0u);
        const auto isOfIt = [](const auto& repair) {
            return repair.x == kMiddleColumn && repair.y == kMiddleRow && repair.distanceView == 500.0;
        };
        EXPECT_EQ(std::ranges::count_if(certificate.repairs, isOfIt), 1) << drawn;
    }
}

/// A logarithm bends between the corners of a large triangle, so what is drawn may be the finer sheet behind it.
TEST(OwnSurfaces, ADistanceIsRepairedThatIsOfAFinerSurfaceBehind) {
    scene::Scene scene = makeEmptyScene();
    const auto slope = [](std::uint32_t columns) {
        scene::Mesh mesh;
        for (std::uint32_t i = 0; i <= columns; ++i) {
            const float share = static_cast<float>(i) / static_cast<float>(columns);
            for (const float y : {-200.0f, 200.0f}) {
                mesh.vertices.push_back(
                    {.position = {600.0f * share - 300.0f, y, -20.0f * share}, .normal = {0.0f, 0.0f, 1.0f}});
            }
        }
        for (std::uint32_t i = 0; i < 2 * columns; i += 2) {
            mesh.indices.insert(mesh.indices.end(), {i, i + 2, i + 3, i, i + 3, i + 1});
        }
        mesh.boundingRadius = 400.0f;
        return mesh;
    };
    scene.meshes[kCube] = slope(1);
    scene.meshes[kTriangleCube] = slope(32);
    scene::addInstance(scene, kCube, kDoubleSided, 0, {0.0, 0.0, -1000.0}, glm::mat3(1.0f));
    scene::addInstance(scene, kTriangleCube, kDoubleSided, 0, {0.0, 0.0, -1000.025}, glm::mat3(1.0f));
    scene::Camera camera = makePlainCamera();
    camera.farView = 1e4;
    DrawnFrame frame = drawnByRays(scene, camera, kEightBits, kOddPicture);
    frame.technique = depth::parseTechnique("log");
    frame.cascades = {{camera.nearView, camera.farView}};
    const double right = frame.distancesView.at(80, 40);
    ASSERT_NEAR(right, 1010.0, 0.1);
    frame.distancesView.at(80, 40) += 0.025;
    const Certificate certificate = certified(scene, frame);
    EXPECT_EQ(certificate.refused, 0u);
    ASSERT_EQ(certificate.repairs.size(), 1u);
    EXPECT_EQ(certificate.repairs[0].distanceView, right);
}

/// An object of squares: ground that reaches from behind the camera to far away, a cellar's floor below it, and two walls that
/// stand on it, one behind the other.
struct House {
    scene::Scene scene = makeEmptyScene();
    scene::Camera camera = makePlainCamera();
    DrawnFrame frame;
    DrawnFrame hidden; ///< what the ground and the first wall hide

    House() {
        scene.meshes.push_back(scenes::makeSquare(1.0f));
        const glm::mat3 lying(glm::vec3(1.0f, 0.0f, 0.0f), glm::vec3(0.0f, 0.0f, -1.0f),
                              glm::vec3(0.0f, 1.0f, 0.0f));
        add({0.0, 4.0, -40.0}, 6.0f * glm::mat3(1.0f));
        add({0.0, -4.0, 0.0}, 500.0f * lying);
        hidden = drawn();
        add({0.0, 4.0, -20.0}, 6.0f * glm::mat3(1.0f));
        add({0.0, -2.0, 0.0}, 500.0f * lying);
        frame = drawn();
    }

  private:
    void add(const glm::dvec3& position, const glm::mat3& basis) {
        const auto square = static_cast<std::uint32_t>(scene.meshes.size()) - 1;
        scene::addInstance(scene, square, kDoubleSided, 0, position, basis);
    }
    DrawnFrame drawn() const {
        DrawnFrame made = drawnByRays(scene, camera, kEightBits);
        made.technique = depth::parseTechnique("standard");
        made.technique.format = depth::DepthFormat::d16;
        made.cascades = {{camera.nearView, camera.farView}};
        return made;
    }
};

TEST(OwnSurfaces, NearlyAllOfATruePictureIsCertified) {
    const House house;
    const Certificate certificate = certified(house.scene, house.frame);
    EXPECT_EQ(certificate.refused, 0u);
    EXPECT_TRUE(certificate.repairs.empty());
    EXPECT_GT(certificate.certifiedFraction(), 0.99);
}

/// What a coarse depth buffer shows through the ground, and through the first wall.
TEST(OwnSurfaces, DistancesAreRepairedThatAreOfOneBehind) {
    const House house;
    DrawnFrame frame = house.frame;
    std::size_t changed = 0;
    for (std::size_t i = 0; i < frame.ids.pixels.size(); ++i) {
        if (i % 7 == 0 && house.frame.ids.pixels[i] == house.hidden.ids.pixels[i] &&
            frame.ids.pixels[i] != 0) {
            frame.distancesView.pixels[i] = house.hidden.distancesView.pixels[i];
            changed += frame.distancesView.pixels[i] != house.frame.distancesView.pixels[i] ? 1 : 0;
        }
    }
    ASSERT_GT(changed, 500u);
    const Certificate certificate = certified(house.scene, frame);
    EXPECT_EQ(certificate.refused, 0u);
    for (const measure::PixelRepair& repair : certificate.repairs) {
        frame.distancesView.at(repair.x, repair.y) = repair.distanceView;
    }
    EXPECT_EQ(frame.distancesView.pixels, house.frame.distancesView.pixels);
}

} // namespace
} // namespace cdr::test
