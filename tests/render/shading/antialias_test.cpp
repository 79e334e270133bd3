#include "../fixture.h"

#include <cdr/base/error.h>
#include <scenes/cubes.h>

#include <cmath>
#include <cstdlib>

namespace cdr::render_test {

namespace {

using render::Antialias;
using render::Frame;

/// A lit box whose edges climb across the picture at a slant, near enough to fill most of it.
scene::Scene slantedBox() {
    scene::Scene scene = boxScene();
    const float c = std::cos(0.15f);
    const float s = std::sin(0.15f);
    addBox(scene, glm::dvec3(0.0, 0.0, -4.0), glm::mat3(c, s, 0.0f, -s, c, 0.0f, 0.0f, 0.0f, 1.0f));
    return scene;
}

render::RenderOptions smoothOptions(const std::string& technique) {
    render::RenderOptions options = smallOptions(depth::parseTechnique(technique));
    options.effects.antialias = Antialias::edges;
    return options;
}

bool isFlat(const image::ImageRgba8& picture, std::uint32_t x, std::uint32_t y) {
    for (std::uint32_t dy = 0; dy < 3; ++dy) {
        for (std::uint32_t dx = 0; dx < 3; ++dx) {
            const image::Rgba8 other = picture.at(x + dx - 1, y + dy - 1);
            if (std::abs(int{other[0]} - int{picture.at(x, y)[0]}) > 2) {
                return false;
            }
        }
    }
    return true;
}

/// How far a picture is from the average of 4 x 4 samples in each of its pixels, over the pixels at edges.
double stairs(const image::ImageRgba8& picture, const image::ImageRgba8& fine) {
    const auto linear = [](std::uint8_t value) { return std::pow(value / 255.0, 2.2); };
    double sum = 0.0;
    for (std::uint32_t y = 0; y < picture.height; ++y) {
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            double average = 0.0;
            for (std::uint32_t i = 0; i < 16; ++i) {
                average += linear(fine.at(4 * x + i % 4, 4 * y + i / 4)[0]) / 16.0;
            }
            sum += std::pow(linear(picture.at(x, y)[0]) - average, 2.0);
        }
    }
    return sum;
}

class AntialiasTest : public RenderTest {};

TEST_F(AntialiasTest, NamesComeBack) {
    for (const Antialias antialias : render::kAntialiases) {
        EXPECT_EQ(render::parseAntialias(nameOf(antialias)), antialias);
    }
    EXPECT_THROW(render::parseAntialias("edge"), base::InputError);
}

TEST_F(AntialiasTest, ComesNearerToManySamplesAPixel) {
    const scene::Scene scene = slantedBox();
    const scene::Camera camera{.fovY = 0.4};
    const Frame plain = draw(scene, camera, smallOptions(depth::parseTechnique("reversed")));
    const Frame smooth = draw(scene, camera, smoothOptions("reversed"));
    render::RenderOptions fineOptions = smallOptions(depth::parseTechnique("reversed"));
    fineOptions.width *= 4;
    fineOptions.height *= 4;
    const Frame fine = draw(scene, camera, fineOptions);
    const double before = stairs(plain.color, fine.color);
    EXPECT_GT(before, 10.0);
    EXPECT_LT(stairs(smooth.color, fine.color), 0.5 * before);
}

TEST_F(AntialiasTest, LeavesSurfacesAndEvenPixelsAlone) {
    const scene::Scene scene = slantedBox();
    const scene::Camera camera{.fovY = 0.4};
    const Frame plain = draw(scene, camera, smallOptions(depth::parseTechnique("reversed")));
    const Frame smooth = draw(scene, camera, smoothOptions("reversed"));
    EXPECT_EQ(program::sha256Of(plain.gbuffer.pixels), program::sha256Of(smooth.gbuffer.pixels));
    std::size_t even = 0;
    for (std::uint32_t y = 1; y + 1 < plain.height(); ++y) {
        for (std::uint32_t x = 1; x + 1 < plain.width(); ++x) {
            if (isFlat(plain.color, x, y)) {
                ++even;
                ASSERT_LE(std::abs(int{plain.color.at(x, y)[0]} - int{smooth.color.at(x, y)[0]}), 1)
                    << x << " " << y; // half floats on the way round a little
            }
        }
    }
    EXPECT_GT(even, 100'000u);
}

TEST_F(AntialiasTest, IsTheSamePictureWhateverTargetsAndThreads) {
    const scene::SceneSetup setup = scenes::makeRotation(1, 8'000);
    expectOnePicture(setup.scene, setup.path.at(0), quarterOf(smoothOptions("cdr")));
}

} // namespace

} // namespace cdr::render_test
