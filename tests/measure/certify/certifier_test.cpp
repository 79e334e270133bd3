#include "../../support/all_cases.h"
#include "../test_scenes.h"
#include "drawn_by_rays.h"

#include <cdr/base/error.h>
#include <scenes/sheets.h>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace cdr::test {
namespace {

using measure::Certificate;
using measure::DrawnFrame;

/// Objects of all kinds that stand in each other, and a camera in front of them.
struct CertifiedScene {
    scene::Scene scene;
    scene::Camera camera;
};

CertifiedScene randomScene(std::uint64_t seed, double distance) {
    std::mt19937_64 random(seed);
    const glm::dvec3 centre(1e5, -2e5, 3e4);
    CertifiedScene made{.scene = makeRandomScene(seed, 120, 12.0, centre), .camera = {}};
    made.camera = makeCameraAround(random, centre, distance, 14.0);
    return made;
}

/// The truth itself, as drawn: what the tests below change.
struct Drawn {
    CertifiedScene made = randomScene(7, 40.0);
    DrawnFrame frame = drawnByRays(made.scene, made.camera, kEightBits);
    Certificate certificate = certified(made.scene, frame);
};

/// A pixel that shows the same as all within some pixels of it: an object, or background.
glm::uvec2 innerPixel(const DrawnFrame& frame, bool isBackground = false) {
    for (std::uint32_t y = 4; y + 4 < frame.ids.height; ++y) {
        for (std::uint32_t x = 4; x + 4 < frame.ids.width; ++x) {
            bool isInner = (frame.ids.at(x, y) == 0) == isBackground;
            for (std::uint32_t j = y - 3; j <= y + 3; ++j) {
                for (std::uint32_t i = x - 3; i <= x + 3; ++i) {
                    isInner = isInner && frame.ids.at(i, j) == frame.ids.at(x, y);
                }
            }
            if (isInner) {
                return {x, y};
            }
        }
    }
    throw base::RunError("nothing covers 7 x 7 pixels");
}

TEST(Certifier, CertifiesNearlyAllOfATruePictureAndRepairsNothing) {
    const Drawn drawn;
    EXPECT_EQ(drawn.certificate.refused, 0u);
    EXPECT_EQ(drawn.certificate.wrong, 0u);
    EXPECT_TRUE(drawn.certificate.repairs.empty());
    EXPECT_GT(drawn.certificate.certifiedFraction(), 0.9999);
    EXPECT_GT(drawn.certificate.proven, 0u);
    EXPECT_LT(drawn.certificate.proven, drawn.certificate.pixels / 50);
    EXPECT_EQ(drawn.certificate.certified + drawn.certificate.cast, drawn.certificate.pixels);
}

/// Rays that miss the centres stand for vertices that are snapped: whatever a device within its limits does is repaired.
TEST(Certifier, RepairsAllThatADeviceWithinItsLimitsDrawsWrong) {
    const std::uint64_t seeds = takesAllCases() ? 8 : 4; // half of them in each kind of scene
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const CertifiedScene made = randomScene(seed, seed % 2 ? 40.0 : 4.0);
        const DrawnFrame frame = drawnByRays(made.scene, made.camera, 1.01 * kRayOff, {.isOff = true});
        const Certificate certificate = certified(made.scene, frame);
        EXPECT_EQ(certificate.refused, 0u) << "seed " << seed;
        EXPECT_GT(certificate.wrong, 0u) << "seed " << seed;
        EXPECT_EQ(wrongAfter(made.scene, frame, certificate), 0u) << "seed " << seed;
    }
}

