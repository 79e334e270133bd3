#include "../../support/refusal.h"
#include "../fixture.h"
#include "host_side.h"

#include <cdr/base/error.h>
#include <cdr/image/srgb.h>
#include <scenes/cubes.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <thread>
#include <vector>

namespace cdr::render_test {

namespace {

class RecordTest : public RenderTest {
  protected:
    /// Those that can go into a command buffer of the host's.
    std::vector<render::Submission> recordable() {
        std::vector<render::Submission> all = submissions();
        std::erase(all, render::Submission::primaries);
        return all;
    }
};

vk::Extent2D extentOf(const render::RenderOptions& options) {
    return {options.width, options.height};
}

TEST_F(RecordTest, ARecordedPictureIsTheRenderedOne) {
    const scene::SceneSetup setup = scenes::makeAfc(1);
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    const render::GpuScene gpuScene(device(), setup.scene);
    for (const render::Submission submission : recordable()) {
        options.submission = submission;
        options.framesInFlight = 2;
        HostSide host(device(), extentOf(options));
        render::Renderer renderer(device(), setup.scene, gpuScene, options);
        for (const std::uint32_t at : {7u, 100u, 200u}) { // frames share the host's images too
            const scene::Camera camera = setup.path.at(at);
            host.submit(renderer, camera, host.begin());
            EXPECT_EQ(host.color<image::Rgba8>().pixels, draw(setup.scene, camera, options).color.pixels)
                << nameOf(submission) << " " << at;
        }
        renderer.resize(64, 32); // waits for the host's submissions
        EXPECT_EQ(renderer.render(setup.path.at(0)).width(), 64u);
    }
}

/// The host's format says how the picture is encoded: one that is not sRGB holds linear values.
TEST_F(RecordTest, AnotherFormatHoldsTheSamePicture) {
    scene::Scene scene = boxScene();
    scene.materials[0].baseColorFactor = {0.9f, 0.4f, 0.1f, 1.0f};
    addBox(scene, {0.0, 0.0, -3.0});
    const render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    const scene::Camera camera;
    const image::ImageRgba8 wanted = draw(scene, camera, options).color;
    for (const vk::Format format : {vk::Format::eB8G8R8A8Srgb, vk::Format::eB8G8R8A8Unorm}) {
        HostSide host(device(), extentOf(options), format);
        SoleRenderer renderer(device(), scene, options);
        host.submit(renderer, camera, host.begin());
        const auto bgra = host.color<image::Rgba8>();
        double most = 0.0;
        for (std::size_t i = 0; i < bgra.pixels.size(); ++i) {
            for (const auto& [from, to] : {std::pair{0u, 2u}, {1u, 1u}, {2u, 0u}}) {
                const std::uint8_t encoded = wanted.pixels[i][to];
                const double its =
                    format == vk::Format::eB8G8R8A8Srgb ? encoded : 255.0 * image::linearOfSrgb()[encoded];
                most = std::max(most, std::abs(bgra.pixels[i][from] - its));
            }
        }
        // Half a step of the encoded picture is up to 1.2 of the linear values, near white.
        EXPECT_LE(most, format == vk::Format::eB8G8R8A8Srgb ? 1.0 : 2.0) << vk::to_string(format);
    }
    EXPECT_GT(wanted.at(240, 135)[0], wanted.at(240, 135)[2] + 50);
}

/// The host's depth of every pixel, in each convention and of both surface paths, against the distances that the frame holds.
/// What lies beyond the host's far plane has that plane's depth, as background has, and what is too near the near plane's.
TEST_F(RecordTest, HostDepthIsThatOfItsOwnCamera) {
    struct Convention {
        depth::Mapping mapping;
        double nearView;
        std::optional<double> farView;
    };
    const scene::SceneSetup setup = scenes::makeAfc(1);
    const scene::Camera camera = setup.path.at(7);
    const render::GpuScene gpuScene(device(), setup.scene);
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    for (const render::SurfacePath path : render::kSurfacePaths) {
        options.surface = path;
        const render::Frame wanted = draw(setup.scene, camera, options);
        HostSide host(device(), extentOf(options));
        render::Renderer renderer(device(), setup.scene, gpuScene, options);
        for (const Convention& convention :
             {Convention{depth::Mapping::reversed, 0.25, {}}, Convention{depth::Mapping::reversed, 1e6, {}},
              Convention{depth::Mapping::reversed, 4e5, 2e6}, Convention{depth::Mapping::reversed, 4e5, 1e6},
              Convention{depth::Mapping::standard, 4e5, 2e6},
              Convention{depth::Mapping::standard, 4e5, 1e6}}) {
            render::HostFrame frame = host.begin();
            frame.depth = host.depth(convention.nearView);
            frame.depth->mapping = convention.mapping;
            frame.depth->farView = convention.farView;
            host.submit(renderer, camera, frame);
            const image::Raster<float> depths = host.depthValues();
            const double f = convention.farView.value_or(HUGE_VAL);
            const double n = convention.nearView;
            const bool isStandard = convention.mapping == depth::Mapping::standard;
            std::size_t surfaces = 0;
            std::size_t beyond = 0;
            for (std::uint32_t y = 0; y < options.height; ++y) {
                for (std::uint32_t x = 0; x < options.width; ++x) {
                    const double w = wanted.distanceView(x, y); // infinite for background
                    // The projection matrices of Vulkan's specification and of Lapidous and Jiao, over w.
                    const double nearShare = n / w;
                    const double reversed = std::isinf(f) ? nearShare : (nearShare * f - n) / (f - n);
                    const double zNdc = std::clamp(isStandard ? 1.0 - reversed : reversed, 0.0, 1.0);
                    // Two roundings of what is subtracted, and one of the result.
                    const double rounded = (isStandard ? 1.0 : std::isinf(f) ? 0.0 : n / (f - n)) + nearShare;
                    ASSERT_NEAR(depths.at(x, y), zNdc, 2e-7 * rounded)
                        << nameOf(convention.mapping) << " to " << f << " at " << x << " " << y;
                    surfaces += wanted.id(x, y) != 0 ? 1 : 0;
                    beyond += wanted.id(x, y) != 0 && w > f ? 1 : 0;
                }
            }
            EXPECT_GT(surfaces, 1000u);
            EXPECT_LT(surfaces, depths.pixels.size());
            EXPECT_EQ(beyond > 1000, f == 1e6) << beyond;
        }
    }
}

/// A host's shaders in HLSL give the picture and the surfaces of those in GLSL, to the bit.
TEST_F(RecordTest, HlslDrawsWhatGlslDraws) {
    constexpr double kFaceView = 1e6;
    scene::Scene scene = boxScene();
    addBox(scene, {-1.0, 0.0, -kFaceView - 0.5});
    const scene::Camera camera{.fovY = 4e-6, .nearView = 1.0, .farView = 1e8};
    const render::GpuScene gpuScene(device(), scene);
    const render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    std::vector<std::vector<image::Rgba8>> pictures;
    std::vector<std::vector<render::GBufferPixel>> surfaces;
    for (const HostShaders& shaders : {kSquare, kSquareHlsl}) {
        const HostRectangles squares(device(), vk::Format(device().depthFormat(depth::DepthFormat::d32f)),
                                     shaders);
        HostSide host(device(), extentOf(options));
        render::Renderer renderer(device(), scene, gpuScene, options);
        render::HostFrame frame = host.begin();
        frame.occupied = {{kFaceView - 1.0, kFaceView + 1.0}};
        frame.draw = [&](const render::HostCascade& cascade) {
            squares.draw(cascade, {-1.0, kFaceView - 1e-5, 0.25, 10});
            squares.draw(cascade, {1.0, kFaceView + 1e-5, 0.25, 11});
        };
        host.submit(renderer, camera, frame);
        pictures.push_back(host.color<image::Rgba8>().pixels);
        surfaces.push_back(readGBuffer(device(), renderer.surfaces().gbuffer).pixels);
    }
    EXPECT_EQ(pictures[0], pictures[1]);
    EXPECT_EQ(std::memcmp(surfaces[0].data(), surfaces[1].data(),
                          surfaces[0].size() * sizeof(render::GBufferPixel)),
              0);
    EXPECT_GT(std::count_if(surfaces[1].begin(), surfaces[1].end(),
                            [](const render::GBufferPixel& pixel) { return pixel.id() > 10; }),
              500);
}

/// Two triangles from 10 units behind the camera to 100 km ahead. Each pixel below the horizon shows the ground, once. It is
/// at its distance and from the cascade that holds it. GLSL and HLSL agree to the bit.
TEST_F(RecordTest, GroundOfAHostsIsCutWhereCascadesMeet) {
    constexpr double kHeight = 2.0;
    constexpr double kFarEndView = 1e5;
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.5, .farView = 2e5};
    const scene::Scene scene = boxScene();
    const render::GpuScene gpuScene(device(), scene);
    const render::RenderOptions options = smallOptions(depth::parseTechnique("anchored/ratio:4"));
    std::vector<std::vector<render::GBufferPixel>> surfaces;
    for (const HostShaders& shaders : {kGround, kGroundHlsl}) {
        const HostRectangles ground(device(), vk::Format(device().depthFormat(depth::DepthFormat::d32f)),
                                    shaders);
        HostSide host(device(), extentOf(options));
        render::Renderer renderer(device(), scene, gpuScene, options);
        render::HostFrame frame = host.begin();
        frame.occupied = {{camera.nearView, camera.farView}};
        std::vector<depth::Cascade> ranges(64);
        std::vector<double> anchorsView(64);
        frame.draw = [&](const render::HostCascade& cascade) {
            ranges.at(cascade.index) = cascade.clipRange;
            anchorsView.at(cascade.index) = cascade.anchorView;
            ground.draw(cascade,
                        {1e6, -kHeight, -10.0 - cascade.anchorView, kFarEndView - cascade.anchorView}, 10);
        };
        host.submit(renderer, camera, frame);
        const auto pixels = readGBuffer(device(), renderer.surfaces().gbuffer);
        std::set<std::uint32_t> cascades;
        for (std::uint32_t y = options.height / 2; y < options.height; ++y) {
            const double pixelsBelow = y + 0.5 - 0.5 * options.height;
            const double below = pixelsBelow / (0.5 * options.height) * std::tan(0.5 * camera.fovY);
            const double wantedView = kHeight / below;
            // The device rounds where corners are, and with them the horizon.
            const double snapped = std::ldexp(1.0, -static_cast<int>(device().info().subPixelBits));
            const double toleranceView = wantedView * (1e-3 + snapped / pixelsBelow);
            for (std::uint32_t x = 0; x < options.width; ++x) {
                const render::GBufferPixel& pixel = pixels.at(x, y);
                ASSERT_EQ(pixel.id(), 11u) << x << " " << y;
                cascades.insert(pixel.cascade());
                const double distanceView = anchorsView[pixel.cascade()] + static_cast<double>(pixel.ahead);
                ASSERT_NEAR(distanceView, wantedView, toleranceView) << x << " " << y;
                const depth::Cascade& range = ranges[pixel.cascade()];
                ASSERT_GE(distanceView, range.nearView * (1.0 - 1e-6));
                ASSERT_LE(distanceView, range.farView * (1.0 + 1e-6));
            }
        }
        EXPECT_GT(cascades.size(), 3u);
        surfaces.push_back(pixels.pixels);
    }
    EXPECT_EQ(std::memcmp(surfaces[0].data(), surfaces[1].data(),
                          surfaces[0].size() * sizeof(render::GBufferPixel)),
              0);
}

TEST_F(RecordTest, AHostsObjectsFollowAShiftedLens) {
    const scene::Scene scene = boxScene();
    scene::Camera camera{.fovY = 1.0, .nearView = 1.0, .farView = 100.0};
    camera.lensShift = {0.4, -0.3};
    const render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    const HostRectangles squares(device(), vk::Format(device().depthFormat(depth::DepthFormat::d32f)));
    HostSide host(device(), extentOf(options));
    SoleRenderer renderer(device(), scene, options);
    render::HostFrame frame = host.begin();
    constexpr double kView = 10.0;
    frame.occupied = {{kView, kView}};
    frame.draw = [&](const render::HostCascade& cascade) {
        // Of a square that faces the camera all corners have one w, so its place may take the shift.
        const double x = 4.0 - kView * double{cascade.lensX} / double{cascade.constants.projectionX};
        const double y = -3.0 - kView * double{cascade.lensY} / double{cascade.constants.projectionY};
        squares.draw(cascade, std::array{x, y, kView - cascade.anchorView, 0.5}, 10);
    };
    host.submit(renderer, camera, frame);
    const auto pixels = readGBuffer(device(), renderer.surfaces().gbuffer);
    EXPECT_EQ(pixels.at(options.width / 2, options.height / 2).id(), 11u); // what the lens is shifted to
    EXPECT_EQ(pixels.at(0, 0).id(), 0u);
}

/// Squares of the host's, 0.00001 units before and behind the faces of boxes 1,000 km away, and one where cdr draws
/// nothing. Every target and submission shows of each pair the nearer one.
TEST_F(RecordTest, AHostsObjectsShareTheDepthOfEachCascade) {
    constexpr double kFaceView = 1e6;
    constexpr double kGapView = 1e-5;
    scene::Scene scene = boxScene();
    for (const double x : {-1.0, 1.0}) {
        addBox(scene, {x, 0.0, -kFaceView - 0.5});
    }
    const std::vector<HostRectangles::Square> squares{{-1.0, kFaceView - kGapView, 0.25, 10},
                                                      {1.0, kFaceView + kGapView, 0.25, 11},
                                                      {-1.5, 0.5 * kFaceView, 0.25, 12},
                                                      {1.5, 2.0 * kFaceView, 1.0, 13}};
    const scene::Camera camera{.fovY = 4e-6, .nearView = 1.0, .farView = 1e8};
    const HostRectangles host(device(), vk::Format(device().depthFormat(depth::DepthFormat::d32f)));
    const render::GpuScene gpuScene(device(), scene);
    for (const render::TargetsKind targets : render::kTargetsKinds) {
        for (const render::Submission submission : recordable()) {
            render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
            options.targets = targets;
            options.submission = submission;
            HostSide side(device(), extentOf(options));
            render::Renderer renderer(device(), scene, gpuScene, options);
            render::HostFrame frame = side.begin();
            frame.depth = side.depth(1.0);
            for (const HostRectangles::Square& square : squares) {
                frame.occupied.push_back({square.distanceView - 1.0, square.distanceView + 1.0});
            }
            frame.draw = [&](const render::HostCascade& cascade) {
                for (const HostRectangles::Square& square : squares) {
                    host.draw(cascade, square);
                }
            };
            side.submit(renderer, camera, frame);
            const auto pixels = readGBuffer(device(), renderer.surfaces().gbuffer);
            const auto idAt = [&](double x) { // on the plane of the faces
                const double perUnit = options.height / (2.0 * kFaceView * std::tan(0.5 * camera.fovY));
                return pixels
                    .at(static_cast<std::uint32_t>(options.width / 2.0 + x * perUnit), options.height / 2)
                    .id();
            };
            const std::string what = std::string(nameOf(targets)) + " " + std::string(nameOf(submission));
            EXPECT_EQ(idAt(-1.0), 11u) << what; // the host's before the box
            EXPECT_EQ(idAt(-0.6), 1u) << what;  // the box beside it
            EXPECT_EQ(idAt(1.0), 2u) << what;   // the box before the host's
            EXPECT_EQ(idAt(-3.0), 13u) << what; // the host's where cdr draws nothing
            EXPECT_EQ(idAt(3.0), 0u) << what;   // nothing
            EXPECT_EQ(idAt(0.4), 14u) << what;  // the host's beyond, beside the box
            EXPECT_GT(side.color<image::Rgba8>().at(240, 1)[3], 0) << what;
            const image::Raster<float> depths = side.depthValues();
            EXPECT_GT(*std::max_element(depths.pixels.begin(), depths.pixels.end()), 1.9e-6f) << what;
        }
    }
}

/// Shaders of a host that set their depth need it.
TEST_F(RecordTest, AHostIsToldWhichPartOfTheDepthBufferACascadeHas) {
    const scene::Scene scene = boxScene();
    const render::GpuScene gpuScene(device(), scene);
    for (const render::TargetsKind targets : render::kTargetsKinds) {
        render::RenderOptions options = smallOptions(depth::parseTechnique("log-fragment/count:4"));
        options.targets = targets;
        HostSide side(device(), extentOf(options));
        render::Renderer renderer(device(), scene, gpuScene, options);
        render::HostFrame frame = side.begin();
        std::map<float, float> parts; // from where to where
        std::size_t cascades = 0;
        frame.draw = [&](const render::HostCascade& cascade) {
            parts[cascade.minDepth] = cascade.maxDepth;
            ++cascades;
        };
        side.submit(renderer, {.nearView = 1.0, .farView = 1e4}, frame);
        EXPECT_EQ(cascades, 4u) << nameOf(targets);
        if (targets != render::TargetsKind::onePass) {
            EXPECT_EQ(parts, (std::map<float, float>{{0.0f, 1.0f}})) << nameOf(targets);
            continue;
        }
        EXPECT_EQ(parts.size(), cascades); // none begins where another does
        float end = 0.0f;
        for (const auto& [low, high] : parts) {
            EXPECT_GE(low, end);
            EXPECT_GT(high, low);
            end = high;
        }
        EXPECT_LE(end, 1.0f);
    }
}

TEST_F(RecordTest, AWorldChangesBetweenRecordedFrames) {
    scene::World world(boxScene());
    const scene::InstanceHandle box =
        world.addInstance({.mesh = world.mesh(0), .material = world.material(0)});
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    options.framesInFlight = 2;
    HostSide host(device(), extentOf(options));
    SoleRenderer renderer(device(), world, options);
    for (int turn = 0; turn < 6; ++turn) {
        world.setTransform(box, {.position = {0.3 * turn, 0.0, -5.0}});
        if (turn == 3) {
            world.addMesh(scene::makeBox(glm::vec3(2.0f))); // what frames in flight read is replaced
        }
        host.submit(renderer, {}, host.begin());
    }
    EXPECT_EQ(host.color<image::Rgba8>().pixels, draw(world.scene(), {}, options).color.pixels);
}

/// The next frame shows every edit, and nothing waits for the frame that never ran.
TEST_F(RecordTest, ADroppedFrameLosesNoEdit) {
    scene::World world(boxScene());
    const scene::InstanceHandle box =
        world.addInstance({.mesh = world.mesh(0), .material = world.material(0)});
    for (const render::Submission submission : recordable()) {
        render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
        options.submission = submission;
        options.framesInFlight = 2;
        options.occlusionCulling = submission == render::Submission::gpuDriven;
        HostSide host(device(), extentOf(options));
        SoleRenderer renderer(device(), world, options);
        renderer.dropRecorded(); // there is none
        for (int turn = 0; turn < 3; ++turn) {
            world.setTransform(box, {.position = {0.5 * turn, 0.0, -5.0}});
            for (int drop = 0; drop <= turn; ++drop) {
                renderer.record({}, host.begin());
                renderer.dropRecorded();
            }
            host.submit(renderer, {}, host.begin());
            EXPECT_EQ(host.color<image::Rgba8>().pixels, draw(world.scene(), {}, options).color.pixels)
                << nameOf(submission) << " " << turn;
        }
        renderer.record({}, host.begin());
        renderer.dropRecorded();
    } // the destructor does not wait
}

/// To the device: dropRecorded() gives nothing back that the host submitted.
TEST_F(RecordTest, ASkipThatIsRefusedLeavesTheFrameBefore) {
    const render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
    const scene::Scene scene = boxScene();
    HostSide host(device(), extentOf(options));
    SoleRenderer renderer(device(), scene, options);
    const render::HostFrame frame = host.begin();
    renderer.record({}, frame);
    EXPECT_THROW(renderer.skip({.position = {NAN, 0.0, 0.0}}), base::InputError);
    renderer.dropRecorded();
    std::thread submitting([&] { host.submit(); });
    renderer.finish(); // waits for what is being submitted
    EXPECT_GE(vk::Device(device().handle()).getSemaphoreCounterValue(frame.done), frame.doneValue);
    submitting.join();
}

/// A recorded frame cannot be drawn again, so its lists have room for all instances from the start.
TEST_F(RecordTest, InstancesThatAWorldGainedAreInTheNextFrame) {
    for (const render::Submission submission : recordable()) {
        scene::World world(boxScene());
        render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
        options.submission = submission;
        options.framesInFlight = 2;
        HostSide host(device(), extentOf(options));
        SoleRenderer renderer(device(), world, options);
        for (std::uint32_t turn = 0; turn < 4; ++turn) {
            for (std::uint32_t i = 0; i < 1u + 40u * (turn / 2); ++i) {
                world.addInstance(
                    {.mesh = world.mesh(0),
                     .material = world.material(0),
                     .object = 100 * turn + i,
                     .transform = {.position = {0.5 * (i % 9) - 2.0, 0.5 * (i / 9) - 1.0, -8.0}}});
            }
            host.submit(renderer, {}, host.begin());
            EXPECT_EQ(host.color<image::Rgba8>().pixels, draw(world.scene(), {}, options).color.pixels)
                << nameOf(submission) << " " << turn;
        }
    }
}

/// The host's pipelines write no second image, so it cannot draw from the frame on in which the first such surface is there.
TEST_F(RecordTest, AHostCannotDrawBesideLightThatAWorldGained) {
    scene::World world(boxScene());
    const render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    HostSide host(device(), extentOf(options));
    SoleRenderer renderer(device(), world, options);
    const auto record = [&] {
        render::HostFrame frame = host.begin();
        frame.draw = [](const render::HostCascade&) {};
        host.submit(renderer, {}, frame);
    };
    record();
    scene::Material lamp{.name = "lamp"};
    lamp.detail.emission = glm::vec3(1.0f);
    world.addInstance({.mesh = world.mesh(0), .material = world.addMaterial(lamp)});
    EXPECT_THROW(record(), base::InputError);
}

TEST_F(RecordTest, WhatCannotBeRecordedIntoIsRefused) {
    scene::Scene scene = boxScene();
    addBox(scene, {0.0, 0.0, -5.0});
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
    const render::GpuScene gpuScene(device(), scene);
    HostSide host(device(), extentOf(options));
    render::HostFrame frame = host.begin();
    frame.depth = host.depth(0.1);
    const auto refusal = [&](const auto& spoil) {
        render::HostFrame spoilt = frame;
        render::RenderOptions its = options;
        spoil(spoilt, its);
        render::Renderer renderer(device(), scene, gpuScene, its);
        return test::inputErrorOf([&] { renderer.record({}, spoilt); }, "none");
    };
    using Frame = render::HostFrame;
    using Options = render::RenderOptions;
    const auto expectRefusal = [&](const char* text, const auto& spoil) {
        EXPECT_NE(refusal(spoil).find(text), std::string::npos) << text << ": " << refusal(spoil);
    };
    expectRefusal("semaphore", [](Frame& f, Options&) { f.done = VK_NULL_HANDLE; });
    expectRefusal("value 0", [](Frame& f, Options&) { f.doneValue = 0; });
    expectRefusal("command buffer", [](Frame& f, Options&) { f.commands = VK_NULL_HANDLE; });
    expectRefusal("480x269", [](Frame& f, Options&) { f.color.extent.height = 269; });
    expectRefusal("480x271", [](Frame& f, Options&) { f.depth->image.extent.height = 271; });
    expectRefusal("layout", [](Frame& f, Options&) { f.color.layout = VK_IMAGE_LAYOUT_UNDEFINED; });
    expectRefusal("format", [](Frame& f, Options&) { f.color.format = VK_FORMAT_D16_UNORM; });
    expectRefusal("D32_SFLOAT", [](Frame& f, Options&) { f.depth->image.format = VK_FORMAT_D16_UNORM; });
    expectRefusal("view", [](Frame& f, Options&) { f.depth->image.view = VK_NULL_HANDLE; });
    expectRefusal("near", [](Frame& f, Options&) { f.depth->nearView = 0.0; });
    expectRefusal("far", [](Frame& f, Options&) { f.depth->farView = 0.05; });
    expectRefusal("far", [](Frame& f, Options&) { f.depth->mapping = depth::Mapping::standard; });
    expectRefusal("anchored", [](Frame& f, Options&) { f.depth->mapping = depth::Mapping::anchored; });
    expectRefusal("primaries", [](Frame&, Options& o) { o.submission = render::Submission::primaries; });
    expectRefusal("visibility", [](Frame& f, Options& o) {
        o.surface = render::SurfacePath::visibility;
        f.draw = [](const render::HostCascade&) {};
    });
    expectRefusal("prepared for", [](Frame& f, Options& o) {
        o.prepareFor.emission = true;
        f.draw = [](const render::HostCascade&) {};
    });
    for (const depth::Interval& bad : {depth::Interval{5.0, 1.0}, depth::Interval{1.0, INFINITY}}) {
        expectRefusal("an occupied interval", [&](Frame& f, Options&) { f.occupied = {{1.0, 2.0}, bad}; });
    }
    render::Renderer renderer(device(), scene, gpuScene, options);
    frame.occupied = {{-5.0, -1.0}, {-1.0, 2.0}}; // behind and around the camera
    host.submit(renderer, {}, frame);             // and as it was it is fine
}

} // namespace

} // namespace cdr::render_test
