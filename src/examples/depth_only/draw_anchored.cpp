#include "draw_anchored.h"

namespace adoption {

// quoted in src/cdr/README.md: begin
namespace depth = cdr::depth;

void drawAnchored(Engine& engine, depth::Cascades& cascades) { // keep `cascades` from frame to frame
    std::vector<depth::Interval> occupied;
    for (const Object& object : engine.visible) {
        occupied.push_back({-object.centre.z - object.radius, -object.centre.z + object.radius});
    }
    cascades = depth::makeCascades(depth::SplitFitted{},
                                   {.nearView = engine.nearView,
                                    .farView = engine.farView,
                                    .model = {depth::Mapping::anchored, depth::DepthFormat::d32f},
                                    .footprintSlope = engine.footprintSlope, // 2 tan(fovY / 2) / height
                                    .visible = occupied,
                                    .previous = cascades});
    for (std::size_t i = cascades.size(); i-- > 0;) { // farthest first
        const depth::Cascade range = depth::clipRange(depth::Mapping::anchored, cascades, i);
        const double anchorView =
            depth::clipTerms(depth::depthRange(depth::Mapping::anchored, cascades, i)).anchorView;
        engine.clearDepth(1.0f);
        engine.setCascade(depth::cascadeConstants(depth::Mapping::anchored, cascades, i, engine.projection));
        for (const Object& object : engine.visible) {
            const double w = -object.centre.z;
            if (w + object.radius >= range.nearView && w - object.radius <= range.farView) {
                engine.draw(object, float(object.centre.x), float(object.centre.y),
                            float(w - anchorView)); // subtracted in float64, then rounded
            }
        }
    }
}
// quoted in src/cdr/README.md: end

} // namespace adoption
