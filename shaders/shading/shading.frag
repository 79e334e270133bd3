#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "targets/gbuffer.glsl"
#define SKY_CONSTANT 7
#define AIR_CONSTANT 8
#ifndef LAYER
#define FLAT_LIGHTING
#endif
#include "shading/lighting.glsl"
#include "shading/finish.glsl"

// Deferred shading of the final surfaces.
layout(constant_id = 0) const uint kFoggy = 0u;
layout(constant_id = 1) const uint kMetallicRoughness = 0u;
// render::AnchorForm. Constant 2 is in flat_lighting.glsl.
layout(constant_id = 3) const uint kAnchored = 1u;
// Whether the stencil test leaves out background, so that none comes here.
layout(constant_id = 4) const uint kMarked = 0u;
// What is done here, where no later step does it.
layout(constant_id = 5) const uint kFinish = kFinishNone;
layout(constant_id = 6) const float kExposure = 1.0;

// FACETS: surfaces come from a visibility buffer and its facets instead.
layout(set = 0, binding = 0) uniform usampler2D gbuffer;
#ifdef FACETS
#define FACETS_BINDING 2
#include "targets/facets.glsl"
#endif
// EMISSION: an emission buffer says more of surfaces with kIdEmits.
#ifdef EMISSION
#ifdef OCCLUDED
layout(set = 0, binding = 3) uniform usampler2D emissionBuffer;
#else
layout(set = 0, binding = 2) uniform usampler2D emissionBuffer;
#endif
#include "targets/emission.glsl"
#endif
// SHADOWED: by the binding of a mask that says which lights reach a surface.
#ifdef SHADOWED
layout(set = 0, binding = SHADOWED) uniform sampler2D shadowMask;
#endif
// OCCLUDED: by an image of the whole picture, or else OCCLUDED_PER_LAYER by what the layers left in the surfaces.
#if defined(OCCLUDED)
layout(set = 0, binding = 2) uniform sampler2D occlusionImage;
float occlusionIn(ivec2 pixel, uvec4 texel) { return texelFetch(occlusionImage, pixel, 0).r; }
#elif defined(OCCLUDED_PER_LAYER)
float occlusionIn(ivec2 pixel, uvec4 texel) { return occlusionOf(texel); }
#endif

#ifdef LAYER
// One layer of several: colour times opacity, and transmittance, as gpu::Blend::over takes them.
layout(push_constant) uniform Push { LayerFade fade; };
vec4 background() { return vec4(0.0, 0.0, 0.0, 1.0); }
vec4 covering(vec3 color, float ahead) {
    float opacity = 1.0 - clamp((ahead - fade.beginAhead) * fade.perUnit, 0.0, 1.0);
    return vec4(opacity * color, 1.0 - opacity);
}
#else
vec4 background() { return kFoggy != 0u ? header.shownBackground : vec4(backgroundColor(), 1.0); }
vec4 covering(vec3 color, float ahead) { return vec4(color, 1.0); }
#endif

layout(location = 0) out vec4 outColor;

vec2 anchorOf(uvec4 texel) {
    uint cascade = (texel.w >> kIdBits) & kCascadeMask;
#ifdef FLAT_LIGHTING
    if (kAnchored == 2u) {
        return flatAnchor(cascade);
    }
    if (kAnchored == 3u) {
        return flatAnchorOfFirst();
    }
#endif
    return kAnchored != 0u ? header.anchors[cascade] : vec2(0.0);
}

// Averages the 4 x 4 pixels around that lie on about the same surface: what the noise of occlusion.glsl repeats in.
float opennessAt(ivec2 pixel, uvec4 texel, vec3 normal) {
#if defined(OCCLUDED) || defined(OCCLUDED_PER_LAYER)
    ivec2 last = textureSize(gbuffer, 0) - 1;
    vec2 sum = vec2(0.0);
    for (int i = 0; i < 16; ++i) {
        ivec2 there = clamp(pixel + ivec2(i & 3, i >> 2) - 2, ivec2(0), last);
        uvec4 other = texelFetch(gbuffer, there, 0);
        float apart = distanceBetween(anchorOf(texel), aheadOf(texel), anchorOf(other), aheadOf(other));
        if (other.w != 0u && abs(apart) <= occlusionRadius() && dot(normal, normalOf(other)) > 0.8) {
            sum += vec2(occlusionIn(there, other), 1.0);
        }
    }
    return 1.0 - sum.x / sum.y; // the pixel itself counts, even where the radius rounds to 0
#else
    return 1.0;
#endif
}

