#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "geometry/depth_mapping.glsl"
#include "targets/gbuffer.glsl"

layout(constant_id = 0) const uint kDepthForm = kDepthFormLinear;
layout(constant_id = 1) const uint kTextured = 0u;
layout(constant_id = 2) const uint kMasked = 0u;
layout(constant_id = 3) const uint kWide = 0u;
layout(constant_id = 4) const uint kMetallicRoughness = 0u;

layout(set = 0, binding = 0) uniform sampler2D baseColorTexture;
layout(push_constant) uniform Push { CascadePush cascade; };

// FACETED: the triangle is all one colour and normal, so the vertex shader encodes them, once for many pixels.
#ifdef FACETED
layout(location = 0) in float inAhead;
layout(location = 1) flat in uvec3 inFacet;
#else
layout(location = 0) in vec4 inNormalAhead;
layout(location = 1) in vec4 inColor;
#ifdef DETAILED
layout(location = 2) in vec4 inUv; // both places
layout(location = 4) in vec4 inTangent;
#else
layout(location = 2) in vec2 inUv;
#endif
layout(location = 3) flat in uvec2 inIdAndCutoff; // id, and DrawRecord::cutoffAndMetallicRoughness
#endif

layout(location = 0) out uvec4 outTexel;
#ifdef DETAILED
#define DETAIL_SET 1
#define DETAIL_CONSTANT 10
#include "geometry/detail.glsl"
#include "targets/emission.glsl"
layout(location = 1) out uint outEmission; // of scenes that need it
#endif
#ifdef WRITES_DEPTH
layout(depth_greater) out float gl_FragDepth; // than the tangent that the vertex shader set
#endif
#ifdef LAYERED
#include "geometry/layered_depth.glsl"
#endif

void main() {
#ifdef FACETED
    float ahead = inAhead;
#else
    float ahead = inNormalAhead.w;
#endif
#ifdef LAYERED
    float shift = layerShift(ahead);
    gl_FragDepth = layeredDepth(ahead, shift);
    vec2 inside = layeredClipDistances(ahead, shift);
#else
    vec2 inside = clipDistances(ahead, cascade);
#endif
    // Textures are read before anything is discarded: which level is read follows from the pixels beside this one.
#ifndef FACETED
    vec4 baseColor = inColor;
    if (kTextured != 0u) {
        baseColor *= texture(baseColorTexture, inUv.xy);
    }
#ifdef DETAILED
    vec3 front = detailNormal(inNormalAhead.xyz, inTangent, inUv);
    uint metallicRoughness = has(kDetailMetallicRoughness) ? metallicRoughnessCode(detailMetallicRoughness(inUv)) : inIdAndCutoff.y;
    bool emits = has(kDetailOcclusion | kDetailEmits);
    outEmission = emits ? encodeEmission(detailEmission(inUv), detailOpenness(inUv)) : 0u;
#else
    vec3 front = inNormalAhead.xyz;
    uint metallicRoughness = inIdAndCutoff.y;
#endif
#endif
    // Clipping would round to the size of the triangle. cdrInsideWide() says how cascades overlap here.
    if (kWide != 0u && isCut(inside, ahead, gl_ClipDistance[1], cascade)) {
        discard;
    }
#ifdef FACETED
    outTexel = uvec4(inFacet.xy, floatBitsToUint(ahead), inFacet.z);
#else
    if (kMasked != 0u && baseColor.a < uintBitsToFloat(inIdAndCutoff.y & ~kMetallicRoughnessMask)) {
        discard;
    }
    // Of a double-sided surface the side that faces the camera is lit.
    outTexel = encodeTexel(baseColor.rgb, gl_FrontFacing ? front : -front, ahead, inIdAndCutoff.x);
    if (kMetallicRoughness != 0u) {
        outTexel.x = withMetallicRoughness(outTexel.x, metallicRoughness);
    }
#ifdef DETAILED
    if (emits) {
        outTexel.w |= kIdEmits;
    }
#endif
#endif
#ifdef WRITES_DEPTH
    gl_FragDepth = logDepthInSlice(ahead, cascade);
#endif
}
