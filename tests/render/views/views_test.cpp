#include "../../support/all_cases.h"
#include "views_scene.h"

#include <cdr/base/error.h>
#include <cdr/image/beside.h>
#include <cdr/render/views/joined_frame.h>
#include <cdr/render/views/views_renderer.h>
#include <cdr/scene/cube_sides.h>
#include <cdr/scene/stereo_rig.h>
#include <cdr/scene/world/world.h>
#include <scenes/cubes.h>

#include <string>
#include <vector>

namespace cdr::render_test {

namespace {

using render::Frame;
using render::ViewsRenderer;

void expectSamePick(const std::optional<render::Pick>& pick, const std::optional<render::Pick>& expected) {
    ASSERT_EQ(pick.has_value(), expected.has_value());
    if (pick) {
        EXPECT_EQ(pick->object, expected->object);
        EXPECT_EQ(pick->position, expected->position);
        EXPECT_EQ(pick->normal, expected->normal);
    }
}

class ViewsTest : public RenderTest {
  protected:
    void SetUp() override {
        RenderTest::SetUp();
        m_scene = floorAndBoxes();
        m_onDevice.emplace(device(), m_scene);
    }

    /// Draws each view by a renderer of its own.
    void drawMono(const std::vector<scene::Camera>& cameras, const render::RenderOptions& options) {
        m_mono.clear();
        m_cascades.clear();
        m_draws.clear();
        for (const scene::Camera& camera : cameras) {
            const Frame frame = draw(m_scene, *m_onDevice, camera, options);
            if (m_cascades.empty()) {
                m_cascades = frame.cascades;
            }
            ASSERT_EQ(frame.cascades, m_cascades) << "the scene is not one that all see alike";
            m_mono.push_back(hashOf(frame));
            m_draws.push_back(frame.stats.draws);
        }
        EXPECT_NE(m_mono.front(), m_mono.back());
    }

    /// Each view's frame is that of drawMono().
    void expectMono(const std::vector<scene::Camera>& cameras, const render::RenderOptions& options) {
        const std::string where = nameOf(options.technique) + " " + nameOf(options.targets) + " " +
                                  std::string(nameOf(options.submission));
        for (const std::size_t threads : {1u, 2u}) {
            render::RenderOptions own = options;
            own.threads = threads;
            ViewsRenderer renderer(device(), m_scene, *m_onDevice, own, cameras.size());
            for (int frame = 0; frame < 2; ++frame) {
                const std::vector<Frame> views = renderer.render(cameras);
                ASSERT_EQ(views.size(), cameras.size());
                for (std::size_t i = 0; i < views.size(); ++i) {
                    EXPECT_EQ(hashOf(views[i]), m_mono[i]) << where << ", view " << i << ", " << threads;
                    EXPECT_EQ(views[i].cascades, m_cascades) << where;
                    EXPECT_EQ(views[i].camera, cameras[i]);
                }
            }
        }
    }
    void drawAndExpectMono(const std::vector<scene::Camera>& cameras, const render::RenderOptions& options) {
        ASSERT_NO_FATAL_FAILURE(drawMono(cameras, options));
        expectMono(cameras, options);
    }

    std::vector<scene::Camera> eyes(scene::StereoMode mode) {
        const auto both = eyesOf(rigOf(mode));
        return {both.begin(), both.end()};
    }

    render::RenderOptions viewOptions(const depth::Technique& technique) {
        return smallOptions(technique, kViewsWidth, kViewsHeight);
    }

