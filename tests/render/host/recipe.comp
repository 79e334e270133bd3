#version 460
#extension GL_GOOGLE_include_directive : require
#include "cdr_view.glsl"

// What the recipe's functions make of view distances beyond anchors, by each mapping.
layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) readonly buffer Cascades { CdrCascade cascades[]; };
layout(set = 0, binding = 1, std430) readonly buffer Aheads { vec4 aheads[]; }; // beyond the anchor, the index of the cascade, where the tangent touches
struct Made {
    vec4 pairAndLog; // the view distance; its logarithmic depth; whether it is outside
    vec4 straight, logarithmic, tangent; // clip positions
    vec4 inside; // of a draw, of a wide one
};
layout(set = 0, binding = 2, std430) writeonly buffer Out { Made made[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= aheads.length()) {
        return;
    }
    float ahead = aheads[i].x;
    CdrCascade cascade = cascades[uint(aheads[i].y)];
    CdrDepth depth = cdrDepthOf(cascade);
    vec2 across = vec2(0.25, -0.5);
    vec2 distanceView = cdrDistanceViewPair(ahead, cascade);
    float isOutside = cdrIsOutsideCascade(ahead, cascade) ? 1.0 : 0.0;
    made[i].pairAndLog = vec4(distanceView.x, distanceView.y, cdrLogDepth(distanceView.x, depth), isOutside);
    made[i].straight = cdrCascadePosition(across, ahead, cascade);
    made[i].logarithmic = cdrClipPositionLog(across, ahead, depth);
    made[i].tangent = cdrClipPositionLogTangent(across, ahead, aheads[i].z, depth);
    vec2 inside = cdrInsideCascade(ahead, cascade);
    vec2 wide = cdrInsideCascadeWide(ahead, cascade);
    made[i].inside = vec4(inside.x, inside.y, wide.x, wide.y);
}
