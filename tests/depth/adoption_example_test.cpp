#include <cdr/depth/fitted_split.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

/// What an engine has anyway: objects in float64, and a view.
struct Vec3 {
    double x, y, z;
};
struct Object {
    Vec3 centre; ///< view space: the eye is subtracted and axes are turned in float64
    double radius;
};
struct Drawn {
    std::size_t object;
    float x, y, ahead;
};
struct PassConstants {
    float anchorView, scale, offset, nearAhead, farAhead;
};
struct Pass {
    PassConstants constants;
    std::vector<Drawn> drawn;
};
struct Engine {
    cdr::depth::FitView view;
    std::vector<Object> visible;
    std::vector<Pass> passes;

    void clearDepth(float) { passes.emplace_back(); }
    void setCascade(const PassConstants& constants) { passes.back().constants = constants; }
    void draw(const Object& object, float x, float y, float ahead) {
        passes.back().drawn.push_back({static_cast<std::size_t>(&object - visible.data()), x, y, ahead});
    }
};

// README: begin
using namespace cdr::depth;

void drawAnchored(Engine& engine, Cascades& cascades) { // `cascades` are kept from frame to frame
    std::vector<Interval> occupied;
    for (const Object& object : engine.visible) {
        occupied.push_back({-object.centre.z - object.radius, -object.centre.z + object.radius});
    }
    cascades = fitCascades(SplitFitted{}, engine.view, occupied, cascades);
    for (std::size_t i = cascades.size(); i-- > 0;) { // farthest first
        const Cascade range = clipRange(Mapping::anchored, cascades, i);
        const ClipTerms terms = clipTerms(depthRange(Mapping::anchored, cascades, i));
        engine.clearDepth(1.0f);
        engine.setCascade({float(terms.anchorView), float(terms.scale), float(terms.offset),
                           float(range.nearView - terms.anchorView),
                           float(range.farView - terms.anchorView)});
        for (const Object& object : engine.visible) {
            const double w = -object.centre.z;
            if (w + object.radius >= range.nearView && w - object.radius <= range.farView) {
                engine.draw(object, float(object.centre.x), float(object.centre.y),
                            float(w - terms.anchorView));
            }
        }
    }
}
// README: end

std::string readFile(const std::string& path) {
    std::ifstream file(std::string(CDR_SOURCE_DIR) + "/" + path);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t first = text.find(begin);
    const std::size_t last = text.find(end, std::min(text.size(), first + begin.size()));
    return first == std::string::npos || last == std::string::npos
               ? "not there"
               : text.substr(first + begin.size(), last - first - begin.size());
}

/// The example in the README is this file's, and the shader's beside it, which the build compiles.
TEST(AdoptionExample, IsWhatTheReadmeShows) {
    const std::string readme = readFile("README.md");
    const std::string section =
        readme.substr(std::min(readme.size(), readme.find("## Adopting anchored depth")));
    EXPECT_EQ(between(section, "```cpp\n", "```"), between(readFile("tests/depth/adoption_example_test.cpp"),
                                                           "// README: begin\n", "// README: end"));
    EXPECT_EQ(between(section, "```glsl\n", "```"),
              between(readFile("tests/depth/adoption_example.vert"), "// README: begin\n", "// README: end"));
}

/// cdr_depth.glsl's clip position in float32, as a depth buffer of floats would store it.
float depthOf(const PassConstants& cascade, float ahead) {
    return (cascade.scale * ahead + cascade.offset) / (cascade.anchorView + ahead);
}

/// Followed to the letter, it orders two objects a million units away and ten micrometres apart.
TEST(AdoptionExample, OrdersWhatFloat32DistancesCannot) {
    Engine engine{.view = {.model = {.mapping = Mapping::anchored, .format = DepthFormat::d32f},
                           .nearView = 0.001,
                           .farView = 2e6,
                           .footprintSlope = 5e-8},
                  .visible = {{{0.0, 0.0, -0.01}, 0.002}},
                  .passes = {}};
    for (int i = 0; i < 100; ++i) {
        engine.visible.push_back({{0.0, 0.0, -1e6 + 0.1 * i}, 0.5});
        engine.visible.push_back({{0.0, 0.0, -1e6 + 0.1 * i - 1e-5}, 0.5});
    }
    Cascades cascades;
    drawAnchored(engine, cascades);
    ASSERT_EQ(engine.passes.size(), 2u);
    EXPECT_EQ(engine.passes[1].drawn.size(), 1u); // what is near has a cascade of its own, drawn last
    ASSERT_EQ(engine.passes[0].drawn.size(), 200u);
    const Pass& far = engine.passes[0];
    for (std::size_t i = 0; i < 200; i += 2) {
        EXPECT_LT(depthOf(far.constants, far.drawn[i].ahead), depthOf(far.constants, far.drawn[i + 1].ahead));
        EXPECT_EQ(static_cast<float>(-engine.visible[i + 1].centre.z),
                  static_cast<float>(-engine.visible[i + 2].centre.z));
        EXPECT_GT(far.drawn[i].ahead, far.constants.nearAhead);
        EXPECT_LT(far.drawn[i].ahead, far.constants.farAhead);
    }
}

} // namespace
