#version 460
#extension GL_GOOGLE_include_directive : require
#include "cdr_depth.glsl"
#include "cdr_gbuffer.glsl"

layout(push_constant) uniform Push {
    CdrCascade cascade;
    vec4 place;
    uvec2 names;
};

layout(location = 0) in float ahead;
layout(location = 1) in float rounding;
layout(location = 0) out uvec4 texel;

void main() {
    bool isNearest = names.x == 0u;
    if (isNearest ? cdrIsOutsideCascade(ahead, cascade) : cdrIsOutsideCascadeWide(ahead, rounding, cascade)) {
        discard;
    }
    texel = cdrGBufferTexel(vec3(0.4, 0.6, 0.2), vec3(0.0, 1.0, 0.0), ahead, names.y, names.x);
}
