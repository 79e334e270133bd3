// What an engine computes each frame for anchored depth: cascades fitted to what is visible, and 32 bytes for the vertex
// shader of each.
#include <cdr/depth/cascade_constants.h>
#include <cdr/depth/make_cascades.h>
#include <cdr/version.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

int main() {
    using namespace cdr::depth;

    constexpr Projection kLens{.fovY = 1.0, .aspect = 16.0 / 9.0};
    constexpr double kPixelsHigh = 720.0;
    // View distances of the nearest and farthest point of each visible object: a cockpit, and a moon.
    std::vector<Interval> visible{{0.4, 2.5}, {384e6 - 1737e3, 384e6 + 1737e3}};

    const auto cascades =
        tryMakeCascades(SplitFitted{}, {.nearView = 0.1,
                                        .farView = 1e9,
                                        .model = {Mapping::anchored, DepthFormat::d32f},
                                        .footprintSlope = 2.0 * std::tan(0.5 * kLens.fovY) / kPixelsHigh,
                                        .visible = visible});
    if (!cascades) {
        std::fprintf(stderr, "%s\n", cascades.refusal().message.c_str());
        return 2;
    }
    std::printf("cdr %s: %zu cascades, farthest first\n", CDR_VERSION_TEXT, cascades->size());
    for (std::size_t i = cascades->size(); i-- > 0;) {
        const CascadeConstants constants = cascadeConstants(Mapping::anchored, *cascades, i, kLens);
        std::printf("anchor %.9g, scale %.9g, offset %.9g, ahead %.9g to %.9g\n", constants.anchorView,
                    constants.scale, constants.offset, constants.nearAhead, constants.farAhead);
    }
    return 0;
}
