#version 460
#extension GL_GOOGLE_include_directive : require
#include "output/motion.glsl"

// The motion of every pixel as its object moved as a whole.
layout(location = 0) out vec2 outMotion;

void main() {
    outMotion = motionOf(texelFetch(gbuffer, ivec2(gl_FragCoord.xy), 0), gl_FragCoord.xy, vec3(0.0));
}
