// The G-buffer of cdr::render for a host's own shaders: what Renderer::surfaces() hands out, and what HostFrame::draw writes.
// An image of four 32-bit unsigned integers, VK_FORMAT_R32G32B32A32_UINT: cdr::render::GBufferPixel. This file needs GLSL
// 4.00 or newer, or HLSL by cdr_gbuffer.hlsl, and what it includes.
//
// @units Distances are view distances in scene units. What has another unit says so.
// @range A texel is one that a frame wrote, or cdrGBufferTexel() made. Any bits give some number, and no error.
#ifndef CDR_GBUFFER_GLSL
#define CDR_GBUFFER_GLSL

#include "cdr_float_pair.glsl"
#include "cdr_octahedral.glsl"

// Object index + 1, 0 for background, of which nothing below means anything.
uint cdrIdOf(uvec4 texel) { return texel.w & 0xffffffu; }

// The index of the cascade that drew the pixel: from 0 to 63.
uint cdrCascadeOf(uvec4 texel) { return (texel.w >> 24u) & 0x3fu; }

// View distance beyond the cascade's anchor plane: metric, whatever the depth mapping.
float cdrAheadOf(uvec4 texel) { return uintBitsToFloat(texel.z); }

// View distance, metric, as a float and the rest that it leaves out. Their difference from another such pair is exact where
// a float's would be lost.
// anchorView: Surfaces::anchorsView of the cascade, as a float and the rest of the double that it leaves out.
vec2 cdrDistanceViewOf(uvec4 texel, vec2 anchorView) { return cdrPairSum(anchorView, cdrAheadOf(texel)); }

// The share from -1 to 1 that 16 bits hold. bits: the lower 16 count.
float cdrSnorm16(uint bits) { return max(float(int(bits << 16u) >> 16) / 32767.0, -1.0); }
// The 16 bits nearest to `value`, a share from -1 to 1; beyond, those of the end.
uint cdrToSnorm16(float value) { return uint(int(round(clamp(value, -1.0, 1.0) * 32767.0))) & 0xffffu; }

// Unit normal in view space, which is right-handed and looks down -z.
vec3 cdrNormalOf(uvec4 texel) {
    return normalize(cdrDecodeOctahedral(vec2(cdrSnorm16(texel.y), cdrSnorm16(texel.y >> 16u))));
}

// Linear albedo in [0, 1].
vec3 cdrAlbedoOf(uvec4 texel) {
    vec3 root = vec3(float(texel.x & 0xffu), float((texel.x >> 8u) & 0xffu), float((texel.x >> 16u) & 0xffu)) / 255.0;
    return root * root;
}

// Motion, of Surfaces::motion or HostFrame::motion: from a pixel to where its surface was one frame before. In pixels, x to
// the right and y down. Half a picture to the left is (-width / 2, 0). Background moves as what is infinitely far.
#define CDR_NO_MOTION 1e30 // in both, of what was not in front of the last camera

// Whether the surface was in front of the last camera, and less than 65504 pixels to the right. A half float that was to be
// CDR_NO_MOTION is 65504, the largest, or infinity. motion: in pixels, as above.
bool cdrHasMotion(vec2 motion) { return motion.x < 65504.0; }

// Where to sample the last picture, as shares of it. uv: of this pixel's centre, both from 0 to 1. motion and pictureSize: in
// pixels. What was outside the last picture gives a share below 0 or above 1.
// @range motion: one that cdrHasMotion(). pictureSize: above 0.
vec2 cdrLastUv(vec2 uv, vec2 motion, vec2 pictureSize) { return uv + motion / pictureSize; }

// The texel of a matt surface.
// albedo: linear. normal: view space. ahead: beyond the anchor plane of `cascade`. id: object index + 1.
// cascade: HostCascade::index.
// @range albedo: in [0, 1]. normal: of any length but 0. id: from 1 to 2^24 - 1. cascade: below 64.
uvec4 cdrGBufferTexel(vec3 albedo, vec3 normal, float ahead, uint id, uint cascade) {
    vec2 folded = cdrEncodeOctahedral(normal);
    uint red = uint(round(clamp(sqrt(albedo.x), 0.0, 1.0) * 255.0));
    uint green = uint(round(clamp(sqrt(albedo.y), 0.0, 1.0) * 255.0));
    uint blue = uint(round(clamp(sqrt(albedo.z), 0.0, 1.0) * 255.0));
    return uvec4(red | (green << 8u) | (blue << 16u), cdrToSnorm16(folded.x) | (cdrToSnorm16(folded.y) << 16u), floatBitsToUint(ahead),
                 (id & 0xffffffu) | (cascade << 24u));
}

#endif
