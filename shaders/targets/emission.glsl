// The emission buffer: beside the G-buffer of scenes that need one, 4 bytes a pixel, meaningful where the id word has
// kIdEmits. Cube roots of emission as three unorm8, up to kBrightest; above them the share of ambient light that
// arrives, unorm8. A cube root's steps are 3 % of a colour as bright as white and finer below, and reach far above it.
#ifndef CDR_SHADERS_EMISSION_GLSL
#define CDR_SHADERS_EMISSION_GLSL

#include "shading/brightest.glsl"

// Within 2e-5 of it, for x in [0, 1]. pow() takes a logarithm and an exponential, which cost a software rasteriser more than a texture.
// A third of the bits of a float is a third of its logarithm, within 4 %. Two of Newton's steps towards the root's inverse follow.
vec3 cubeRoot(vec3 x) {
    vec3 inverse = intBitsToFloat(ivec3(0x54a2fa8c) - ivec3(vec3(floatBitsToInt(x)) * (1.0 / 3.0)));
    for (int i = 0; i < 2; ++i) {
        inverse *= 4.0 / 3.0 - (1.0 / 3.0) * (x * inverse * inverse * inverse); // from the left: 0 stays 0
    }
    return x * inverse * inverse;
}

uint encodeEmission(vec3 emission, float openness) {
    vec3 root = cubeRoot(clamp(emission * (1.0 / kBrightest), 0.0, 1.0));
    return packUnorm4x8(vec4(root, openness));
}

vec3 emissionOf(uint word) {
    vec3 root = vec3((uvec3(word) >> uvec3(0u, 8u, 16u)) & 0xffu) * (1.0 / 255.0);
    return root * root * root * kBrightest;
}

float opennessOf(uint word) { return float(word >> 24) * (1.0 / 255.0); }

#endif