/// Strips of one plane, each a thousandth of a unit wide and 1000 long, and a plate before them. The plate is closer than
/// float64 can tell where it forms a strip's plane.
CertifiedScene slivers(double gap, float tilt) {
    constexpr int kStrips = 100;
    constexpr float kWidth = 0.001f;
    constexpr float kHalfLength = 500.0f;
    scene::Mesh strips;
    strips.name = "strips";
    for (int strip = 0; strip < kStrips; ++strip) {
        const float low = static_cast<float>(strip - kStrips / 2) * kWidth;
        const auto first = static_cast<std::uint32_t>(strips.vertices.size());
        for (const float y : {low, low + kWidth}) {
            for (const float x : {-kHalfLength, kHalfLength}) {
                strips.vertices.push_back({.position = {x, y, 0.0f}});
            }
        }
        for (const std::uint32_t corner : {0u, 1u, 3u, 0u, 3u, 2u}) {
            strips.indices.push_back(first + corner);
        }
    }
    strips.boundingRadius = scene::boundingRadiusOf(strips.vertices);
    scene::Mesh plate;
    plate.name = "plate";
    plate.indices = {0, 1, 3, 0, 3, 2};
    for (const float y : {-1.0f, 1.0f}) {
        for (const float x : {-1.0f, 1.0f}) {
            plate.vertices.push_back({.position = 20.0f * kWidth * glm::vec3(x, y, 0.0f)});
        }
    }
    plate.boundingRadius = scene::boundingRadiusOf(plate.vertices);
    CertifiedScene made;
    made.scene.meshes = {strips, plate};
    made.scene.materials.push_back({.name = "grey"});
    const glm::mat3 turned(
        glm::rotate(glm::rotate(glm::mat4(1.0f), tilt, {0.3f, 1.0f, 0.2f}), 1.1f, {0.0f, 0.0f, 1.0f}));
    const glm::dvec3 centre(0.0, 0.0, -1000.0);
    scene::addInstance(made.scene, 0, 0, 0, centre, turned);
    scene::addInstance(made.scene, 1, 0, 1, centre + gap * glm::dvec3(turned[2]), turned);
    made.camera.fovY = 4e-5;
    made.camera.nearView = 100.0;
    made.camera.farView = 5000.0;
    return made;
}

TEST(Certifier, CertifiesNoWrongPixelOfASliver) {
    for (const float tilt : {0.3f, 0.7f, 1.1f}) {
        for (const double gap : {1e-10, 1e-9, 1e-8}) {
            const CertifiedScene made = slivers(gap, tilt);
            DrawnFrame frame = drawnByRays(made.scene, made.camera, kEightBits);
            platform::WorkerPool workers(1);
            const measure::TruthImage truth =
                measure::castTruth(made.scene, made.camera, frame.ids.width, frame.ids.height, workers);
            std::uint64_t swapped = 0;
            for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
                if (truth.pixels[i].secondId != 0) {
                    frame.ids.pixels[i] = truth.pixels[i].secondId;
                    frame.distancesView.pixels[i] = truth.pixels[i].secondDistanceView;
                    ++swapped;
                }
            }
            EXPECT_GT(swapped, 100u);
            EXPECT_EQ(wrongAfter(made.scene, frame, certified(made.scene, frame)), 0u)
                << "gap " << gap << ", tilt " << tilt << ", of " << swapped;
        }
    }
}

/// Two parts of one object at one place, and another object just behind them, which the frame shows instead.
TEST(Certifier, ARepairHasTheColorOfThePartThatIsDrawnLast) {
    scene::Scene scene;
    scene.meshes.push_back(scenes::makeSquare(1.0f));
    for (const glm::vec4& color : {glm::vec4(0.0f, 0.0f, 1.0f, 1.0f), glm::vec4(1.0f, 0.0f, 0.0f, 1.0f),
                                   glm::vec4(0.0f, 1.0f, 0.0f, 1.0f)}) {
        const auto material = static_cast<std::uint32_t>(scene.materials.size());
        scene.materials.push_back({.name = "flat", .baseColorFactor = color, .unlit = true});
        const double behind = material == 0 ? 1e-9 : 0.0;
        scene::addInstance(scene, 0, material, material == 0 ? 0 : 1, {0.0, 0.0, -5.0 - behind},
                           glm::mat3(4.0f));
    }
    const scene::Camera camera{.fovY = 0.5, .nearView = 1.0, .farView = 100.0};
    DrawnFrame frame = drawnByRays(scene, camera, kEightBits);
    std::replace(frame.ids.pixels.begin(), frame.ids.pixels.end(), 2u, 1u);
    const Certificate certificate = certified(scene, frame);
    EXPECT_EQ(certificate.refused, 0u);
    ASSERT_GT(certificate.repairs.size(), 100u);
    for (const measure::PixelRepair& repair : certificate.repairs) {
        ASSERT_EQ(repair.color, (image::Rgba8{0, 255, 0, 255}));
    }
}

