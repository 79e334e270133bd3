#include "../fixture.h"
#include "../steps.h"

namespace cdr::render_test {

namespace {

class FarLightsTest : public RenderTest {
  protected:
    /// Boxes in a light that is so far away, and half as strong there.
    image::ImageRgba8 pictureAt(double distance, render::SurfacePath surface, bool isMetal,
                                render::ShadowMethod shadows = render::ShadowMethod::none) {
        scene::Scene scene = boxScene();
        if (isMetal) {
            scene.materials[0].metallicRoughness = {.metallic = 0.5f, .roughness = 0.6f};
        }
        addBox(scene, {-0.7, 0.2, -4.0});
        addBox(scene, {1.5, -0.4, -90.0}, glm::mat3(20.0f));
        addBox(scene, {0.0, -11.5, -8.0}, glm::mat3(20.0f));
        scene.ambient = glm::vec3(0.1f);
        scene.lights.front().position = distance * glm::normalize(glm::dvec3(0.4, 0.7, 0.6));
        scene.lights.front().halfDistance = distance;
        render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
        options.surface = surface;
        options.shadows.method = shadows;
        return draw(scene, {.position = {0.0, 0.5, 0.0}, .nearView = 0.5, .farView = 1e4}, options).color;
    }
};

/// The square of the largest distances is beyond float32, and one over the square of the half distance is 0 there.
TEST_F(FarLightsTest, LightAsNearerOnes) {
    using render::SurfacePath;
    for (const SurfacePath surface : {SurfacePath::gbuffer, SurfacePath::visibility, SurfacePath::lit}) {
        for (const bool isMetal : {false, true}) {
            if (isMetal && surface != SurfacePath::gbuffer) {
                continue;
            }
            const image::ImageRgba8 wanted = pictureAt(1e12, surface, isMetal);
            EXPECT_GT(largestStep(wanted.pixels.front(), wanted.at(wanted.width / 2, wanted.height / 2)), 20);
            for (const double distance : {1e18, 1e19, 1e22, 1e100}) {
                EXPECT_LE(largestStep(pictureAt(distance, surface, isMetal), wanted), 1)
                    << distance << ", surface " << nameOf(surface) << ", metal " << isMetal;
            }
        }
    }
}

TEST_F(FarLightsTest, CastTheShadowsOfNearerOnes) {
    constexpr auto kSurface = render::SurfacePath::gbuffer;
    const image::ImageRgba8 unshadowed = pictureAt(1e12, kSurface, false);
    for (const render::ShadowMethod method : {render::ShadowMethod::anchored, render::ShadowMethod::plain}) {
        const image::ImageRgba8 wanted = pictureAt(1e12, kSurface, false, method);
        ASSERT_GT(largestStep(wanted, unshadowed), 20);
        for (const double distance : {1e19, 1e100, 1e160, 1e300}) {
            EXPECT_LE(largestStep(pictureAt(distance, kSurface, false, method), wanted), 1) << distance;
        }
    }
}

} // namespace

} // namespace cdr::render_test