    scene::Scene m_scene;
    std::optional<render::GpuScene> m_onDevice;
    std::vector<std::string> m_mono; ///< what each view's frame holds
    depth::Cascades m_cascades;
    std::vector<std::size_t> m_draws;
};

/// All techniques with all targets, one and two threads, and one submission each, or all with CDR_ALL_CASES. In four techniques
/// each targets meet each submission. The mono picture is the same for all of both.
TEST_F(ViewsTest, EachEyeIsTheMonoPictureToTheBit) {
    std::size_t turn = 0;
    for (const scene::StereoMode mode : scene::kStereoModes) {
        for (const auto& [name, technique] : depth::presets()) {
            ASSERT_NO_FATAL_FAILURE(drawMono(eyes(mode), viewOptions(technique)));
            for (const char* targets : {"single", "accumulate", "pool:3", "layers", "one-pass"}) {
                for (const render::Submission submission : test::sampleOf(submissions(), turn++)) {
                    render::RenderOptions options = viewOptions(technique);
                    options.targets = render::parseTargets(targets);
                    options.submission = submission;
                    expectMono(eyes(mode), options);
                }
            }
        }
    }
}

TEST_F(ViewsTest, EachEyeIsTheMonoPictureWithWhateverElseIsDrawn) {
    render::RenderOptions plain = viewOptions(depth::parseTechnique("anchored"));
    std::vector<render::RenderOptions> all(5, plain);
    all[0].occlusionCulling = true;
    all[1].shadows = {.method = render::ShadowMethod::anchored, .maxTexels = 128};
    all[2].surface = render::SurfacePath::visibility;
    all[3].effects.antialias = render::Antialias::edges;
    all[4].linear = true;
    for (const render::RenderOptions& options : all) {
        drawAndExpectMono(eyes(scene::StereoMode::toedIn), options);
    }
}

/// Each view's surfaces move from where its own camera was, and joined frames have all of it.
TEST_F(ViewsTest, EachEyeMovesAndIsLitAsInTheMonoPicture) {
    render::RenderOptions options = viewOptions(depth::parseTechnique("anchored"));
    options.motion = true;
    options.shadows = {.method = render::ShadowMethod::anchored, .maxTexels = 128};
    ViewsRenderer renderer(device(), m_scene, *m_onDevice, options, 2);
    renderer.draw(bothEyes(scene::StereoMode::toedIn));
    const std::vector<scene::Camera> cameras = bothEyes(scene::StereoMode::toedIn, 0.3);
    const std::vector<Frame> views = renderer.render(cameras);
    EXPECT_NE(views[0].motion.pixels, views[1].motion.pixels);
    EXPECT_NE(views[0].litMask.pixels, views[1].litMask.pixels);
    for (std::size_t view = 0; view < views.size(); ++view) {
        render::Renderer mono(device(), m_scene, *m_onDevice, options);
        mono.draw(bothEyes(scene::StereoMode::toedIn)[view]);
        const Frame wanted = mono.render(cameras[view]);
        EXPECT_EQ(views[view].motion.pixels, wanted.motion.pixels) << view;
        EXPECT_EQ(views[view].litMask.pixels, wanted.litMask.pixels) << view;
    }
    const Frame joined = render::joinedFrame(views, cameras[0], 0);
    EXPECT_EQ(joined.motion,
              image::beside<glm::vec2>(std::vector{&views[0].motion, &views[1].motion}, 0, {}));
    EXPECT_EQ(joined.litMask,
              image::beside<image::Rgba8>(std::vector{&views[0].litMask, &views[1].litMask}, 0, {}));
}

TEST_F(ViewsTest, EachSideOfACubeIsTheMonoPicture) {
    const auto sides = scene::cubeSides(rigOf(scene::StereoMode::parallel).centre);
    render::RenderOptions options = viewOptions(depth::parseTechnique("anchored/count:4"));
    options.width = options.height = 64;
    drawAndExpectMono({sides.begin(), sides.end()}, options);
    options.submission = render::Submission::primaries;
    options.technique = depth::parseTechnique("cdr");
    drawAndExpectMono({sides.begin(), sides.end()}, options);
}

/// Each view draws what it sees, not what the others see too.
TEST_F(ViewsTest, EachViewDrawsNoMoreThanAlone) {
    const std::vector<scene::Camera> cameras = eyes(scene::StereoMode::toedIn);
    const render::RenderOptions options = viewOptions(depth::parseTechnique("anchored"));
    drawAndExpectMono(cameras, options);
    ViewsRenderer renderer(device(), m_scene, *m_onDevice, options, 2);
    const auto stats = renderer.draw(cameras);
    EXPECT_EQ(stats[0].draws, m_draws[0]);
    EXPECT_EQ(stats[1].draws, m_draws[1]);
    EXPECT_LT(stats[0].visible, m_scene.instances.size());
}

/// Where nothing reaches over the whole range, cascades fit what either eye sees.
TEST_F(ViewsTest, CascadesFitWhatAnyOfThemSees) {
    scene::Scene scene = boxScene();
    addBox(scene, {-7.0, 0.0, -10.0});
    addBox(scene, {12.0, 0.0, -200.0}, glm::mat3(20.0f));
    const render::GpuScene onDevice(device(), scene);
    const render::RenderOptions options = viewOptions(depth::parseTechnique("anchored"));
    const scene::Camera camera{.fovY = 0.5, .nearView = 0.1, .farView = 1e4};
    const std::vector<scene::Camera> cameras{scene::lookAlong(camera, {0, 0, 0}, {-0.7, 0, -1}),
                                             scene::lookAlong(camera, {0, 0, 0}, {0, 0, -1})};
    ViewsRenderer renderer(device(), scene, onDevice, options, 2);
    const std::vector<Frame> views = renderer.render(cameras);
    EXPECT_EQ(views[0].cascades, views[1].cascades);
    std::vector<double> seen;
    for (const Frame& view : views) {
        for (std::uint32_t y = 0; y < view.height(); ++y) {
            for (std::uint32_t x = 0; x < view.width(); ++x) {
                if (view.id(x, y) != 0) {
                    seen.push_back(view.distanceView(x, y));
                }
            }
        }
    }
    ASSERT_GT(seen.size(), 10u);
    EXPECT_LT(*std::min_element(seen.begin(), seen.end()), 20.0);
    EXPECT_GT(*std::max_element(seen.begin(), seen.end()), 150.0);
    for (const double distance : seen) {
        EXPECT_TRUE(std::any_of(views[0].cascades.begin(), views[0].cascades.end(),
                                [&](const depth::Cascade& cascade) { return cascade.contains(distance); }))
            << distance;
    }
}

TEST_F(ViewsTest, ShowAWorldAsItIsWhenTheFrameBegins) {
    scene::World world(floorAndBoxes());
    render::GpuScene live(device(), world);
    const render::RenderOptions options = viewOptions(depth::parseTechnique("anchored"));
    ViewsRenderer renderer(device(), live, options, 2);
    const std::vector<scene::Camera> cameras = eyes(scene::StereoMode::parallel);
    const std::string before = hashOf(renderer.render(cameras)[1]);
    world.setTransform(world.instance(12), {.position = {0.0, 0.5, -4.0}, .basis = glm::mat3(1.5f)});
    const std::vector<Frame> views = renderer.render(cameras);
    EXPECT_NE(hashOf(views[1]), before);
    render::Renderer mono(device(), live, options);
    EXPECT_EQ(hashOf(mono.render(cameras[0])), hashOf(views[0]));
    EXPECT_EQ(hashOf(mono.render(cameras[1])), hashOf(views[1]));
}

/// A fitted split keeps to the frames before, skipped ones too.
TEST_F(ViewsTest, AFrameAfterSkippedOnesIsTheSame) {
    const scene::SceneSetup setup = scenes::makeAfcNear(2013);
    const render::GpuScene onDevice(device(), setup.scene);
    render::RenderOptions options = viewOptions({.mapping = depth::Mapping::standard,
                                                 .split = depth::SplitFitted{.most = 2},
                                                 .format = depth::DepthFormat::d16});
    options.motion = true;
    ViewsRenderer all(device(), setup.scene, onDevice, options, 2);
    ViewsRenderer few(device(), setup.scene, onDevice, options, 2);
    for (std::uint32_t i = 0; i < 12; ++i) {
        const scene::StereoRig rig{.centre = setup.path.at(i * setup.path.frames / 12), .eyeDistance = 0.5};
        const auto cameras = eyesOf(rig);
        const std::vector<Frame> expected = all.render(cameras);
        if (i % 4 != 3) {
            few.skip(cameras);
            continue;
        }
        const std::vector<Frame> views = few.render(cameras);
        for (std::size_t view = 0; view < 2; ++view) {
            EXPECT_EQ(hashOf(views[view]), hashOf(expected[view])) << i;
            EXPECT_EQ(views[view].motion.pixels, expected[view].motion.pixels) << i;
        }
    }
}

TEST_F(ViewsTest, FramesInFlightResizeAndForget) {
    render::RenderOptions options = viewOptions(depth::parseTechnique("anchored"));
    options.framesInFlight = 2;
    ViewsRenderer renderer(device(), m_scene, *m_onDevice, options, 2);
    const std::vector<scene::Camera> cameras = eyes(scene::StereoMode::toedIn);
    const std::string first = hashOf(renderer.render(cameras)[0]);
    for (int i = 0; i < 5; ++i) {
        renderer.submit(cameras);
    }
    renderer.finish();
    EXPECT_GT(renderer.lastStats(1).draws, 0u);
    EXPECT_EQ(renderer.surfaces(1).color.extent.width, kViewsWidth);
    EXPECT_NE(renderer.surfaces(0).color.image, renderer.surfaces(1).color.image);
    EXPECT_THROW(renderer.resize(0, 10), base::InputError);
    EXPECT_EQ(hashOf(renderer.render(cameras)[0]), first);
    renderer.resize(64, 36);
    renderer.forgetFrames();
    EXPECT_EQ(renderer.render(cameras)[1].width(), 64u);
    renderer.resize(kViewsWidth, kViewsHeight);
    EXPECT_EQ(hashOf(renderer.render(cameras)[0]), first);
}

TEST_F(ViewsTest, CamerasThatDoNotGoTogetherAreRefused) {
    const render::RenderOptions options = viewOptions(depth::parseTechnique("reversed"));
    for (const std::size_t count : {std::size_t{0}, render::kMaxViews + 1}) {
        EXPECT_THROW(ViewsRenderer(device(), m_scene, *m_onDevice, options, count), base::InputError);
    }
    ViewsRenderer renderer(device(), m_scene, *m_onDevice, options, 2);
    std::vector<scene::Camera> cameras = eyes(scene::StereoMode::parallel);
    EXPECT_THROW(renderer.render(std::vector{cameras[0]}), base::InputError);
    cameras[1].fovY *= 1.1;
    EXPECT_THROW(renderer.render(cameras), base::InputError);
    cameras[1] = cameras[0];
    cameras[1].position.x = std::nan("");
    EXPECT_THROW(renderer.render(cameras), base::InputError);
}

TEST_F(ViewsTest, JoinedFramesStandBesideEachOther) {
    const std::vector<scene::Camera> cameras = eyes(scene::StereoMode::parallel);
    const render::RenderOptions options = viewOptions(depth::parseTechnique("anchored"));
    ViewsRenderer renderer(device(), m_scene, *m_onDevice, options, 2);
    const std::vector<Frame> views = renderer.render(cameras);
    const Frame joined = render::joinedFrame(views, rigOf(scene::StereoMode::parallel).centre, 5);
    ASSERT_EQ(joined.width(), 2 * kViewsWidth);
    ASSERT_EQ(joined.gbuffer.width, 2 * kViewsWidth);
    for (std::uint32_t y = 0; y < kViewsHeight; ++y) {
        for (std::uint32_t x = 0; x < kViewsWidth; ++x) {
            const bool isInLeft = x + 2 < kViewsWidth;
            EXPECT_EQ(joined.color.at(x, y),
                      isInLeft ? views[0].color.at(x + 2, y) : (image::Rgba8{0, 0, 0, 255}));
            EXPECT_EQ(joined.id(kViewsWidth + x, y), x >= 3 ? views[1].id(x - 3, y) : 0u);
            if (isInLeft) {
                EXPECT_EQ(joined.distanceView(x, y), views[0].distanceView(x + 2, y));
                expectSamePick(joined.pick(x, y), views[0].pick(x + 2, y));
            }
            if (x >= 3) {
                expectSamePick(joined.pick(kViewsWidth + x, y), views[1].pick(x - 3, y));
            }
        }
    }
    EXPECT_EQ(joined.stats.draws, views[0].stats.draws + views[1].stats.draws);
}

} // namespace

} // namespace cdr::render_test