#ifdef FLAT_LIGHTING
vec2 rayHere() { return rayAt(gl_FragCoord.xy); }
#else
vec2 rayHere() { return rayAt(gl_FragCoord.xy, vec2(textureSize(gbuffer, 0))); }
#endif

struct Surface {
    vec3 albedo;
    vec3 normal;
    uint metallicRoughness;
    uint id;
    vec2 ray;
    vec2 anchor;
    float ahead;
};

#ifdef FACETS
bool isBackground(uvec4 texel) { return texel.x == 0u; }

Surface surfaceOf(uvec4 texel) {
    FacetRecord facet = facetAt(texel.x);
    vec2 ray = rayHere();
    uvec4 known = uvec4(facet.albedo, 0u, 0u, facet.id);
    vec2 anchor = anchorOf(known);
    vec3 normal = normalOf(facet);
    return Surface(albedoOf(known), normal, metallicRoughnessOf(known), facet.id, ray, anchor, aheadOn(facet, normal, ray, anchor.x));
}
#else
bool isBackground(uvec4 texel) { return texel.w == 0u; }

Surface surfaceOf(uvec4 texel) {
    vec2 ray = rayHere();
    return Surface(albedoOf(texel), normalOf(texel), metallicRoughnessOf(texel), texel.w, ray, anchorOf(texel), aheadOf(texel));
}
#endif

// A surface's light as it leaves it, but for air. Sets its view distance.
vec4 shade(ivec2 pixel, uvec4 texel, out float distanceView) {
    Surface surface = surfaceOf(texel);
    vec3 color = surface.albedo;
#ifdef EMISSION
    uint emission = (surface.id & kIdEmits) != 0u ? texelFetch(emissionBuffer, pixel, 0).x : 0xff000000u;
#endif
    if ((surface.id & kIdUnlit) == 0u) {
        uint metallicRoughness = kMetallicRoughness != 0u ? surface.metallicRoughness : 0u;
        float openness = opennessAt(pixel, texel, surface.normal);
#ifdef EMISSION
        openness *= opennessOf(emission);
#endif
        LitPoint point;
        point.normal = surface.normal;
        point.ray = surface.ray;
        point.anchor = surface.anchor;
        point.ahead = surface.ahead;
        point.openness = openness;
#ifdef SHADOWED
        point.reached = texelFetch(shadowMask, pixel, 0);
#endif
        color = litColor(color, metallicRoughness, point);
    }
#ifdef EMISSION
    if ((surface.id & kIdEmits) != 0u) { // or its look would depend on whether others emit
        color = min(color + emissionOf(emission), kBrightest);
    }
#endif
    if (kFoggy != 0u) {
        color = throughFog(color, surface.ray, surface.anchor.x + surface.ahead);
    }
    distanceView = surface.anchor.x + surface.ahead;
    return covering(color, surface.ahead);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uvec4 texel = texelFetch(gbuffer, pixel, 0);
    bool isSurface = kMarked != 0u || !isBackground(texel);
    outColor = background();
    float distanceView = -1.0;
    if (isSurface) {
        outColor = shade(pixel, texel, distanceView);
    }
    // Once for surfaces and background: some software devices run both sides of a branch.
    if (kAiry != 0u) {
        outColor.rgb = throughAir(outColor.rgb, rayHere(), distanceView);
    }
    if (isSurface || kAiry != 0u || kFinish == kFinishLater) { // other backgrounds are finished already
        outColor.rgb = finished(outColor.rgb, kFinish, kExposure);
    }
}
