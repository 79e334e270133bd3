#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#include "shared.h"
#include "rivals/rivals_shared.h"

// The second pass of keys that leave no room for an id: who had the least key. Of several the highest id, which a depth
// test that lets the last draw win would show.
layout(early_fragment_tests) in;

layout(push_constant) uniform Push {
    CascadePush cascade;
    RivalPush rival;
};
layout(std430, set = 0, binding = 0) readonly buffer Keys { uint64_t keys[]; };
layout(std430, set = 0, binding = 1) buffer Ids { uint ids[]; };

#include "rivals/key.glsl"

void main() {
    uint pixel = pixelIndex();
    if (distanceKey() == keys[pixel]) {
        atomicMax(ids[pixel], inId);
    }
}
