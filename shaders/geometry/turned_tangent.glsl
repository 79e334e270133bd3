// A tangent from object to view space.
#ifndef CDR_SHADERS_TURNED_TANGENT_GLSL
#define CDR_SHADERS_TURNED_TANGENT_GLSL

#include "public/cdr_octahedral.glsl"

// Tangents turn as edges do; a mirror turns round how the bitangent points.
// mirrored: the determinant of the rows right, up and back.
vec4 turnedTangent(vec4 tangent, vec3 right, vec3 up, vec3 back, float mirrored) {
    vec3 t = cdrDecodeOctahedral(tangent.xy);
    vec3 turned = vec3(dot(right, t), dot(up, t), dot(back, t));
    return vec4(normalize(turned), mirrored < 0.0 ? -tangent.z : tangent.z);
}

#endif
