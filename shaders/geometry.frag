#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "depth_mapping.glsl"
#include "octahedral.glsl"

layout(constant_id = 0) const uint kDepthForm = kDepthFormLinear;
layout(constant_id = 1) const uint kTextured = 0u;
layout(constant_id = 2) const uint kMasked = 0u;
layout(constant_id = 3) const uint kWide = 0u;

layout(set = 0, binding = 1, std430) readonly buffer Materials { MaterialRecord materials[]; };
layout(set = 1, binding = 0) uniform sampler2D baseColorTexture;
layout(push_constant) uniform Push { CascadePush cascade; };

layout(location = 0) in vec3 inNormal;
layout(location = 1) in vec2 inUv;
layout(location = 2) in vec4 inColor;
layout(location = 3) in float inAhead;
layout(location = 4) flat in uint inObject;
layout(location = 5) flat in uint inMaterial;

layout(location = 0) out vec4 outAlbedo;
layout(location = 1) out uint outNormal;
layout(location = 2) out float outAhead;
layout(location = 3) out uint outId;

void main() {
    // Clipping would round to the size of the triangle; the interpolated distance rounds to itself, and is the same in
    // every cascade, so cutting by it leaves no seam.
    if (kWide != 0u && any(lessThan(clipDistances(inAhead, cascade), vec2(0.0)))) {
        discard;
    }
    MaterialRecord material = materials[inMaterial];
    vec4 baseColor = material.baseColorFactor * inColor;
    if (kTextured != 0u) {
        baseColor *= texture(baseColorTexture, inUv);
    }
    if (kMasked != 0u && baseColor.a < material.alphaCutoff) {
        discard;
    }
#ifdef WRITES_DEPTH
    // The viewport moves interpolated depths into the slice, but not those set here.
    float depth = logDepth(cascade.anchorView + inAhead, cascade.depthScale, cascade.depthOffset);
    gl_FragDepth = cascade.minDepth + depth * (cascade.maxDepth - cascade.minDepth);
#endif
    vec3 normal = normalize(inNormal);
    bool lit = (material.flags & kMaterialUnlit) == 0u;
    outAlbedo = vec4(baseColor.rgb, lit ? 1.0 : 0.0);
    // Of a double-sided surface the side that faces the camera is lit.
    outNormal = packSnorm2x16(encodeOctahedral(gl_FrontFacing ? normal : -normal));
    outAhead = inAhead;
    outId = inObject | (cascade.cascade << kIdBits);
}
