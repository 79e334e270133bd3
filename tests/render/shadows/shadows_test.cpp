#include "../../support/all_cases.h"
#include "../fixture.h"

#include <cdr/measure/shadows/wrong_shadows.h>
#include <cdr/render/draw_source.h>
#include <cdr/render/uploaded_scene.h>
#include <cdr/scene/world/world.h>
#include <scenes/open_scene.h>

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace cdr::render_test {

namespace {

using render::RenderOptions;
using render::ShadowMethod;

RenderOptions shadowOptions(const std::string& technique, std::uint32_t width = 480,
                            std::uint32_t height = 270) {
    RenderOptions options = smallOptions(depth::namedTechnique(technique).technique, width, height);
    options.shadows.method = ShadowMethod::anchored;
    return options;
}

/// What rays find in a scene, for any number of pictures of it.
class ShadowTruth {
  public:
    explicit ShadowTruth(const scene::Scene& scene)
        : m_shapes(scene, m_workers),
          m_caster(scene, m_shapes.shapes()),
          m_lights(scene.lights.size()) {}

    /// By light.
    std::vector<measure::ShadowImage> cast(const scene::Camera& camera, const RenderOptions& options) {
        std::vector<measure::ShadowImage> images;
        for (std::size_t light = 0; light < m_lights; ++light) {
            images.push_back(m_caster.cast(camera, options.width, options.height, light, m_workers));
        }
        return images;
    }

  private:
    platform::WorkerPool m_workers{2};
    measure::TruthCaster m_shapes;
    measure::ShadowTruthCaster m_caster;
    std::size_t m_lights;
};

class ShadowsTest : public RenderTest {
  protected:
    /// Of all lights together.
    static measure::WrongShadows wrongShadowsIn(const render::Frame& drawn,
                                                const std::vector<measure::ShadowImage>& truth) {
        measure::WrongShadows wrong;
        for (std::size_t light = 0; light < truth.size(); ++light) {
            wrong += measure::countWrongShadows({drawn.litMask, light}, truth[light]);
        }
        return wrong;
    }

    /// Of one frame of a scene.
    measure::WrongShadows wrongShadowsOf(const char* scene, std::uint32_t frame,
                                         const RenderOptions& options) {
        const scene::SceneSetup setup = scenes::openScene(scene, scenes::kDefaultSeed).setup;
        const scene::Camera camera = setup.path.at(frame);
        return wrongShadowsIn(draw(setup.scene, camera, options),
                              ShadowTruth(setup.scene).cast(camera, options));
    }
};

/// Of the first frame of each scene, or of all with CDR_ALL_CASES.
TEST_F(ShadowsTest, OffEdgesNextToNonePixelIsWrongAndPlainMapsAreWorse) {
    struct Case {
        std::string scene;
        std::vector<std::uint32_t> frames;
        bool isDeep = false;       ///< distances differ so much that plain maps are far worse
        std::uint32_t width = 224; ///< wide enough that thousands of pixels are off edges
    };
    for (const Case& each : {Case{"alley", {0}}, Case{"mixed", {0}}, Case{"afc", {0, 7}, false, 320},
                             Case{"orbit", {0, 120}, true}, Case{"eclipse", {0, 60, 90}}}) {
        const scene::SceneSetup setup = scenes::openScene(each.scene, scenes::kDefaultSeed).setup;
        ShadowTruth truth(setup.scene);
        const render::GpuScene gpuScene(device(), setup.scene);
        for (const std::uint32_t frame : test::sampleOf(each.frames, 0)) {
            const scene::Camera camera = setup.path.at(frame);
            RenderOptions options = shadowOptions("anchored", each.width, each.width * 9 / 16);
            const std::vector<measure::ShadowImage> rays = truth.cast(camera, options);
            for (const render::SurfacePath surface :
                 {render::SurfacePath::gbuffer, render::SurfacePath::visibility}) {
                options.surface = surface;
                const bool hasTextures = each.scene == "orbit" || each.scene == "eclipse";
                if (surface == render::SurfacePath::visibility && hasTextures) {
                    continue;
                }
                const auto wrongWith = [&](const RenderOptions& drawn) {
                    return wrongShadowsIn(draw(setup.scene, gpuScene, camera, drawn), rays);
                };
                const measure::WrongShadows wrong = wrongWith(options);
                EXPECT_GT(wrong.pixels, 800u) << each.scene;
                EXPECT_LE(wrong.wrong, 1 + wrong.pixels / 10'000)
                    << each.scene << " frame " << frame << " of " << wrong.pixels;
                if (each.isDeep && frame == 0) {
                    RenderOptions plain = options;
                    plain.shadows.method = ShadowMethod::plain;
                    EXPECT_GT(wrongWith(plain).fraction(), 20.0 * wrong.fraction().value() + 1e-3);
                }
            }
        }
    }
}

/// Where four maps suffice: each pixel reads the map of its slice.
TEST_F(ShadowsTest, PlainMapsAreMostlyRightInNarrowScenes) {
    RenderOptions options = shadowOptions("anchored", 320, 180);
    options.shadows.method = ShadowMethod::plain;
    for (const char* scene : {"alley", "afc"}) {
        const measure::WrongShadows wrong = wrongShadowsOf(scene, 0, options);
        EXPECT_GT(wrong.shadowed, 100u) << scene;
        EXPECT_LT(wrong.fraction(), 0.03) << scene;
    }
}

/// Hangars from 430 km: a map covers kilometres, and its texels would be five pixels wide.
TEST_F(ShadowsTest, WideTexelsAreHalved) {
    RenderOptions options = shadowOptions("anchored", 640, 360);
    options.shadows.maxTexels = 1024;
    const measure::WrongShadows wrong = wrongShadowsOf("eclipse", 40, options);
    EXPECT_GT(wrong.shadowed, 1000u);
    EXPECT_LE(wrong.wrong, wrong.pixels / 10'000);
}

/// The runway's number through a long lens: paint 5 mm over the asphalt, under texels of a metre. At inner corners all texels
/// near by may be of the paint.
TEST_F(ShadowsTest, ThinPaintCastsNoShadowBesideItself) {
    const RenderOptions options = shadowOptions("anchored", 320, 180);
    const measure::WrongShadows wrong = wrongShadowsOf("orbit", 239, options);
    EXPECT_GT(wrong.pixels, 50'000u);
    EXPECT_LE(wrong.wrong, 1u);
}

/// Facets smaller than a texel: the nearest texel alone would shadow pixels that its neighbours show to be lit.
TEST_F(ShadowsTest, BodiesOfSmallFacetsCastNoShadowOnThemselves) {
    const RenderOptions options = shadowOptions("anchored", 640, 360);
    const measure::WrongShadows wrong =
        wrongShadowsOf(CDR_SOURCE_DIR "/tests/assets/machine.glb", 0, options);
    EXPECT_GT(wrong.pixels, 20'000u);
    EXPECT_GT(wrong.shadowed, 2'000u);
    EXPECT_LE(wrong.wrong, 1u);
}

TEST_F(ShadowsTest, TheCountSeesShadowsThatAreMissing) {
    const scene::SceneSetup setup = scenes::openScene("alley", scenes::kDefaultSeed).setup;
    const measure::ShadowImage truth =
        ShadowTruth(setup.scene).cast(setup.path.at(0), shadowOptions("anchored"))[0];
    image::ImageRgba8 everywhere(480, 270);
    std::fill(everywhere.pixels.begin(), everywhere.pixels.end(), image::Rgba8{255, 255, 255, 255});
    const measure::WrongShadows wrong = measure::countWrongShadows({everywhere, 0}, truth);
    EXPECT_GT(wrong.shadowed, 1000u);
    EXPECT_EQ(wrong.wrong, wrong.shadowed);
}

/// Under every preset, with one kind of targets and one submission each, or all with CDR_ALL_CASES. One pass shades other bits,
/// and its shadows are as right.
TEST_F(ShadowsTest, PicturesAreRightAndTheSameForThreadsTargetsAndSubmissions) {
    const scene::SceneSetup setup = scenes::openScene("alley", scenes::kDefaultSeed).setup;
    const scene::Camera camera = setup.path.at(0);
    const render::GpuScene gpuScene(device(), setup.scene);
    std::vector<measure::ShadowImage> rays;
    std::size_t turn = 0;
    for (const depth::NamedTechnique& named : depth::presets()) {
        RenderOptions first = shadowOptions(named.name, 192, 108);
        first.shadows.maxTexels = 512;
        if (rays.empty()) {
            rays = ShadowTruth(setup.scene).cast(camera, first);
        }
        const auto drawn = [&](const RenderOptions& options) {
            return render::Renderer(device(), setup.scene, gpuScene, options).render(camera);
        };
        const auto expectRight = [&](const render::Frame& frame) {
            const measure::WrongShadows wrong = wrongShadowsIn(frame, rays);
            EXPECT_GT(wrong.pixels, 5'000u) << named.name;
            EXPECT_LE(wrong.wrong, 1 + wrong.pixels / 10'000) << named.name;
        };
        const render::Frame wanted = drawn(first);
        expectRight(wanted);
        RenderOptions unshadowed = first;
        unshadowed.shadows = {};
        EXPECT_NE(hashOf(wanted), hashOf(drawn(unshadowed)));
        const auto expectSame = [&](const RenderOptions& options) {
            const render::Frame made = drawn(options);
            EXPECT_EQ(hashOf(made), hashOf(wanted)) << named.name;
            EXPECT_EQ(made.litMask.pixels, wanted.litMask.pixels) << named.name;
        };
        const std::vector<render::TargetsKind> kinds{render::TargetsKind::accumulate,
                                                     render::TargetsKind::pool, render::TargetsKind::layers};
        for (const render::TargetsKind targets : test::sampleOf(kinds, turn)) {
            // Another submission when the same targets come again.
            for (const render::Submission submission : test::sampleOf(submissions(), turn + turn / 3)) {
                RenderOptions options = first;
                options.threads = 4;
                options.targets = targets;
                options.submission = submission;
                expectSame(options);
            }
        }
        ++turn;
        RenderOptions onePass = first;
        onePass.targets = render::TargetsKind::onePass;
        expectRight(drawn(onePass));
    }
}

TEST_F(ShadowsTest, AMovedCasterMovesItsShadow) {
    scene::Scene scene = boxScene();
    scene.lights.front() = {.position = glm::dvec3(0.0, 50.0, 0.0), .halfDistance = 100.0};
    addBox(scene, {0.0, -2.0, -10.0}, glm::mat3(20, 0, 0, 0, 0.1f, 0, 0, 0, 20));
    addBox(scene, {-3.0, 0.5, -10.0});
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.1, .farView = 1e3};
    const RenderOptions options = shadowOptions("anchored");
    scene::World world(scene);
    SoleRenderer renderer(device(), world, options);
    const render::Frame before = renderer.render(camera);
    world.setTransform(world.instance(1), {.position = {3.0, 0.5, -10.0}});
    const render::Frame after = renderer.render(camera);
    EXPECT_NE(hashOf(before), hashOf(after));
    scene::placeInstance(scene, 1, {3.0, 0.5, -10.0}, glm::mat3(1.0f));
    EXPECT_EQ(hashOf(after), hashOf(draw(scene, camera, options)));
}

/// Of what is closed only the faces towards the light are drawn. A light that is inside sees the others, and so does one that
/// looks into a box without a lid.
TEST_F(ShadowsTest, WhatIsOpenOrAroundTheLightCastsAShadowToo) {
    scene::Scene scene = boxScene();
    scene::Mesh open = scene.meshes.front();
    open.boxHalfSides.reset();
    open.indices.erase(open.indices.begin() + 18, open.indices.begin() + 24); // the side up
    const scene::Camera camera =
        scene::lookAlong({.fovY = 1.0, .farView = 1e3}, {0.0, 4.0, 0.0}, {0.0, -0.5, -1.0});
    const RenderOptions options = shadowOptions("anchored", 320, 180);
    addBox(scene, {0.0, -2.0, -10.0}, glm::mat3(20, 0, 0, 0, 0.1f, 0, 0, 0, 20));
    addBox(scene, {-3.0, 0.5, -10.0});
    addBox(scene, {3.0, 0.5, -10.0}, glm::mat3(-1, 0, 0, 0, 1, 0, 0, 0, 1));
    const auto expectRight = [&](const glm::dvec3& light, const char* what) {
        scene.lights.front() = {.position = light, .halfDistance = 100.0};
        const measure::WrongShadows wrong =
            wrongShadowsIn(draw(scene, camera, options), ShadowTruth(scene).cast(camera, options));
        EXPECT_GT(wrong.shadowed, 100u) << what;
        EXPECT_LE(wrong.wrong, 1u) << what << ", of " << wrong.pixels;
    };
    expectRight({0.0, 60.0, -10.0}, "closed");
    expectRight({-3.0, 0.5, -10.0}, "closed around the light");
    expectRight({3.0, 0.5, -10.0}, "mirrored around the light");
    scene.meshes.push_back(open);
    scene.instances.mesh[1] = 1;
    scene.instances.mesh[2] = 1;
    expectRight({0.0, 60.0, -10.0}, "open");
}

/// In floats, corners so far away put the ground below the camera many texels off.
TEST_F(ShadowsTest, AMeshThatIsMuchWiderThanItsDistanceDoesNotShadeItself) {
    constexpr float kWide = 4e5f;
    const scene::Camera camera =
        scene::lookAlong({.fovY = 1.0, .farView = 1e3}, {0.0, 4.0, 0.0}, {0.0, -0.5, -1.0});
    const RenderOptions options = shadowOptions("anchored", 320, 180);
    for (const double turn : {0.1, 0.7, 1.9}) {
        scene::Scene scene = boxScene();
        const double top = static_cast<double>(kWide * scene.meshes.front().boxHalfSides->y);
        const auto turned = glm::mat3(glm::rotate(glm::dmat4(1.0), turn, glm::dvec3(0.0, 1.0, 0.0)));
        scene.lights.front() = scene::directionalLight({-1.0, -1.5, -0.7}, glm::vec3(1.0f), {}, 1e3);
        addBox(scene, {0.0, -top, -10.0}, turned * glm::mat3(kWide));
        const measure::WrongShadows wrong =
            wrongShadowsIn(draw(scene, camera, options), ShadowTruth(scene).cast(camera, options));
        EXPECT_GT(wrong.pixels, 1000u) << turn;
        EXPECT_EQ(wrong.wrong, 0u) << turn;
    }
}

/// A room that is modelled from within, and the light outside.
TEST_F(ShadowsTest, ARoomThatIsInsideOutIsDark) {
    scene::Scene scene = boxScene();
    scene.meshes.front().boxHalfSides.reset();
    std::vector<std::uint32_t>& indices = scene.meshes.front().indices;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        std::swap(indices[i], indices[i + 1]);
    }
    for (scene::Vertex& vertex : scene.meshes.front().vertices) {
        vertex.normal = -vertex.normal;
    }
    scene.lights.front() = {.position = {0.0, 60.0, 10.0}, .halfDistance = 100.0};
    addBox(scene, {0.0, 0.0, 0.0}, glm::mat3(20.0f));
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.1, .farView = 1e3};
    const RenderOptions options = shadowOptions("anchored");
    const measure::WrongShadows wrong =
        wrongShadowsIn(draw(scene, camera, options), ShadowTruth(scene).cast(camera, options));
    EXPECT_GT(wrong.shadowed, 1000u);
    EXPECT_EQ(wrong.wrong, 0u) << "of " << wrong.pixels;
}

/// A box whose lid rises: light comes in below the lid, and a wall keeps it from the inside.
TEST_F(ShadowsTest, AClosedMeshThatBendsOpenCastsItsShadow) {
    scene::Scene scene = boxScene();
    scene.lights.front() = {.position = {20.0, 12.0, -10.0}, .halfDistance = 100.0};
    scene.meshes.push_back(scene.meshes.front());
    addBox(scene, {0.0, -2.0, -10.0}, glm::mat3(20, 0, 0, 0, 0.1f, 0, 0, 0, 20));
    scene::addInstance(scene, 1, 0, 1, {0.0, -0.5, -10.0}, glm::mat3(3.0f));
    const scene::Camera camera =
        scene::lookAlong({.fovY = 1.0, .farView = 1e3}, {-2.0, 4.0, 0.0}, {0.0, -0.5, -1.0});
    const RenderOptions options = shadowOptions("anchored");
    scene::World world(scene);
    SoleRenderer renderer(device(), world, options);
    const render::Frame closed = renderer.render(camera);
    std::vector<scene::Vertex> vertices = scene.meshes.back().vertices;
    for (scene::Vertex& vertex : vertices) {
        vertex.position.y += vertex.normal.y > 0.5f ? 0.3f : 0.0f;
    }
    world.setVertices(world.mesh(1), vertices);
    const render::Frame bent = renderer.render(camera);
    EXPECT_NE(bent.litMask, closed.litMask);
    EXPECT_EQ(hashOf(bent), hashOf(draw(world.scene(), camera, options)));
}

/// As in a scene that is made anew. Else shadows would depend on what a mesh was before.
TEST_F(ShadowsTest, AMeshIsClosedOrNotByTheVerticesItHas) {
    scene::Scene scene = boxScene();
    addBox(scene, {});
    scene::World world(scene);
    render::GpuScene live(device(), world);
    const std::vector<scene::Vertex> box = world.scene().meshes.front().vertices;
    std::vector<scene::Vertex> larger = box;
    for (scene::Vertex& vertex : larger) {
        vertex.position *= 2.0f;
    }
    std::vector<scene::Vertex> open = box;
    open.front().position *= 2.0f;
    const auto isClosedWith = [&](const std::vector<scene::Vertex>& vertices) {
        world.setVertices(world.mesh(0), vertices, {});
        live.update();
        const render::GpuScene anew(device(), world.scene());
        EXPECT_EQ(live.uploaded().kinds().front().mesh.isClosed,
                  anew.uploaded().kinds().front().mesh.isClosed);
        return live.uploaded().kinds().front().mesh.isClosed;
    };
    EXPECT_TRUE(isClosedWith(larger));
    EXPECT_FALSE(isClosedWith(open));
    EXPECT_TRUE(isClosedWith(box));
}

TEST_F(ShadowsTest, WithoutSurfacesOrCastersAllIsReached) {
    scene::Scene scene = boxScene();
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.1, .farView = 1e3};
    const auto isReached = [](const render::Frame& frame) {
        return std::all_of(frame.litMask.pixels.begin(), frame.litMask.pixels.end(),
                           [](const image::Rgba8& pixel) { return pixel[0] == 255; });
    };
    EXPECT_TRUE(isReached(draw(scene, camera, shadowOptions("anchored"))));
    addBox(scene, {0.0, 0.0, -5.0});
    scene.lights.front().position = glm::dvec3(0.0, 0.0, 50.0);
    EXPECT_TRUE(isReached(draw(scene, camera, shadowOptions("anchored"))));
}

TEST_F(ShadowsTest, WhatCannotBeIsRefused) {
    RenderOptions options = shadowOptions("anchored");
    options.targets = render::TargetsKind::layers;
    options.focus = {.distance = 10.0, .aperture = 0.1};
    EXPECT_NE(refusalOf(boxScene(), options).find("focus"), std::string::npos)
        << refusalOf(boxScene(), options);
    options = shadowOptions("anchored");
    for (const visibility::DetailMode mode : visibility::kDetailModes) {
        options.detail.mode = mode;
        EXPECT_EQ(refusalOf(boxScene(), options).find("detail") == std::string::npos,
                  render::castsShadows(mode))
            << refusalOf(boxScene(), options);
    }
    options = shadowOptions("anchored");
    options.shadows.maxTexels = 63;
    EXPECT_NE(refusalOf(boxScene(), options).find("64 to 4096 texels, not 63"), std::string::npos)
        << refusalOf(boxScene(), options);
    EXPECT_EQ(refusalOf(boxScene(), shadowOptions("anchored")), "none");
}

/// Six lights around a box over a floor, of which two cast no shadows: channels go to the others, in their order.
TEST_F(ShadowsTest, LightsMayBeChosenThatCastShadows) {
    scene::Scene scene = boxScene();
    scene::addInstance(scene, 0, 0, 0, {0.0, 2.0, -10.0}, glm::mat3(2.0f));
    scene::addInstance(scene, 0, 0, 1, {0.0, -11.0, -10.0}, glm::mat3(20.0f));
    scene.lights.clear();
    for (int i = 0; i < 6; ++i) {
        const double angle = 1.0 * i;
        scene.lights.push_back({.position = {30.0 * std::cos(angle), 40.0, -10.0 + 30.0 * std::sin(angle)},
                                .color = glm::vec3(0.2f),
                                .halfDistance = 1000.0,
                                .castsShadows = i != 0 && i != 3});
    }
    const std::vector<std::uint32_t> casting{1, 2, 4, 5};
    ASSERT_EQ(scene::shadowLights(scene.lights), casting);
    const scene::Camera camera = scene::lookAlong({.farView = 1000.0}, {0.0, 6.0, 0.0}, {0.0, -0.5, -1.0});
    const RenderOptions options = shadowOptions("anchored");
    const render::Frame drawn = draw(scene, camera, options);
    const std::vector<measure::ShadowImage> truth = ShadowTruth(scene).cast(camera, options);
    for (std::size_t channel = 0; channel < casting.size(); ++channel) {
        const measure::WrongShadows wrong =
            measure::countWrongShadows({drawn.litMask, channel}, truth[casting[channel]]);
        EXPECT_GT(wrong.shadowed, 100u) << channel;
        EXPECT_EQ(wrong.wrong, 0u) << channel;
    }
    // Where the others stand in between does not matter.
    std::rotate(scene.lights.begin(), scene.lights.begin() + 1, scene.lights.begin() + 4); // 1 2 3 0 4 5
    EXPECT_EQ(draw(scene, camera, options).litMask, drawn.litMask);
    for (scene::PointLight& light : scene.lights) {
        light.castsShadows = false;
    }
    RenderOptions plain = options;
    plain.shadows.method = ShadowMethod::none;
    EXPECT_EQ(draw(scene, camera, options).color, draw(scene, camera, plain).color);
}

/// It has no shadow itself, and those of the mesh behind it in the buffers stay.
TEST_F(ShadowsTest, AMeshWithoutTrianglesTakesNoShadowAway) {
    scene::Scene scene = boxScene();
    scene.meshes.insert(scene.meshes.begin(), scene::Mesh{});
    scene.lights = {{.position = {5.0, 500.0, -10.0}, .color = glm::vec3(1.0f), .halfDistance = 1000.0}};
    scene::addInstance(scene, 1, 0, 0, {0.0, 2.0, -10.0}, glm::mat3(2.0f));
    scene::addInstance(scene, 1, 0, 1, {0.0, -11.0, -10.0}, glm::mat3(20.0f));
    const scene::Camera camera = scene::lookAlong({.farView = 1000.0}, {0.0, 6.0, 0.0}, {0.0, -0.5, -1.0});
    const RenderOptions options = shadowOptions("anchored");
    const image::ImageRgba8 wanted = draw(scene, camera, options).litMask;
    const auto isDark = [](const image::Rgba8& pixel) { return pixel[0] == 0; };
    ASSERT_GT(std::count_if(wanted.pixels.begin(), wanted.pixels.end(), isDark), 100);
    for (const bool isFirst : {false, true}) { // of both, in the order in which they are drawn
        scene::Scene more = scene;
        scene::addInstance(more, 0, 0, 2, {6.0, 2.5, -10.0}, glm::mat3(1.0f));
        if (isFirst) {
            scene::swapInstances(more.instances, 0, 2);
        }
        EXPECT_EQ(draw(more, camera, options).litMask, wanted) << isFirst;
    }
}

} // namespace

} // namespace cdr::render_test
