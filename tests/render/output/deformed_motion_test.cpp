#include "../fixture.h"
#include "held.h"
#include "truth_motion.h"

#include <cdr/render/upload/last_vertices.h>
#include <cdr/render/uploaded_scene.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace cdr::render_test {

namespace {

using DeformedMotionTest = RenderTest;

constexpr std::uint32_t kSheetSquares = 4; // a side

/// A square sheet of side 2, whose vertices a wave moves. A second one half as large hangs behind it in the same mesh.
scene::Mesh sheetAt(double time) {
    scene::Mesh mesh;
    for (std::uint32_t layer = 0; layer < 2; ++layer) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (std::uint32_t row = 0; row <= kSheetSquares; ++row) {
            for (std::uint32_t column = 0; column <= kSheetSquares; ++column) {
                const glm::dvec2 share = glm::dvec2(column, row) / double{kSheetSquares} * 2.0 - 1.0;
                const glm::dvec3 place(share * (layer == 0 ? 0.7 : 1.4), layer == 0 ? 0.5 : -0.5);
                const glm::dvec3 wave(0.1 * std::sin(2.0 * time + 3.0 * share.y), 0.05 * std::cos(3.0 * time),
                                      0.2 * std::sin(time + 2.0 * share.x));
                mesh.vertices.push_back({.position = glm::vec3(place + wave)});
                if (row < kSheetSquares && column < kSheetSquares) {
                    const std::uint32_t corner = first + row * (kSheetSquares + 1) + column;
                    const std::uint32_t above = corner + kSheetSquares + 1;
                    for (const std::uint32_t index :
                         {corner, corner + 1, above, above, corner + 1, above + 1}) {
                        mesh.indices.push_back(index);
                    }
                }
            }
        }
    }
    mesh.boundingRadius = scene::boundingRadiusOf(mesh.vertices);
    return mesh;
}

/// Two sheets of one mesh and a box before one of them, so many units away.
struct Sheets {
    explicit Sheets(double distance) : away(distance) {
        sheet = world.addMesh(sheetAt(0.0));
        for (std::uint32_t i = 0; i < 2; ++i) {
            sheets.push_back(world.addInstance(
                {.mesh = sheet, .material = world.material(0), .object = i, .transform = placeOf(i, 0.0)}));
        }
        world.addInstance({.mesh = world.mesh(0),
                           .material = world.material(0),
                           .object = 2,
                           .transform = {.position = {1.6, 0.2, 2.0 - away}, .basis = glm::mat3(0.4f)}});
    }
    /// The second one moves as a whole too.
    scene::Transform placeOf(std::uint32_t i, double time) const {
        return {.position = {1.5 * i - 1.0, 0.1 * i * time, -away - 0.3 * i * time},
                .basis = glm::mat3(1.0f)};
    }
    void show(double time) {
        world.setVertices(sheet, sheetAt(time).vertices);
        world.setTransform(sheets[1], placeOf(1, time));
    }
    scene::Camera cameraAt(double time) const {
        scene::Camera camera = scene::lookAt({.fovY = 4.0 / away, .nearView = 0.1, .farView = 4.0 * away},
                                             {0.3 * time, 0.2, 0.0}, {0.1 * time, 0.0, -away});
        camera.lensShift = shift / away * glm::dvec2(1.0 - time, -0.5 * time);
        return camera;
    }

    double away;
    double shift = 0.0; ///< of the lens, at the sheets' distance
    scene::World world{boxScene()};
    scene::MeshHandle sheet;
    std::vector<scene::InstanceHandle> sheets;
};

render::RenderOptions motionOptions(const char* technique) {
    render::RenderOptions options = smallOptions(depth::parseTechnique(technique));
    options.motion = true;
    return options;
}

struct Off {
    std::size_t compared = 0;
    std::size_t wrong = 0; ///< by more than a hundredth of a pixel, and half a step of the device's vertices
    double longest = 0.0;  ///< pixels, of the truth
};

