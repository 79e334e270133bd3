#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "targets/gbuffer.glsl"
#define LIGHTING_SET 0
#define LIGHTING_BINDING 1
#ifndef LAYER
#define FLAT_LIGHTING
#endif
#include "shading/lighting.glsl"

// Deferred shading of the final G-buffer.
layout(constant_id = 0) const uint kFoggy = 0u;
layout(constant_id = 1) const uint kShiny = 0u;
// Whether the mapping has anchor planes; without, none is read. 2 is in flat_lighting.glsl.
layout(constant_id = 3) const uint kAnchored = 1u;

layout(set = 0, binding = 0) uniform usampler2D gbuffer;
// OCCLUDED: by an image of the whole picture, or else OCCLUDED_PER_LAYER by what the layers left in the surfaces.
#if defined(OCCLUDED)
layout(set = 0, binding = 2) uniform sampler2D occlusionImage;
float occlusionIn(ivec2 pixel, uvec4 texel) { return texelFetch(occlusionImage, pixel, 0).r; }
#elif defined(OCCLUDED_PER_LAYER)
float occlusionIn(ivec2 pixel, uvec4 texel) { return occlusionOf(texel); }
#endif

#ifdef LAYER
// One layer of several: colour times coverage, and transmittance, as gpu::Blend::over takes them.
layout(push_constant) uniform Push { LayerFade fade; };
vec4 background() { return vec4(0.0, 0.0, 0.0, 1.0); }
vec4 covering(vec3 color, float ahead) {
    float coverage = 1.0 - clamp((ahead - fade.beginAhead) * fade.perUnit, 0.0, 1.0);
    return vec4(coverage * color, 1.0 - coverage);
}
#else
vec4 background() { return vec4(backgroundColor(), 1.0); }
vec4 covering(vec3 color, float ahead) { return vec4(color, 1.0); }
#endif

layout(location = 0) out vec4 outColor;

vec2 anchorOf(uvec4 texel) {
    return kAnchored != 0u ? header.anchors[(texel.w >> kIdBits) & kCascadeMask] : vec2(0.0);
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
        if (other.w != 0u && abs(apart) < occlusionRadius() && dot(normal, normalOf(other)) > 0.8) {
            sum += vec2(occlusionIn(there, other), 1.0);
        }
    }
    return 1.0 - sum.x / sum.y; // the pixel itself counts
#else
    return 1.0;
#endif
}

vec4 shade(ivec2 pixel, uvec4 texel) {
    vec3 color = albedoOf(texel);
    float ahead = aheadOf(texel);
    vec2 anchor = anchorOf(texel);
    vec2 ray = rayAt(gl_FragCoord.xy, vec2(textureSize(gbuffer, 0)));
    if ((texel.w & kIdUnlit) == 0u) {
        vec3 normal = normalOf(texel);
        uint shine = kShiny != 0u ? shineOf(texel) : 0u;
        color = litColor(color, shine, LitPoint(normal, ray, anchor, ahead, opennessAt(pixel, texel, normal)));
    }
    if (kFoggy != 0u) {
        color = throughFog(color, ray, anchor.x + ahead);
    }
    return covering(color, ahead);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uvec4 texel = texelFetch(gbuffer, pixel, 0);
    outColor = background();
    // A loop of no turn or one: software rasterisers skip what no pixel loops through, but may run both sides of an if.
    uint turns = texel.w == 0u ? 0u : 1u;
    for (uint turn = 0u; turn < turns; ++turn) {
        outColor = shade(pixel, texel);
    }
}
