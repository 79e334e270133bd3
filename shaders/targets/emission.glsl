// The emission buffer: beside the G-buffer of scenes that need one, 4 bytes a pixel, meaningful where the id word has
// kIdEmits. Cube roots of emission as three unorm8, up to kMaxEmission; above them the share of ambient light that
// arrives, unorm8. A cube root's steps are 3 % of a colour as bright as white and finer below, and reach far above it.
#ifndef CDR_SHADERS_EMISSION_GLSL
#define CDR_SHADERS_EMISSION_GLSL

const float kMaxEmission = 16.0; // kBrightest of metallic_roughness.glsl

uint encodeEmission(vec3 emission, float openness) {
    vec3 root = pow(clamp(emission / kMaxEmission, 0.0, 1.0), vec3(1.0 / 3.0));
    return packUnorm4x8(vec4(root, openness));
}

vec3 emissionOf(uint word) {
    vec3 root = vec3((uvec3(word) >> uvec3(0u, 8u, 16u)) & 0xffu) * (1.0 / 255.0);
    return root * root * root * kMaxEmission;
}

float opennessOf(uint word) { return float(word >> 24) * (1.0 / 255.0); }

#endif
