#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "geometry/depth_mapping.glsl"
#include "targets/gbuffer.glsl"

layout(constant_id = 4) const uint kMetallicRoughness = 0u;

#ifdef PUSHED_RECORD
layout(push_constant) uniform Push {
    CascadePush cascade;
    DrawRecord record;
};
#else
// Per instance: a software rasteriser reads a vertex attribute much faster than a storage buffer.
layout(location = 4) in vec4 inRight;
layout(location = 5) in vec4 inUp;
layout(location = 6) in vec4 inAhead;
layout(location = 7) in uvec4 inLook;
layout(push_constant) uniform Push { CascadePush cascade; };
#endif
#include "geometry/place.glsl"
#ifndef DEPTH_ALONE
#include "public/cdr_in_plane.glsl"
layout(constant_id = 11) const float kSubPixelsX = 0.0; // from the picture's middle to its edge; 0: vertices stay
layout(constant_id = 12) const float kSubPixelsY = 0.0;

// cdrInPlane() along the picture's axes, since sub-pixels are counted from its middle. normal: along right, up and ahead.
vec3 movedInPlane(vec3 place, vec3 normal, float fromOrigin) {
    vec2 middle = vec2(cascade.lensX, cascade.lensY) / vec2(cascade.projectionX, cascade.projectionY);
    vec2 perSlope = vec2(kSubPixelsX * cascade.projectionX, kSubPixelsY * cascade.projectionY);
    precise vec2 across = place.xy - (cascade.anchorView + place.z) * middle;
    vec3 leaning = vec3(normal.xy, normal.z + dot(normal.xy, middle));
    vec3 moved = cdrInPlane(vec3(across, place.z), leaning, perSlope, fromOrigin, cascade.anchorView);
    precise vec2 back = moved.xy + (cascade.anchorView + moved.z) * middle;
    return vec3(back, moved.z);
}
#endif

layout(location = 0) in vec3 inPosition;
#ifndef DEPTH_ALONE
layout(location = 1) in vec2 inNormal;
layout(location = 2) in vec2 inUv;
layout(location = 3) in vec4 inColor;
#endif
// DETAILED: materials with more than base colour, metallic and roughness.
#ifdef DETAILED
layout(location = 9) in vec4 inTangent; // octahedral, and how the bitangent points
layout(location = 10) in vec2 inSecondUv;
#endif

#ifdef DEPTH_ALONE
layout(location = 1) out float outAhead; // as facet.vert has it
#elif defined(FACETED)
layout(location = 0) out float outAhead;
layout(location = 1) flat out uvec3 outFacet; // the words of a surface that a whole triangle shares
#else
layout(location = 0) out vec4 outNormalAhead;
layout(location = 1) out vec4 outColor;
#ifdef DETAILED
layout(location = 2) out vec4 outUv; // both places
layout(location = 4) out vec4 outTangent;
#else
layout(location = 2) out vec2 outUv;
#endif
layout(location = 3) flat out uvec2 outIdAndCutoff; // id, and DrawRecord::cutoffAndMetallicRoughness
#endif

#ifndef DEPTH_ALONE
#include "geometry/turned_normal.glsl"
#endif

void main() {
#ifndef PUSHED_RECORD
    DrawRecord record = DrawRecord(inRight, inUp, inAhead, inLook.x, inLook.y, inLook.z, inLook.w);
#endif
    precise float x = dot(record.right.xyz, inPosition) + record.right.w;
    precise float y = dot(record.up.xyz, inPosition) + record.up.w;
    precise float ahead = dot(record.ahead.xyz, inPosition) + record.ahead.w;
#ifdef DEPTH_ALONE
    place(x, y, ahead, record.ahead.w);
    outAhead = ahead;
#else
    Axes axes = axesOf(record.right.xyz, record.up.xyz, record.ahead.xyz, record.id);
#ifdef FACETED
    vec3 turned = turnedNormal(axes, cdrDecodeOctahedral(inNormal));
#else
    vec3 turned = turnedNormal(axes, vertexNormal(inNormal));
#endif
    if (kSubPixelsX != 0.0) { // render::Snapping::inPlane
        // Squares of small or large lengths are no floats.
        vec3 beyond = abs(vec3(x, y, ahead) - vec3(record.right.w, record.up.w, record.ahead.w));
        float fromOrigin = max(max(beyond.x, beyond.y), beyond.z);
        vec3 moved = movedInPlane(vec3(x, y, ahead), vec3(turned.xy, -turned.z), fromOrigin);
        x = moved.x;
        y = moved.y;
        ahead = moved.z;
    }
    place(x, y, ahead, record.ahead.w);
    vec4 baseColor = inColor * vec4(unpackHalf2x16(record.baseColorRg), unpackHalf2x16(record.baseColorBa));
    uint id = (record.id & ~kIdMirror) | (cascade.cascade << kIdBits);
#ifdef FACETED
    outAhead = ahead;
    uint albedo = encodeAlbedo(baseColor.rgb);
    albedo = kMetallicRoughness != 0u ? withMetallicRoughness(albedo, record.cutoffAndMetallicRoughness) : albedo;
    outFacet = uvec3(albedo, encodeNormal(turned), id);
#else
    outNormalAhead = vec4(turned, ahead);
    outColor = baseColor;
#ifdef DETAILED
    outUv = vec4(inUv, inSecondUv);
    outTangent = turnedTangent(axes, inTangent);
#else
    outUv = inUv;
#endif
    outIdAndCutoff = uvec2(id, record.cutoffAndMetallicRoughness);
#endif
#endif
}
