#include "../fixture.h"
#include "compute.h"

#include <cdr/depth/cascade_constants.h>
#include <cdr/depth/view_constants.h>

#include <glm/gtc/quaternion.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <span>
#include <vector>

namespace cdr::render_test {

namespace {

using Float4 = std::array<float, 4>;

/// CdrView and CdrCascade, and one place after the other, as the shaders read them.
struct CameraConstants {
    depth::ViewConstants view;
    depth::CascadeConstants cascade;
};
struct Place {
    Float4 at{};
    Float4 rest{};
};

class PlaceTest : public RenderTest {
  protected:
    std::vector<Float4> see(const char* shader, const CameraConstants& camera,
                            const std::vector<Place>& places) {
        return compute<Float4>(device(), shader, std::span(&camera, 1), std::span(places), places.size());
    }
};

std::array<double, 3> arrayOf(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

Place placeOf(const glm::dvec3& at) {
    Place place;
    for (int i = 0; i < 3; ++i) {
        const depth::FloatPair pair = depth::floatPair(at[i]);
        place.at[static_cast<std::size_t>(i)] = pair.value;
        place.rest[static_cast<std::size_t>(i)] = pair.rest;
    }
    return place;
}

/// A thousand objects about a cascade that begins `distanceView` ahead of a camera, which is as far from the origin.
void expectExact(
    const std::function<std::vector<Float4>(const CameraConstants&, const std::vector<Place>&)>& see,
    double distanceView, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    const glm::dmat3 turn = glm::mat3_cast(
        glm::normalize(glm::dquat(normal(random), normal(random), normal(random), normal(random))));
    const glm::dvec3 eye = distanceView * glm::dvec3(normal(random), normal(random), normal(random));
    const depth::ViewAxes axes{
        .eye = arrayOf(eye), .right = arrayOf(turn[0]), .up = arrayOf(turn[1]), .forward = arrayOf(-turn[2])};
    const depth::Cascades cascades{{distanceView, 2.0 * distanceView}};
    const CameraConstants camera{
        depth::viewConstants(axes),
        depth::cascadeConstants(depth::Mapping::anchored, cascades, 0, {.fovY = 1.0, .aspect = 1.0})};
    std::vector<glm::dvec3> centres;
    std::vector<Place> places;
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 beside(normal(random), normal(random), -normal(random));
        centres.push_back(eye - turn[2] * distanceView + turn * (10.0 * beside));
        places.push_back(placeOf(centres.back()));
    }
    const std::vector<Float4> seen = see(camera, places);
    const double bound = std::ldexp(3.0 * distanceView + glm::length(eye), -43);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const glm::dvec3 fromEye =
            centres[i] - eye; // off by 2^-53 of what goes in, a thousandth of the bound
        const double wanted[]{glm::dot(turn[0], fromEye), glm::dot(turn[1], fromEye),
                              -glm::dot(turn[2], fromEye) - distanceView};
        for (std::size_t k = 0; k < 3; ++k) {
            ASSERT_NEAR(static_cast<double>(seen[i][k]), wanted[k], bound + 6e-8 * std::abs(wanted[k]))
                << i << " " << k << " at " << distanceView;
        }
    }
}

/// Places that the device subtracts are within 2^-43 of float64's, by GLSL and by HLSL, which agree to the bit. Floats alone
/// would be off by 2^-24.
TEST_F(PlaceTest, PairsOfFloatsPlaceObjectsAsFloat64Does) {
    std::mt19937_64 random(1971);
    for (const double distanceView : {1.0, 1e3, 1e6, 1e9, 1e11}) {
        for (int turn = 0; turn < 4; ++turn) {
            expectExact(
                [&](const CameraConstants& camera, const std::vector<Place>& places) {
                    std::vector<Float4> seen = see(CDR_HOST_PLACE, camera, places);
                    EXPECT_EQ(see(CDR_HOST_PLACE_HLSL, camera, places), seen) << distanceView;
                    return seen;
                },
                distanceView, random);
        }
    }
}

} // namespace

} // namespace cdr::render_test
