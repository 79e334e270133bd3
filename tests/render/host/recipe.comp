#version 460
#extension GL_GOOGLE_include_directive : require
#include "cdr_in_plane.glsl"
#include "cdr_view.glsl"

// What the recipe's functions make of view distances beyond anchors, by each mapping.
layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) readonly buffer Cascades { CdrCascade cascades[]; };
layout(set = 0, binding = 1, std430) readonly buffer Aheads { vec4 aheads[]; }; // beyond the anchor, the index of the cascade, where the tangent touches, x / w of a vertex
struct Made {
    vec4 pairAndLog; // the view distance; its logarithmic depth; whether it is outside
    vec4 straight, logarithmic, tangent; // clip positions
    vec4 inside; // of a draw, of a wide one
    vec4 inPlane; // a vertex in its plane; whether one that may not come nearer keeps its distance
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
    vec3 place = vec3(aheads[i].w * distanceView.x, -0.5 * distanceView.x, ahead);
    vec2 perSlope = vec2(cascade.range.z, cascade.range.w) * 1e4;
    vec3 moved = cdrInPlane(place, vec3(0.75, 0.5, 1.0), perSlope, 0.01 * distanceView.x, cascade.terms.x);
    vec3 stays = cdrInPlane(place, vec3(0.75, 0.5, 1.0), perSlope, 0.0, cascade.terms.x);
    made[i].inPlane = vec4(moved.x, moved.y, moved.z, stays.z == ahead ? 1.0 : 0.0);
}