/// Where the frame and the truth show the same object. Edges of triangles differ where a device rounds vertices.
Off compare(const render::Frame& frame, std::uint32_t subPixelBits, const SeenScene& now,
            const SeenScene& before) {
    const double most = 0.01 + std::ldexp(0.5, -static_cast<int>(subPixelBits));
    const measure::TruthImage truth = truthOf(now.scene, now.camera, frame.width(), frame.height());
    const measure::TruthImage held = heldBy(frame);
    const image::Raster<glm::dvec2> exact = truthMotion(held, now, before);
    Off off;
    for (std::size_t i = 0; i < held.pixels.size(); ++i) {
        const double apart = std::abs(held.pixels[i].distanceView - truth.pixels[i].distanceView);
        if (held.pixels[i].id == 0 || held.pixels[i].id != truth.pixels[i].id || apart > 0.01) {
            continue;
        }
        ++off.compared;
        // Also what is no number.
        off.wrong += glm::length(glm::dvec2(frame.motion.pixels[i]) - exact.pixels[i]) <= most ? 0 : 1;
        off.longest = std::max(off.longest, glm::length(exact.pixels[i]));
    }
    return off;
}

TEST_F(DeformedMotionTest, IsThatOfEachVertex) {
    for (const char* technique : {"standard", "cdr", "anchored"}) {
        Sheets sheets(20.0);
        SoleRenderer renderer(device(), sheets.world, motionOptions(technique));
        double last = 0.0;
        renderer.render(sheets.cameraAt(last));
        for (const double time : {0.4, 0.4, 1.0}) { // once nothing moves
            const scene::Scene before = sheets.world.scene();
            sheets.show(time);
            const scene::Camera camera = sheets.cameraAt(time);
            const scene::Camera cameraBefore = sheets.cameraAt(last);
            const Off off = compare(renderer.render(camera), device().info().subPixelBits,
                                    {sheets.world.scene(), camera}, {before, cameraBefore});
            EXPECT_GT(off.compared, 30'000u);
            EXPECT_LE(off.wrong, off.compared / 2000) << technique << " at " << time;
            EXPECT_EQ(off.longest > 5.0, time != last) << off.longest;
            last = time;
        }
    }
}

/// The distance of a point in its mesh stays small, however far the mesh is.
TEST_F(DeformedMotionTest, IsExactAMillionUnitsAway) {
    Sheets sheets(1e6);
    sheets.shift = 0.6;
    SoleRenderer renderer(device(), sheets.world, motionOptions("anchored"));
    renderer.render(sheets.cameraAt(0.0));
    const scene::Scene before = sheets.world.scene();
    sheets.show(0.5);
    const scene::Camera camera = sheets.cameraAt(0.5);
    const scene::Camera cameraBefore = sheets.cameraAt(0.0);
    const Off off = compare(renderer.render(camera), device().info().subPixelBits,
                            {sheets.world.scene(), camera}, {before, cameraBefore});
    EXPECT_GT(off.compared, 30'000u);
    EXPECT_LE(off.wrong, off.compared / 2000);
}

TEST_F(DeformedMotionTest, AllWaysToDrawAFrameGiveTheSame) {
    std::vector<image::Raster<glm::vec2>> motions;
    for (const render::Submission submission : submissions()) {
        for (const render::TargetsKind targets : {render::TargetsKind::single, render::TargetsKind::layers}) {
            Sheets sheets(20.0);
            render::RenderOptions options = motionOptions("anchored");
            options.submission = submission;
            options.targets = targets;
            options.framesInFlight = 3;
            options.threads = targets == render::TargetsKind::layers ? 3 : 1;
            SoleRenderer renderer(device(), sheets.world, options);
            for (int frame = 0; frame < 4; ++frame) {
                sheets.show(0.2 * frame);
                renderer.submit(sheets.cameraAt(0.1 * frame));
            }
            sheets.show(0.8);
            motions.push_back(renderer.render(sheets.cameraAt(0.4)).motion);
        }
    }
    for (const image::Raster<glm::vec2>& motion : motions) {
        EXPECT_EQ(motion, motions.front());
    }
}

/// What stays known is how objects moved: the vertices that the missing frames had are not kept.
TEST_F(DeformedMotionTest, MissedChangesLeaveTheMotionOfObjects) {
    Sheets sheets(20.0);
    render::GpuScene onDevice(device(), sheets.world);
    render::Renderer each(device(), onDevice, motionOptions("anchored"));
    render::Renderer missing(device(), onDevice, motionOptions("anchored"));
    const scene::Camera camera = sheets.cameraAt(0.0);
    each.render(camera);
    missing.render(camera);
    sheets.show(0.2);
    each.render(camera);
    sheets.show(0.4);
    const image::Raster<glm::vec2> known = each.render(camera).motion;
    const image::Raster<glm::vec2> unknown = missing.render(camera).motion;
    EXPECT_NE(known, unknown);
    EXPECT_EQ(unknown.at(120, 135), glm::vec2(0.0f)); // on the sheet that stands still
    EXPECT_NE(known.at(120, 135), glm::vec2(0.0f));
    sheets.show(0.6);
    EXPECT_EQ(missing.render(camera).motion.at(120, 135), each.render(camera).motion.at(120, 135));
}

/// Two parallel squares of one mesh, seen so flatly that their distance changes by two units in a pixel's height.
/// @param gap between them, in pixels of the picture. @param moved of the one behind, along x.
scene::Mesh foldOf(double gap, double moved) {
    constexpr double kAway = 20.0;
    constexpr double kSlope = 135.0; // distance per unit up
    constexpr double kPerPixel = 2.0;
    scene::Mesh mesh;
    for (const double behind : {0.0, gap * kPerPixel}) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const glm::dvec2& corner : {glm::dvec2(-1.0, -0.148), glm::dvec2(1.0, -0.148),
                                         glm::dvec2(1.0, 0.049), glm::dvec2(-1.0, 0.049)}) {
            const double along = behind > 0.0 ? moved : 0.0;
            mesh.vertices.push_back(
                {.position = glm::vec3(corner.x + along, corner.y, kSlope * corner.y - kAway - behind)});
        }
        for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) {
            mesh.indices.push_back(first + corner);
        }
    }
    mesh.boundingRadius = scene::boundingRadiusOf(mesh.vertices);
    return mesh;
}

