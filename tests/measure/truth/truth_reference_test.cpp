#include "../../support/worst.h"
#include "../test_scenes.h"
#include "reference_caster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace cdr::test {

namespace {

/// How the truth differs from the reference.
struct Disagreement {
    std::uint64_t pixels = 0;
    std::uint64_t covered = 0;  ///< of them, by the reference
    std::uint64_t ids = 0;      ///< nearest or second differs, but ties within rounding
    std::uint64_t mistakes = 0; ///< nearest or second differs by more than that
    double distance = 0.0;      ///< the largest, relative, of nearest and second where ids agree

    void add(const Disagreement& other) {
        pixels += other.pixels;
        covered += other.covered;
        ids += other.ids;
        mistakes += other.mistakes;
        distance = worseOf(distance, other.distance);
    }
};

/// Relative distance within which two surfaces tie: a few roundings of float64.
constexpr long double kTie = 16 * std::numeric_limits<double>::epsilon();

/// Compares the surface that the truth ranks `rank`-th, 0 or 1, with the reference's.
void compare(std::uint32_t id, double distance, const std::vector<ReferenceHit>& hits, std::size_t rank,
             Disagreement& result) {
    const std::uint32_t expectedId = rank < hits.size() ? hits[rank].id : 0;
    if (id != expectedId) {
        // A tie: the reference has the truth's object too, no farther from the rank's distance than
        // roundings.
        const auto own = std::ranges::find_if(hits, [&](const auto& hit) { return hit.id == id; });
        const bool ties =
            own != hits.end() && rank < hits.size() &&
            std::abs(own->distanceView - hits[rank].distanceView) <= kTie * hits[rank].distanceView;
        ++(ties ? result.ids : result.mistakes);
    } else if (expectedId != 0) {
        const long double expected = hits[rank].distanceView;
        result.distance =
            worseOf(result.distance, static_cast<double>(std::abs(distance - expected) / expected));
    }
}

Disagreement disagreement(const scene::Scene& scene, const scene::Camera& camera, std::uint32_t width,
                          std::uint32_t height) {
    const measure::TruthImage truth = cast(scene, camera, width, height);
    const ReferenceCaster reference(scene, camera, width, height);
    Disagreement result;
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const measure::TruthPixel& pixel = truth.at(x, y);
            const std::vector<ReferenceHit> hits = reference.hits(x, y);
            ++result.pixels;
            result.covered += !hits.empty();
            compare(pixel.id, pixel.distanceView, hits, 0, result);
            compare(pixel.secondId, pixel.secondDistanceView, hits, 1, result);
        }
    }
    return result;
}

/// The worst of all tests of this program, printed at its end.
class WorstDisagreement : public testing::Environment {
  public:
    void TearDown() override {
        if (m_all.pixels == 0) {
            return; // other tests alone ran
        }
        std::printf(
            "truth against its second method: worst distance %.2e relative, %llu mistakes in %llu pixels\n",
            m_all.distance, static_cast<unsigned long long>(m_all.mistakes),
            static_cast<unsigned long long>(m_all.pixels));
    }
    void add(const Disagreement& d) { m_all.add(d); }

  private:
    Disagreement m_all;
};

WorstDisagreement& worst() {
    // GoogleTest owns environments.
    static auto* const kWorst = new WorstDisagreement;
    [[maybe_unused]] static const auto* const kRegistered = testing::AddGlobalTestEnvironment(kWorst);
    return *kWorst;
}

[[maybe_unused]] const WorstDisagreement& kRegisteredBeforeMain = worst();

void print(const char* what, double distance, const Disagreement& d) {
    worst().add(d);
    testing::Test::RecordProperty("worst_distance_relative", std::to_string(d.distance * 1e15) + "e-15");
    std::printf(
        "%s at %.0e: %llu pixels, %llu covered; ids differ %llu at ties, %llu else; distance at worst "
        "%.2e relative\n",
        what, distance, static_cast<unsigned long long>(d.pixels), static_cast<unsigned long long>(d.covered),
        static_cast<unsigned long long>(d.ids), static_cast<unsigned long long>(d.mistakes), d.distance);
}

} // namespace

class TruthAgainstReference : public testing::TestWithParam<double> {};

TEST_P(TruthAgainstReference, RandomObjectsOfEveryKind) {
    const double distance = GetParam();
    Disagreement sum;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        std::mt19937_64 random(100 + seed);
        const glm::dvec3 centre(-1234.5, 777.0, 0.25 * distance);
        const scene::Scene scene = makeRandomScene(seed, 120, 24.0, centre);
        const scene::Camera camera =
            makeCameraAround(random, centre, distance, std::min(20.0, 2.0 * distance));
        sum.add(disagreement(scene, camera, 61, 43));
    }
    print("random objects", distance, sum);
    EXPECT_GT(sum.covered, sum.pixels / 2);
    EXPECT_EQ(sum.mistakes, 0u);
    EXPECT_EQ(sum.ids, 0u);
    EXPECT_LT(sum.distance, 1e-13);
}

TEST_P(TruthAgainstReference, CubesAFewRoundingsApart) {
    const double distance = GetParam();
    const double step = distance * 0x1p-52;
    std::mt19937_64 random(7);
    scene::Scene scene = makeEmptyScene();
    for (int i = 0; i < 64; ++i) {
        const glm::mat3 basis = 0.2f * randomRotation(random);
        const glm::dvec3 position(0.5 * (i % 8 - 3.5), 0.5 * (i / 8 - 3.5), -distance);
        // By slabs against slabs, slabs against triangles, triangles against triangles.
        addObject(scene, i % 3 == 0 ? kCube : kTriangleCube, position, basis);
        addObject(scene, i % 3 == 2 ? kTriangleCube : kCube,
                  position - glm::dvec3(0.0, 0.0, step * std::floor(i / 4.0)), basis);
    }
    scene::Camera camera;
    camera.fovY = 2.0 * std::atan(2.2 / distance);
    camera.nearView = 0.1;
    camera.farView = 4.0 * distance;
    const Disagreement result = disagreement(scene, camera, 80, 80);
    print("cubes a few roundings apart", distance, result);
    EXPECT_GT(result.covered, result.pixels / 8);
    EXPECT_EQ(result.mistakes, 0u);
}

INSTANTIATE_TEST_SUITE_P(Distances, TruthAgainstReference, testing::Values(1.0, 1e2, 1e4, 1e6, 1e8),
                         [](const auto& test) {
                             return "TenToThe" + std::to_string(std::lround(std::log10(test.param)));
                         });

TEST(TruthReference, CameraAmongTheObjects) {
    Disagreement sum;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        std::mt19937_64 random(seed);
        const scene::Scene scene = makeRandomScene(50 + seed, 150, 20.0, glm::dvec3(0.0));
        scene::Camera camera = makePlainCamera();
        camera.fovY = 100.0 * kDegree;
        camera.nearView = seed % 2 ? 0.5 : 1e-3;
        camera.farView = 9.0;
        sum.add(
            disagreement(scene, scene::lookAt(camera, glm::dvec3(0.0), randomRotation(random)[0]), 64, 36));
    }
    print("camera among the objects", 1.0, sum);
    EXPECT_EQ(sum.mistakes, 0u);
    EXPECT_EQ(sum.ids, 0u);
    EXPECT_LT(sum.distance, 1e-13);
}

} // namespace cdr::test