TEST(Certifier, RefusesWhatIsFartherOffThanTheDeviceStates) {
    const CertifiedScene made = randomScene(3, 40.0);
    const DrawnFrame frame = drawnByRays(made.scene, made.camera, 0.25 * kRayOff, {.isOff = true});
    EXPECT_GT(certified(made.scene, frame).refused, 0u);
}

TEST(Certifier, RefusesAnObjectThatCannotBeThere) {
    Drawn drawn;
    const glm::uvec2 at = innerPixel(drawn.frame);
    for (const std::uint32_t id : {0u, drawn.frame.ids.at(at.x, at.y) + 1}) {
        DrawnFrame changed = drawn.frame;
        changed.ids.at(at.x, at.y) = id;
        const Certificate certificate = certified(drawn.made.scene, changed);
        EXPECT_EQ(certificate.refused, 1u);
        EXPECT_EQ(certificate.firstRefused, at);
        EXPECT_TRUE(certificate.repairs.empty());
    }
}

TEST(Certifier, RefusesAnObjectWhereThereIsNone) {
    Drawn drawn;
    const glm::uvec2 object = innerPixel(drawn.frame);
    const glm::uvec2 empty = innerPixel(drawn.frame, true);
    drawn.frame.ids.at(empty.x, empty.y) = drawn.frame.ids.at(object.x, object.y);
    drawn.frame.distancesView.at(empty.x, empty.y) = drawn.frame.distancesView.at(object.x, object.y);
    const Certificate certificate = certified(drawn.made.scene, drawn.frame);
    EXPECT_EQ(certificate.refused, 1u);
    EXPECT_EQ(certificate.firstRefused, empty);
}

TEST(Certifier, RepairsADistanceThatIsNotTheSurfaces) {
    const Drawn drawn;
    const glm::uvec2 at = innerPixel(drawn.frame);
    const double right = drawn.frame.distancesView.at(at.x, at.y);
    // At the half, the surface is far behind what was drawn.
    for (const double share : {1.0 - 1e-4, 0.5, std::numeric_limits<double>::quiet_NaN()}) {
        DrawnFrame changed = drawn.frame;
        changed.distancesView.at(at.x, at.y) = right * share;
        const Certificate certificate = certified(drawn.made.scene, changed);
        EXPECT_EQ(certificate.refused, 0u);
        EXPECT_EQ(certificate.certified, drawn.certificate.certified - 1);
        EXPECT_EQ(certificate.wrong, 0u);
        ASSERT_EQ(certificate.repairs.size(), 1u);
        EXPECT_EQ(glm::uvec2(certificate.repairs[0].x, certificate.repairs[0].y), at);
        EXPECT_EQ(certificate.repairs[0].id, changed.ids.at(at.x, at.y));
        EXPECT_EQ(certificate.repairs[0].distanceView, right);
    }
}

TEST(Certifier, RefusesAMovedInstance) {
    const Drawn drawn;
    scene::Scene moved = drawn.made.scene;
    const std::uint32_t id = drawn.frame.ids.at(innerPixel(drawn.frame).x, innerPixel(drawn.frame).y);
    for (std::size_t i = 0; i < moved.instances.size(); ++i) {
        if (moved.instances.object[i] + 1 == id) {
            scene::placeInstance(moved, i, moved.instances.position(i) + drawn.made.camera.right * 0.3,
                                 moved.instances.basis[i]);
        }
    }
    EXPECT_GT(certified(drawn.made.scene, drawnByRays(moved, drawn.made.camera, kEightBits)).refused, 0u);
}