TEST_F(DeformedMotionTest, AFoldCloseBehindDoesNotGiveItsMotion) {
    const double gap = std::ldexp(16.0, -static_cast<int>(device().info().subPixelBits));
    scene::World world(boxScene());
    const scene::MeshHandle fold = world.addMesh(foldOf(gap, 0.0));
    world.addInstance({.mesh = fold, .material = world.material(0)});
    SoleRenderer renderer(device(), world, motionOptions("anchored"));
    const scene::Camera camera{.fovY = 0.2, .nearView = 0.1, .farView = 100.0};
    renderer.render(camera);
    world.setVertices(fold, foldOf(gap, 0.3).vertices);
    const render::Frame frame = renderer.render(camera);
    for (std::uint32_t y = 131; y < 140; ++y) {
        for (std::uint32_t x = 225; x < 255; ++x) {
            ASSERT_EQ(frame.id(x, y), 1u) << x << " " << y;
            EXPECT_EQ(frame.motion.at(x, y), glm::vec2(0.0f)) << x << " " << y;
        }
    }
}

/// A new instance takes the place of one that went.
TEST_F(DeformedMotionTest, WhatIsNewDidNotMove) {
    Sheets sheets(20.0);
    SoleRenderer renderer(device(), sheets.world, motionOptions("anchored"));
    const scene::Camera camera = sheets.cameraAt(0.0);
    renderer.render(camera);
    sheets.world.removeInstance(sheets.sheets[0]);
    sheets.world.addInstance({.mesh = sheets.sheet,
                              .material = sheets.world.material(0),
                              .object = 3,
                              .transform = sheets.placeOf(0, 0.0)});
    sheets.world.setVertices(sheets.sheet, sheetAt(0.4).vertices);
    const render::Frame frame = renderer.render(camera);
    ASSERT_EQ(frame.id(120, 135), 4u);
    EXPECT_EQ(frame.motion.at(120, 135), glm::vec2(0.0f));
    ASSERT_EQ(frame.id(280, 60), 2u);
    EXPECT_NE(frame.motion.at(280, 60), glm::vec2(0.0f));
}

/// A texture that has no room on the device ends the update when the vertices are there.
TEST_F(DeformedMotionTest, AnUpdateThatIsRepeatedMovesTheSameVertices) {
    std::vector<image::Raster<glm::vec2>> motions;
    for (const bool isRepeated : {false, true}) {
        Sheets sheets(20.0);
        SoleRenderer renderer(device(), sheets.world, motionOptions("anchored"));
        renderer.render(sheets.cameraAt(0.0));
        sheets.show(0.5);
        if (isRepeated) {
            const image::ImageRgba8 wide(device().info().maxImageSide + 1, 1, {255, 255, 255, 255});
            const scene::TextureHandle texture = sheets.world.addTexture({.name = {}, .pixels = wide});
            const scene::MaterialHandle material =
                sheets.world.addMaterial({.baseColorTexture = texture.index});
            EXPECT_THROW(renderer.render(sheets.cameraAt(0.1)), base::InputError);
            sheets.world.removeMaterial(material);
            sheets.world.removeTexture(texture);
        }
        motions.push_back(renderer.render(sheets.cameraAt(0.1)).motion);
    }
    EXPECT_EQ(motions[1], motions[0]);
}

