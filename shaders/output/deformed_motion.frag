#version 460
#extension GL_GOOGLE_include_directive : require
#include "output/motion.glsl"

// The motion of the pixels that show a deformed mesh: its own and that of its vertices. What is hidden is left out, by its
// distance.
layout(push_constant) uniform Push { DeformedPush push; };

layout(location = 0) in vec3 inDeformed;
layout(location = 1) in float inBeyond;

layout(location = 0) out vec2 outMotion;

layout(constant_id = 0) const float kSubPixel = 1.0; // of a pixel: what devices round vertices to

const float kSubPixels = 4.0; // both passes round vertices, and the corners that clipping adds
const float kRounding = 1.0 / 1048576.0; // of interpolated distances, with room

void main() {
    float tolerance = kSubPixels * kSubPixel * fwidth(inBeyond);
    uvec4 texel = texelFetch(gbuffer, ivec2(gl_FragCoord.xy), 0);
    float ahead = cdrAheadOf(texel);
    float apart = distanceBetween(vec2(push.ahead.w, push.rightBefore.w), inBeyond, header.anchors[cdrCascadeOf(texel)], ahead);
    tolerance += kRounding * (abs(inBeyond) + abs(ahead));
    if (cdrIdOf(texel) != push.id || !(abs(apart) <= tolerance)) {
        discard;
    }
    outMotion = motionOf(texel, gl_FragCoord.xy, inDeformed);
}
