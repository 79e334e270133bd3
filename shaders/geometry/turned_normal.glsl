// Normals and tangents from object to view space.
#ifndef CDR_SHADERS_TURNED_NORMAL_GLSL
#define CDR_SHADERS_TURNED_NORMAL_GLSL

#include "shared.h"
#include "public/cdr_octahedral.glsl"

// The rows of an instance's basis, times a power of two.
struct Axes {
    vec3 right;
    vec3 up;
    vec3 back;
    bool isMirror;
};

// The largest entry is from 1 to 2, so products of three do not leave float32 for very small and very large instances.
// id: of the draw. It says what is a mirror, which the rounded rows of a flat basis do not.
Axes axesOf(vec3 right, vec3 up, vec3 ahead, uint id) {
    vec3 most = max(max(abs(right), abs(up)), abs(ahead));
    uint exponent = floatBitsToUint(max(most.x, max(most.y, most.z))) & 0x7f800000u;
    float even = uintBitsToFloat(0x7f000000u - exponent);
    return Axes(even * right, even * up, -even * ahead, (id & kIdMirror) != 0u);
}

// Normals turn by the cofactor matrix: right under non-uniform scale, and mirrored ones come out mirrored.
vec3 turnedNormal(Axes axes, vec3 normal) {
    vec3 turned = vec3(dot(cross(axes.up, axes.back), normal), dot(cross(axes.back, axes.right), normal),
                       dot(cross(axes.right, axes.up), normal));
    return axes.isMirror ? -turned : turned;
}

// Tangents turn as edges do; a mirror turns round how the bitangent points.
vec4 turnedTangent(Axes axes, vec4 tangent) {
    vec3 t = cdrDecodeOctahedral(tangent.xy);
    vec3 turned = vec3(dot(axes.right, t), dot(axes.up, t), dot(axes.back, t));
    return vec4(normalize(turned), axes.isMirror ? -tangent.z : tangent.z);
}

// A vertex normal, as it is interpolated: of unit length, since a longer one would weigh more.
vec3 vertexNormal(vec2 octahedral) { return normalize(cdrDecodeOctahedral(octahedral)); }

#endif
