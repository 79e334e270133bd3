#include <cdr/measure/truth/truth_light.h>
#include <cdr/measure/truth/truth_metallic_roughness.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace cdr::measure {

namespace {

constexpr glm::dvec3 kNormal{0.0, 0.0, 1.0};

/// A unit vector at an angle to the normal.
glm::dvec3 direction(double polar, double turn = 0.0) {
    return {std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)};
}

GlossyPoint pointOf(double metallic, double roughness, const glm::dvec3& baseColor, double polar) {
    return {.baseColor = baseColor,
            .metallicRoughness = {.metallic = static_cast<float>(metallic),
                                  .roughness = static_cast<float>(roughness)},
            .normal = kNormal,
            .toCamera = direction(polar)};
}

/// Seen and lit along the normal, D is 1 / (pi alpha^2), the shadowing 1 and Fresnel's term what is mirrored.
TEST(TruthMetallicRoughness, AlongTheNormalIsTheClosedForm) {
    const glm::dvec3 base(0.9, 0.5, 0.1);
    for (const double roughness : {0.25, 0.5, 1.0}) {
        const double peak = 0.25 / std::pow(roughness, 4.0);
        const glm::dvec3 metal = pointShare(pointOf(1.0, roughness, base, 0.0), kNormal);
        const glm::dvec3 dielectric = pointShare(pointOf(0.0, roughness, base, 0.0), kNormal);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(metal[c], base[c] * peak, 1e-12 * peak);
            EXPECT_NEAR(dielectric[c], 0.04 * peak + 0.96 * base[c], 1e-12 * peak);
        }
    }
}

/// What goes one way comes back: share over cosine is the same when light and camera change places.
TEST(TruthMetallicRoughness, IsReciprocal) {
    for (const double metallic : {0.0, 0.5, 1.0}) {
        GlossyPoint point = pointOf(metallic, 0.4, {0.8, 0.3, 0.2}, 0.3);
        const glm::dvec3 toLight = direction(1.2, 0.7);
        const glm::dvec3 there = pointShare(point, toLight) / toLight.z;
        const glm::dvec3 back =
            pointShare({point.baseColor, point.metallicRoughness, kNormal, toLight}, point.toCamera) /
            point.toCamera.z;
        EXPECT_NEAR(glm::length(there - back), 0.0, 1e-12);
    }
}

/// What is not mirrored is all that is left where nothing is: the dielectric's, less what its Fresnel term mirrors.
TEST(TruthMetallicRoughness, DiffuseIsWhatMicrofacetsLeave) {
    const glm::dvec3 base(0.9, 0.5, 0.1);
    EXPECT_NEAR(glm::length(diffuseShare(pointOf(0.0, 0.5, base, 0.0), kNormal) - 0.96 * base), 0.0, 1e-12);
    EXPECT_EQ(diffuseShare(pointOf(1.0, 0.5, base, 0.0), kNormal), glm::dvec3(0.0));
    EXPECT_EQ(diffuseShare(pointOf(0.0, 0.5, base, 0.0), direction(1.8)), glm::dvec3(0.0));
}

/// A rough dielectric under a sky that is white all around, with an interpolated normal that faces away from the camera. It
/// sends the light of all directions that is not mirrored, and a little that is.
TEST(TruthMetallicRoughness, NormalsThatFaceAwayKeepDiffuseSkyLight) {
    scene::Scene scene;
    const glm::vec3 white(1.0f);
    scene.sky = scene::Sky{.zenith = white, .horizon = white, .ground = white};
    constexpr int kSteps = 400;
    for (const double polar : {1.5, 1.8, 2.1}) {
        const GlossyPoint point = pointOf(0.0, 0.9, glm::dvec3(0.8), polar);
        double diffuse = 0.0;
        for (int i = 0; i < kSteps; ++i) {
            const double angle = (i + 0.5) / kSteps * 0.5 * std::numbers::pi;
            for (int j = 0; j < kSteps; ++j) {
                const double turn = (j + 0.5) / kSteps * 2.0 * std::numbers::pi;
                diffuse += diffuseShare(point, direction(angle, turn)).g * std::sin(angle);
            }
        }
        diffuse *= std::numbers::pi / (kSteps * static_cast<double>(kSteps));
        const double lit = lightFrom(scene, scene::Camera{},
                                     {.baseColor = point.baseColor,
                                      .metallicRoughness = point.metallicRoughness,
                                      .fromCamera = {0.0, 0.0, -5.0},
                                      .normal = {0.0, std::sin(polar), std::cos(polar)}})
                               .g;
        EXPECT_GT(lit, 0.99 * diffuse) << polar;
        EXPECT_LT(lit, 1.15 * diffuse) << polar;
    }
}

