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
#define AIR_CONSTANT 4
#include "shading/lighting.glsl"

layout(constant_id = 0) const uint kTextured = 0u;
layout(constant_id = 1) const uint kMetallicRoughness = 0u;

layout(set = 0, binding = 0) uniform sampler2D baseColorTexture;
layout(set = 1, binding = 0) uniform usampler2D gbuffer; // the final opaque G-buffer
#ifdef SHADOWED
layout(push_constant) uniform Push {
    TranslucentPush push;
    TranslucentSlice slice;
};
#define MAP_SET 1
#define MAP_BINDING 2
#include "shadows/reached.glsl"
layout(set = 1, binding = 4, std430) readonly buffer Maps { ReceiverPush maps[]; };
#else
layout(push_constant) uniform Push { TranslucentPush push; };
#endif

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
layout(location = 5) flat in uint inMetallicRoughness;

struct TranslucentFragment {
    vec4 color;        // lit, linear, straight alpha
    vec2 distanceView; // a float pair, less the offset of the layer: what is in front of what
};

// Whether the opaque surface of the pixel lies in front. Both distances are metric and as exact as what drew them, so
// neither cascade nor mapping matters. At the same distance a translucent surface lies on the opaque one.
bool isOccluded(vec2 distanceView) {
    uvec4 texel = texelFetch(gbuffer, ivec2(gl_FragCoord.xy), 0);
    vec2 anchor = header.anchors[(texel.w >> kIdBits) & kCascadeMask];
    return texel.w != 0u && cdrPairLess(cdrPairSum(anchor, aheadOf(texel)), distanceView);
}

// What textures say of a fragment.
struct Surface {
    vec4 baseColor; // linear, straight alpha
    vec3 front;     // normal of the front, of any length
    uint metallicRoughness;
    float openness;
    vec3 emission;
};

Surface surfaceHere() {
    Surface surface = Surface(inColor, inNormalAhead.xyz, inMetallicRoughness, 1.0, vec3(0.0));
    if (kTextured != 0u) {
        surface.baseColor *= texture(baseColorTexture, inUv.xy);
    }
#ifdef DETAILED
    surface.front = detailNormal(inNormalAhead.xyz, inTangent, inUv);
    surface.metallicRoughness = has(kDetailMetallicRoughness) ? metallicRoughnessCode(detailMetallicRoughness(inUv)) : inMetallicRoughness;
    surface.openness = detailOpenness(inUv);
    surface.emission = detailEmission(inUv);
#endif
    return surface;
}

#ifdef SHADOWED
// Which of the first lights reach a surface: as receiver.frag, the least of what its maps say.
vec4 reachedBy(Receiver receiver, vec2 ray) {
    vec4 reached = vec4(1.0);
    float distanceView = receiver.anchor.x + receiver.ahead;
    for (uint i = 0u; i < slice.mapCount; ++i) {
        ReceiverPush map = maps[slice.firstMap + i];
        if (isOf(map, distanceView) && !isReached(map, receiver, ray)) {
            reached[map.channel] = 0.0;
        }
    }
    return reached;
}
#endif

vec4 seenColor(Surface surface, float ahead) {
    float distanceView = inCentreRange.x + ahead;
    vec2 ray = rayAt(gl_FragCoord.xy, vec2(textureSize(gbuffer, 0)));
    vec3 color = surface.baseColor.rgb;
    if ((inId & kIdUnlit) == 0u) {
        uint metallicRoughness = kMetallicRoughness != 0u ? surface.metallicRoughness : 0u;
        vec3 normal = normalize(gl_FrontFacing ? surface.front : -surface.front);
#ifdef SHADOWED
        vec4 reached = reachedBy(Receiver(inCentreRange.xy, ahead, normal), ray);
        LitPoint point = LitPoint(normal, ray, inCentreRange.xy, ahead, surface.openness, reached);
#else
        LitPoint point = LitPoint(normal, ray, inCentreRange.xy, ahead, surface.openness);
#endif
        color = litColor(color, metallicRoughness, point);
    }
#ifdef DETAILED
    color = min(color + surface.emission, kBrightest);
#endif
    color = throughFog(color, ray, distanceView);
    if (kAiry != 0u) {
        color = throughAir(color, ray, distanceView);
    }
    return vec4(min(color, kMostHalf), clamp(surface.baseColor.a, 0.0, 1.0));
}

// By how much the fragment's layer moves it towards the camera.
float layerShift(float ahead) {
    float steepness = abs(dFdx(ahead)) + abs(dFdy(ahead));
    return min(push.layerOffset + push.layerSlope * steepness, 0.5 * (inCentreRange.x + ahead));
}

// Discards what belongs to another range or is occluded.
TranslucentFragment translucentFragment() {
    float ahead = inNormalAhead.w;
    float shift = layerShift(ahead); // this and textures before anything is discarded, since they need derivatives
    Surface surface = surfaceHere();
    // Half-open: of two ranges that meet, exactly one keeps a fragment, since both compare the same bits.
    if (!(ahead >= inCentreRange.z && ahead < inCentreRange.w)) {
        discard;
    }
#ifdef SHADOWED
    if (!(inCentreRange.x + ahead >= slice.nearView && inCentreRange.x + ahead < slice.farView)) {
        discard;
    }
#endif
    vec2 distanceView = cdrPairSum(cdrPairSum(inCentreRange.xy, ahead), -shift);
    if (isOccluded(distanceView)) {
        discard;
    }
    return TranslucentFragment(seenColor(surface, ahead), distanceView);
}

#endif