TEST(Certifier, RefusesPerturbedVertices) {
    const Drawn drawn;
    scene::Scene perturbed = drawn.made.scene;
    for (scene::Vertex& vertex : perturbed.meshes[kIcosphere].vertices) {
        vertex.position *= 1.05f;
    }
    EXPECT_GT(certified(drawn.made.scene, drawnByRays(perturbed, drawn.made.camera, kEightBits)).refused, 0u);
}

/// Two walls, the nearer one an object of its own, and a picture that shows the farther.
DrawnFrame wrongWall(scene::Scene& scene, double gap) {
    const glm::mat3 wall(glm::vec3(40.0f, 0.0f, 0.0f), glm::vec3(0.0f, 40.0f, 0.0f),
                         glm::vec3(0.0f, 0.0f, 1.0f));
    addObject(scene, kCube, {0.0, 0.0, -100.0 - gap}, wall);
    DrawnFrame frame = drawnByRays(scene, makePlainCamera(), kEightBits);
    addObject(scene, kCube, {0.0, 0.0, -100.0}, wall);
    return frame;
}

TEST(Certifier, RepairsWhatTheDepthFormatDoesNotResolveAndRefusesWhatItDoes) {
    scene::Scene scene = makeEmptyScene();
    DrawnFrame frame = wrongWall(scene, 0.05);
    frame.technique = depth::parseTechnique("reversed");
    frame.cascades = {{frame.camera.nearView, frame.camera.farView}};
    EXPECT_GT(certified(scene, frame).refused, 0u) << "32 bits resolve it";
    frame.technique.format = depth::DepthFormat::d16;
    const Certificate certificate = certified(scene, frame);
    EXPECT_EQ(certificate.refused, 0u) << "16 bits do not";
    EXPECT_GT(certificate.wrong, 0u);
    EXPECT_EQ(wrongAfter(scene, frame, certificate), 0u);
}

TEST(Certifier, CastsNoRayForAFrameThatItRefuses) {
    scene::Scene scene = makeEmptyScene();
    DrawnFrame frame = wrongWall(scene, 1e-7);
    ASSERT_GT(certified(scene, frame).cast, 0u);
    frame.ids.at(frame.ids.width / 2, frame.ids.height / 2) = 0;
    const Certificate certificate = certified(scene, frame);
    EXPECT_EQ(certificate.refused, 1u);
    EXPECT_EQ(certificate.cast, 0u);
    EXPECT_EQ(certificate.wrong, 0u);
}

/// A face's edge this far beside a column of pixel centres, as a share of what vertices may be off.
Certificate certifiedAtEdge(double share) {
    scene::Scene scene = makeEmptyScene();
    scene::Camera camera = makePlainCamera();
    const RayDevice device;
    const double pixel = 2.0 * std::tan(0.5 * camera.fovY) / device.height;
    const double snap = 0.1;
    // The front face is 10 away, and its right edge at the centre of column 84.
    const double right = 10.0 * pixel * (84.5 - 0.5 * device.width + share * snap);
    // The other edges are far from centres of pixels.
    const auto side = static_cast<float>(4.0 * 10.0 * pixel);
    const float across = 1.375f * side;
    const glm::mat3 narrow(glm::vec3(across, 0.0f, 0.0f), glm::vec3(0.0f, side, 0.0f),
                           glm::vec3(0.0f, 0.0f, 1.0f));
    addObject(scene, kCube, {right - 0.5 * static_cast<double>(across), 0.0, -10.5}, narrow);
    return certified(scene, drawnByRays(scene, camera, snap, device));
}