/// Deforms a sheet from frame 1 on, while a mesh comes with each of these frames. For the first one there is no room, so all are
/// uploaded again, and no motion is known.
void expectMotionWhileMeshesCome(const gpu::Device& device,
                                 const std::function<void(Sheets& sheets, int frame)>& deform) {
    Sheets sheets(20.0);
    SoleRenderer renderer(device, sheets.world, motionOptions("anchored"));
    const scene::Camera camera = sheets.cameraAt(0.0);
    std::vector<bool> moved;
    for (int frame = 0; frame < 4; ++frame) {
        if (frame > 0) {
            sheets.world.addMesh(scene::makeBox(glm::vec3(1.0f)));
            deform(sheets, frame);
        }
        moved.push_back(renderer.render(camera).motion.at(120, 135) != glm::vec2(0.0f));
    }
    EXPECT_EQ(moved, (std::vector<bool>{false, false, true, true}));
}

TEST_F(DeformedMotionTest, MeshesMayComeAtTheSameTime) {
    expectMotionWhileMeshesCome(device(), [](Sheets& sheets, int frame) {
        sheets.world.setVertices(sheets.sheet, sheetAt(0.4 * frame).vertices);
    });
}

/// Of one joint, about which the sheet grows.
scene::MeshPose grownPose(double scale) {
    auto deformer = std::make_shared<scene::Deformer>();
    deformer->vertices = sheetAt(0.0).vertices;
    for (std::uint32_t i = 0; i < deformer->vertices.size(); ++i) {
        deformer->firstInfluence.push_back(i);
        deformer->influences.push_back({0, 1.0f});
    }
    deformer->firstInfluence.push_back(static_cast<std::uint32_t>(deformer->vertices.size()));
    finish(*deformer);
    glm::dmat4 joint(scale);
    joint[3][3] = 1.0;
    scene::MeshPose pose{.deformer = deformer, .weights = {}, .joints = {joint}, .place = {}};
    pose.place = placeOf(*deformer, pose.joints);
    return pose;
}

TEST_F(DeformedMotionTest, MeshesMayComeWhileTheDeviceDeformsOthers) {
    if (!device().info().deformMissing.empty()) {
        GTEST_SKIP() << "the device lacks " << device().info().deformMissing.front();
    }
    expectMotionWhileMeshesCome(device(), [](Sheets& sheets, int frame) {
        sheets.world.setPose(sheets.sheet, grownPose(1.0 + 0.05 * frame));
    });
}

/// All poses are made again for the first material with detail, and once there is none. That takes no motion from them.
TEST_F(DeformedMotionTest, DetailMayComeAndGoWhileTheDeviceDeforms) {
    if (!device().info().deformMissing.empty()) {
        GTEST_SKIP() << "the device lacks " << device().info().deformMissing.front();
    }
    Sheets sheets(20.0);
    SoleRenderer renderer(device(), sheets.world, motionOptions("anchored"));
    const scene::Camera camera = sheets.cameraAt(0.0);
    scene::Material material = sheets.world.scene().materials[0];
    std::vector<bool> moved;
    for (int frame = 0; frame < 4; ++frame) {
        if (frame > 0) {
            sheets.world.setPose(sheets.sheet, grownPose(1.0 + 0.05 * frame));
            material.detail.emission = glm::vec3(frame == 2 ? 0.5f : 0.0f);
            sheets.world.setMaterial(sheets.world.material(0), material);
        }
        moved.push_back(renderer.render(camera).motion.at(120, 135) != glm::vec2(0.0f));
    }
    EXPECT_EQ(moved, (std::vector<bool>{false, true, true, true}));
}

TEST_F(DeformedMotionTest, LastVerticesAreKeptAsLongAsARendererShowsMotion) {
    Sheets sheets(20.0);
    render::GpuScene onDevice(device(), sheets.world);
    {
        render::Renderer renderer(device(), onDevice, motionOptions("anchored"));
        sheets.show(0.5);
        renderer.draw(sheets.cameraAt(0.0));
        EXPECT_GT(onDevice.uploaded().lastVertices().buffer().size(), 0u);
    }
    sheets.show(1.0);
    onDevice.update();
    EXPECT_EQ(onDevice.uploaded().lastVertices().buffer().size(), 0u);
}

} // namespace

} // namespace cdr::render_test
