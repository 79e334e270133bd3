#version 460
#extension GL_GOOGLE_include_directive : require
#include "cdr_depth.glsl"

// Level ground of a host's, from behind the camera to far ahead, as two triangles.
layout(push_constant) uniform Push {
    CdrCascade cascade;
    vec4 place;  // half its width, view-space y, and both ends: view distances beyond the cascade's anchor
    uvec2 names; // the cascade's index; the object's index + 1
};

layout(location = 0) out float ahead;
layout(location = 1) out float rounding;

void main() {
    float x = (gl_VertexIndex & 1) == 0 ? -place.x : place.x;
    ahead = (gl_VertexIndex & 2) == 0 ? place.z : place.w;
    // The origin of these vertices is the eye, at a distance of 0.
    rounding = cdrRounding(vec2(x, place.y), ahead, 0.0, cascade.terms.x);
    gl_Position = cdrCascadePosition(vec2(x, place.y), ahead, cascade);
    vec2 inside = cdrInsideCascadeWide(ahead, cascade);
    gl_ClipDistance[0] = inside.x;
    gl_ClipDistance[1] = inside.y;
}
