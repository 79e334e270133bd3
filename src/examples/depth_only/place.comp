#version 460
#extension GL_GOOGLE_include_directive : require
#include "cdr_view.glsl"

// quoted in src/cdr/README.md: begin
// Where a device without float64 finds objects that it moves itself.
struct Place {
    vec4 at, rest; // world space: their sum
};
layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) readonly buffer Camera {
    CdrView view;
    CdrCascade cascade;
};
layout(set = 0, binding = 1, std430) readonly buffer Places { Place places[]; };
layout(set = 0, binding = 2, std430) writeonly buffer Seen { vec4 seen[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < places.length()) {
        seen[i] = vec4(cdrPlace(places[i].at.xyz, places[i].rest.xyz, view, cascade), 0.0);
    }
}
// quoted in src/cdr/README.md: end
