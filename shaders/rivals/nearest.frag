#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
#include "shared.h"
#include "rivals/rivals_shared.h"

// Keeps the least key of each pixel, a log key with the id below it. Of two equal ones it keeps the higher id.
layout(early_fragment_tests) in;

layout(push_constant) uniform Push {
    CascadePush cascade;
    RivalPush rival;
};
layout(std430, set = 0, binding = 0) buffer Keys { uint64_t keys[]; };

#include "rivals/key.glsl"

void main() {
#ifdef LOG
    uint64_t key = (distanceKey() << kIdBits) | (kIdMask - inId);
#else
    uint64_t key = distanceKey();
#endif
    atomicMin(keys[pixelIndex()], key);
}
