// quoted in src/cdr/README.md: begin
#version 460
#extension GL_GOOGLE_include_directive : require
#include "cdr_depth.glsl"

layout(push_constant) uniform Push { CdrCascade cascade; };
layout(location = 0) in vec3 position;     // about the mesh's own origin
layout(location = 1) in mat3 turnAndScale; // object to view space, without translation; an attribute is a column
layout(location = 4) in vec3 centre;       // view-space x and y, and the view distance beyond the anchor

void main() {
    vec3 turned = turnAndScale * position;
    float ahead = centre.z - turned.z;
    gl_Position = cdrCascadePosition(centre.xy + turned.xy, ahead, cascade);
    vec2 inside = cdrInsideCascade(ahead, cascade);
    gl_ClipDistance[0] = inside.x;
    gl_ClipDistance[1] = inside.y;
}
// quoted in src/cdr/README.md: end