/// Squares of such distances are no numbers.
TEST(TruthLight, LightsMayFadeAtAnyDistance) {
    const auto litBy = [](double halfDistance) {
        scene::Scene scene;
        scene.lights = {{.halfDistance = halfDistance}};
        return lightFrom(scene, scene::Camera{},
                         {.baseColor = glm::dvec3(0.8),
                          .metallicRoughness = {},
                          .fromCamera = {0.0, 0.0, -5.0},
                          .normal = {0.0, 0.0, 1.0}})
            .g;
    };
    EXPECT_GT(litBy(1e100), 0.1);
    EXPECT_EQ(litBy(1e160), litBy(1e100));
    EXPECT_EQ(litBy(std::numeric_limits<double>::max()), litBy(1e100));
    EXPECT_EQ(litBy(1e-170), litBy(1e-150));
}

TEST(TruthMetallicRoughness, MixesAMetalAndADielectric) {
    const glm::dvec3 base(0.9, 0.5, 0.1);
    const glm::dvec3 toLight = direction(0.9, 1.0);
    const auto sum = [&](double metallic) {
        const GlossyPoint point = pointOf(metallic, 0.3, base, 0.6);
        return pointShare(point, toLight) + ambientShare(point);
    };
    EXPECT_NEAR(glm::length(sum(0.5) - 0.5 * (sum(0.0) + sum(1.0))), 0.0, 1e-12);
}

TEST(TruthMetallicRoughness, LightFromBehindIsNone) {
    EXPECT_EQ(pointShare(pointOf(0.0, 0.5, glm::dvec3(1.0), 0.5), direction(1.6)), glm::dvec3(0.0));
    const GlossyPoint facingAway = pointOf(0.5, 0.5, glm::dvec3(1.0), std::numbers::pi);
    EXPECT_EQ(pointShare(facingAway, -facingAway.toCamera), glm::dvec3(0.0)); // from straight behind
}

/// The published fit is an approximation of the integral of the microfacets over all directions, and is coarse. A
/// white metal of roughness 0.3 to 0.5 reflects up to 0.19 too little.
TEST(TruthMetallicRoughness, AmbientIsAboutTheIntegralOverAllDirections) {
    constexpr int kPolar = 800;
    constexpr int kTurns = 400;
    for (const double roughness : {0.3, 0.5, 0.8, 1.0}) {
        for (const double polar : {0.0, 0.5, 1.0, 1.3}) {
            const GlossyPoint metal = pointOf(1.0, roughness, glm::dvec3(1.0, 0.5, 0.0), polar);
            glm::dvec3 integral(0.0);
            for (int i = 0; i < kPolar; ++i) {
                const double angle = (i + 0.5) / kPolar * 0.5 * std::numbers::pi;
                for (int j = 0; j < kTurns; ++j) {
                    const double turn = (j + 0.5) / kTurns * 2.0 * std::numbers::pi;
                    integral += pointShare(metal, direction(angle, turn)) * std::sin(angle);
                }
            }
            integral *=
                (0.5 * std::numbers::pi / kPolar) * (2.0 * std::numbers::pi / kTurns) / std::numbers::pi;
            const glm::dvec3 fit = ambientShare(metal);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(fit[c], integral[c], 0.2) << roughness << " " << polar << " " << c;
            }
        }
    }
}

TEST(TruthMetallicRoughness, SendsNoMoreThanItGets) {
    for (const double metallic : {0.0, 0.5, 1.0}) {
        for (double roughness = 0.0; roughness <= 1.0; roughness += 0.1) {
            for (const double polar : {0.0, 0.8, 1.4, 1.57}) {
                const glm::dvec3 share = ambientShare(pointOf(metallic, roughness, glm::dvec3(1.0), polar));
                EXPECT_LE(share.r, 1.02) << metallic << " " << roughness << " " << polar;
                EXPECT_GE(share.r, 0.3) << metallic << " " << roughness << " " << polar;
            }
        }
    }
}

} // namespace

} // namespace cdr::measure