TEST(Certifier, ProvesPixelsNearerToAnEdgeThanVerticesMayBeOff) {
    const Certificate beside = certifiedAtEdge(1.1);
    EXPECT_GT(certifiedAtEdge(0.9).proven, beside.proven + 3);
    EXPECT_GT(certifiedAtEdge(-0.9).proven, beside.proven + 3);
    EXPECT_EQ(certifiedAtEdge(-1.1).proven, beside.proven);
    EXPECT_EQ(beside.proven, 0u);
    EXPECT_EQ(certifiedAtEdge(0.9).cast, 0u);
}

TEST(Certifier, CastsPixelsThatLieOnAnEdge) {
    EXPECT_GT(certifiedAtEdge(0.0).cast, 3u);
    EXPECT_GT(certifiedAtEdge(1e-9).cast, 3u);
    EXPECT_EQ(certifiedAtEdge(1e-6).cast, 0u);
}

/// A device of 16 bits may show either of two walls.
TEST(Certifier, ProvesAnOrderThatTheDepthFormatDoesNotResolve) {
    scene::Scene scene = makeEmptyScene();
    wrongWall(scene, 0.05);
    DrawnFrame frame = drawnByRays(scene, makePlainCamera(), kEightBits);
    frame.technique = depth::parseTechnique("reversed");
    frame.technique.format = depth::DepthFormat::d16;
    frame.cascades = {{frame.camera.nearView, frame.camera.farView}};
    const Certificate certificate = certified(scene, frame);
    EXPECT_GT(certificate.proven, 500u);
    EXPECT_EQ(certificate.certified, certificate.pixels);
    EXPECT_EQ(certificate.cast, 0u);
}

/// The eye is so little below the floor's plane that a device may find it above, and draw the floor along the horizon.
TEST(Certifier, CastsWhatMayBeTheFrontOfAFaceThatReachesBehindTheCamera) {
    scene::Scene scene = makeEmptyScene();
    scene.meshes.push_back(scenes::makeSquare(1.0f));
    addObject(scene, kCube, {0.0, 0.0, -300.0}, glm::mat3(400.0f));
    const glm::mat3 up(glm::vec3(1.0f, 0.0f, 0.0f), glm::vec3(0.0f, 0.0f, -1.0f),
                       glm::vec3(0.0f, 1.0f, 0.0f));
    const auto square = static_cast<std::uint32_t>(scene.meshes.size()) - 1;
    const std::uint32_t floorId = addObject(scene, square, {0.0, 1e-9, 0.0}, up) + 1;
    const scene::Camera camera = makePlainCamera();
    const RayDevice device{.height = 91}; // the horizon is at the centres of a row
    DrawnFrame frame = drawnByRays(scene, camera, kEightBits, device);
    frame.technique = depth::parseTechnique("reversed");
    frame.cascades = {{camera.nearView, camera.farView}};
    EXPECT_EQ(shownBy(frame, floorId), 0u);
    EXPECT_EQ(certified(scene, frame).cast, 0u) << "that it was not drawn is proven";
    const glm::uvec2 at(device.width / 2, device.height / 2);
    frame.ids.at(at.x, at.y) = floorId;
    frame.distancesView.at(at.x, at.y) = 0.5;
    const Certificate certificate = certified(scene, frame);
    EXPECT_EQ(certificate.refused, 0u);
    EXPECT_EQ(certificate.wrong, 1u);
    EXPECT_EQ(wrongAfter(scene, frame, certificate), 0u);
    frame.ids.at(at.x, at.y + 5) = floorId; // far from the horizon
    frame.distancesView.at(at.x, at.y + 5) = 0.5;
    EXPECT_EQ(certified(scene, frame).refused, 1u);
}

