#version 460
#extension GL_GOOGLE_include_directive : require
#include "cdr_depth.glsl"

// A square of the host's that faces the camera, drawn inside a cascade.
layout(push_constant) uniform Push {
    CdrCascade cascade;
    vec4 place; // view-space x and y, the view distance beyond the cascade's anchor, half a side
    uvec2 names; // the cascade's index; the object's index + 1
};

layout(location = 0) out float ahead;

void main() {
    vec2 corner = vec2((gl_VertexIndex & 1) == 0 ? -1.0 : 1.0, (gl_VertexIndex & 2) == 0 ? -1.0 : 1.0);
    ahead = place.z;
    gl_Position = cdrCascadePosition(place.xy + place.w * corner, ahead, cascade);
    vec2 inside = cdrInsideCascade(ahead, cascade);
    gl_ClipDistance[0] = inside.x;
    gl_ClipDistance[1] = inside.y;
}
