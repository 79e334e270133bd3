// What every translucent fragment shader begins with: whether the fragment is there, and its colour.
#ifndef CDR_SHADERS_TRANSLUCENT_FRAGMENT_GLSL
#define CDR_SHADERS_TRANSLUCENT_FRAGMENT_GLSL

#include "shared.h"
#include "translucency/translucent_shared.h"
#include "targets/gbuffer.glsl"
#include "public/cdr_float_pair.glsl"
#define LIGHTING_SET 1
#define LIGHTING_BINDING 1
#define SKY_CONSTANT 2
#include "shading/lighting.glsl"

layout(constant_id = 0) const uint kTextured = 0u;
layout(constant_id = 1) const uint kShiny = 0u;

layout(set = 0, binding = 0) uniform sampler2D baseColorTexture;
layout(set = 1, binding = 0) uniform usampler2D gbuffer; // the final opaque G-buffer
layout(push_constant) uniform Push { TranslucentPush push; };

layout(location = 0) in vec4 inNormalAhead;
layout(location = 1) in vec4 inColor;
#ifdef DETAILED
#define DETAIL_CONSTANT 3
#include "geometry/detail.glsl"
layout(location = 2) in vec4 inUv; // both places
layout(location = 6) in vec4 inTangent;
#else
layout(location = 2) in vec2 inUv;
#endif
layout(location = 3) flat in vec4 inCentreRange;
layout(location = 4) flat in uint inId;
layout(location = 5) flat in uint inShine;

struct TranslucentFragment {
    vec4 color;        // lit, linear, straight alpha
    vec2 distanceView; // a float pair, less the offset of the layer: what is in front of what
};

// Whether the opaque surface of the pixel lies in front. Both distances are metric and as exact as what drew them, so
// neither cascade nor mapping matters; at the same distance a translucent surface lies on the opaque one.
bool isOccluded(vec2 distanceView) {
    uvec4 texel = texelFetch(gbuffer, ivec2(gl_FragCoord.xy), 0);
    vec2 anchor = header.anchors[(texel.w >> kIdBits) & kCascadeMask];
    return texel.w != 0u && cdrPairLess(cdrPairSum(anchor, aheadOf(texel)), distanceView);
}

vec4 seenColor(vec4 baseColor, float ahead) {
    float distanceView = inCentreRange.x + ahead;
    vec2 ray = rayAt(gl_FragCoord.xy, vec2(textureSize(gbuffer, 0)));
    vec3 color = baseColor.rgb;
    if ((inId & kIdUnlit) == 0u) {
#ifdef DETAILED
        vec3 front = detailNormal(inNormalAhead.xyz, inTangent, inUv);
        uint shine = has(kDetailShine) ? shineCode(detailShine(inUv)) : inShine;
        float openness = detailOpenness(inUv);
#else
        vec3 front = inNormalAhead.xyz;
        uint shine = inShine;
        float openness = 1.0;
#endif
        shine = kShiny != 0u ? shine : 0u;
        vec3 normal = normalize(gl_FrontFacing ? front : -front);
        color = litColor(color, shine, LitPoint(normal, ray, inCentreRange.xy, ahead, openness));
#ifdef DETAILED
        color = min(color + detailEmission(inUv), kBrightest);
#endif
    }
    return vec4(throughFog(color, ray, distanceView), baseColor.a);
}

// By how much the fragment's layer moves it towards the camera.
float layerShift(float ahead) {
    float steepness = abs(dFdx(ahead)) + abs(dFdy(ahead));
    return min(push.layerOffset + push.layerSlope * steepness, 0.5 * (inCentreRange.x + ahead));
}

// Discards what belongs to another cascade or is occluded.
TranslucentFragment translucentFragment() {
    float ahead = inNormalAhead.w;
    float shift = layerShift(ahead); // before anything is discarded, since it needs derivatives
    // Half-open: of two cascades that meet, exactly one keeps a fragment, since both compare the same bits.
    if (!(ahead >= inCentreRange.z && ahead < inCentreRange.w)) {
        discard;
    }
    vec2 distanceView = cdrPairSum(cdrPairSum(inCentreRange.xy, ahead), -shift);
    if (isOccluded(distanceView)) {
        discard;
    }
    vec4 baseColor = inColor;
    if (kTextured != 0u) {
        baseColor *= textureLod(baseColorTexture, inUv.xy, 0.0); // textures have one level; no derivatives needed
    }
    baseColor.a = clamp(baseColor.a, 0.0, 1.0);
    return TranslucentFragment(seenColor(baseColor, ahead), distanceView);
}

#endif
