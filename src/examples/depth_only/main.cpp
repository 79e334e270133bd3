// An engine that draws by anchored depth. All that anchored depth needs is draw_anchored.cpp on the CPU and anchored.vert or
// .hlsl on the device. This file stands in for the rest of the engine, and prints instead of drawing.
#include "draw_anchored.h"

#include <cdr/version.h>

#include <cmath>
#include <cstdio>

namespace {

struct PrintingEngine final : adoption::Engine {
    void clearDepth(float value) override { std::printf("clear depth to %g\n", value); }
    void setCascade(const cdr::depth::CascadeConstants& constants) override {
        std::printf("cascade: anchor %.9g, scale %.9g, offset %.9g, ahead %.9g to %.9g\n",
                    constants.anchorView, constants.scale, constants.offset, constants.nearAhead,
                    constants.farAhead);
    }
    void draw(const adoption::Object& object, float x, float y, float ahead) override {
        std::printf("draw object %td at %g, %g, %.9g ahead\n", &object - visible.data(), x, y, ahead);
    }
};

} // namespace

int main() {
    constexpr double kPixelsHigh = 720.0;
    PrintingEngine engine;
    engine.nearView = 0.1;
    engine.farView = 1e9;
    engine.projection = {.fovY = 1.0, .aspect = 16.0 / 9.0};
    engine.footprintSlope = 2.0 * std::tan(0.5 * engine.projection.fovY) / kPixelsHigh;
    engine.visible = {{{0.25, -0.5, -1.45}, 1.05}, {{2.5e5, 0.0, -384e6}, 1737e3}}; // a cockpit, and a moon
    cdr::depth::Cascades cascades;
    adoption::drawAnchored(engine, cascades);
    std::printf("cdr %s: drawn in %zu cascades\n", CDR_VERSION_TEXT, cascades.size());
    return 0;
}
