// The G-buffer: 16 bytes a pixel in one image of four uints. On a software rasteriser, one wide store and one wide load
// cost far less than four narrow ones.
//   x: albedo, square root of linear, three unorm8 (a square root stands in for the sRGB curve). Above it is one byte: how
//      the surface reflects (metallic_roughness.glsl), 0 is matt. Where each cascade computes ambient occlusion by itself,
//      this byte is the occlusion, unorm8, 0 is open.
//   y: normal, view space, octahedral, two snorm16
//   z: view distance beyond the cascade's anchor plane, float bits
//   w: id word, kIdBits; 0 is background
#ifndef CDR_SHADERS_GBUFFER_GLSL
#define CDR_SHADERS_GBUFFER_GLSL

#include "public/cdr_octahedral.glsl"
#include "shading/cheap_division.glsl"

uint encodeAlbedo(vec3 albedo) { return packUnorm4x8(vec4(sqrt(albedo), 0.0)); }
uint encodeNormal(vec3 normal) { return packSnorm2x16(cdrEncodeOctahedral(normal)); }

uvec4 encodeTexel(vec3 albedo, vec3 normal, float ahead, uint id) {
    return uvec4(encodeAlbedo(albedo), encodeNormal(normal), floatBitsToUint(ahead), id);
}

vec3 albedoOf(uvec4 texel) {
    vec3 root = vec3((uvec3(texel.x) >> uvec3(0u, 8u, 16u)) & 0xffu);
    return root * root * (1.0 / 65025.0);
}

vec3 normalOf(uvec4 texel) {
    ivec2 steps = ivec2(int(texel.y << 16) >> 16, int(texel.y) >> 16);
    return unit(cdrDecodeOctahedral(vec2(steps) * (1.0 / 32767.0)));
}

float occlusionOf(uvec4 texel) { return unpackUnorm4x8(texel.x).a; }
uint withOcclusion(uint albedo, float occlusion) { return (albedo & 0xffffffu) | (packUnorm4x8(vec4(occlusion, 0.0, 0.0, 0.0)) << 24); }

uint metallicRoughnessOf(uvec4 texel) { return texel.x >> 24; }
uint withMetallicRoughness(uint albedo, uint cutoffAndMetallicRoughness) { return albedo | (cutoffAndMetallicRoughness << 24); }

float aheadOf(uvec4 texel) { return uintBitsToFloat(texel.z); }

#endif