TEST(Certifier, LightsRepairsAsTheTruthIsLit) {
    scene::Scene scene = makeEmptyScene();
    scene.ambient = glm::vec3(0.25f);
    DrawnFrame frame = wrongWall(scene, 1e-7);
    const Certificate certificate = certified(scene, frame);
    ASSERT_FALSE(certificate.repairs.empty());
    const measure::PixelRepair& repair = certificate.repairs[certificate.repairs.size() / 2];
    EXPECT_EQ(repair.id, 2u);
    EXPECT_NEAR(glm::length(repair.normal - glm::dvec3(0.0, 0.0, 1.0)), 0.0, 1e-12);
    // A quarter of linear white is 137 of 255 in sRGB.
    EXPECT_EQ(repair.color, (image::Rgba8{137, 137, 137, 255}));
}

TEST(Certifier, RepairsShowWhatTheirSurfacesEmit) {
    for (const bool unlit : {false, true}) {
        scene::Scene scene = makeEmptyScene();
        scene.ambient = glm::vec3(0.125f);
        scene.materials[0].unlit = unlit;
        scene.materials[0].baseColorFactor = glm::vec4(unlit ? 0.125f : 1.0f);
        scene.materials[0].detail.emission = glm::vec3(0.125f, 0.0f, 0.0f);
        const DrawnFrame frame = wrongWall(scene, 1e-7);
        const Certificate certificate = certified(scene, frame);
        ASSERT_FALSE(certificate.repairs.empty());
        // An eighth of linear white is 99 of 255 in sRGB.
        EXPECT_EQ(certificate.repairs[certificate.repairs.size() / 2].color, (image::Rgba8{137, 99, 99, 255}))
            << unlit;
    }
}

TEST(Certifier, FindsTheSameWithAnyNumberOfWorkers) {
    const CertifiedScene made = randomScene(5, 40.0);
    const DrawnFrame frame = drawnByRays(made.scene, made.camera, 1.01 * kRayOff, {.isOff = true});
    const Certificate one = certified(made.scene, frame, 1);
    const Certificate four = certified(made.scene, frame, 4);
    EXPECT_EQ(one.certified, four.certified);
    EXPECT_EQ(one.cast, four.cast);
    ASSERT_EQ(one.repairs.size(), four.repairs.size());
    EXPECT_FALSE(one.repairs.empty());
    for (std::size_t i = 0; i < one.repairs.size(); ++i) {
        EXPECT_EQ(one.repairs[i].x, four.repairs[i].x);
        EXPECT_EQ(one.repairs[i].y, four.repairs[i].y);
        EXPECT_EQ(one.repairs[i].id, four.repairs[i].id);
        EXPECT_EQ(one.repairs[i].distanceView, four.repairs[i].distanceView);
        EXPECT_EQ(one.repairs[i].normal, four.repairs[i].normal);
        EXPECT_EQ(one.repairs[i].color, four.repairs[i].color);
    }
}

/// A wider sub-pixel widens what corners may be off by as much, and a coarser buffer its step alone.
TEST(Certifier, SaysWhatItAllowedFor) {
    Drawn drawn;
    const measure::FrameBound fine = drawn.certificate.bound;
    EXPECT_GT(fine.pixels, kEightBits);
    EXPECT_GT(fine.distanceView, 0.0);
    EXPECT_GT(fine.depth, 0.0);
    EXPECT_GT(fine.stepView, 0.0);
    drawn.frame.snapPixels += 0.25;
    drawn.frame.technique.format = depth::DepthFormat::d16;
    const measure::FrameBound coarse = certified(drawn.made.scene, drawn.frame).bound;
    EXPECT_DOUBLE_EQ(coarse.pixels, fine.pixels + 0.25);
    EXPECT_GE(coarse.distanceView, fine.distanceView); // more triangles may be examined
    EXPECT_GT(coarse.stepView, 10.0 * fine.stepView);
}

TEST(Certifier, RefusesRastersOfUnlikeSizes) {
    Drawn drawn;
    drawn.frame.distancesView = image::Raster<double>(8, 8);
    EXPECT_THROW(certified(drawn.made.scene, drawn.frame), base::InputError);
}

} // namespace
} // namespace cdr::test
