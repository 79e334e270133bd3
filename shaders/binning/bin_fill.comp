#version 460
#extension GL_GOOGLE_include_directive : require
#include "binning/binning.glsl"

// Third pass: writes each landed instance's draw records, in instance order within a bucket, and where each run begins.
layout(local_size_x = kBinBlock) in;

// A row of (view * basis), as render::DrawRecordMaker turns it: in float64, then rounded.
vec3 turned(double axis[3], InstanceLook look) {
    precise vec3 row;
    for (uint column = 0u; column < 3u; ++column) {
        precise double sum = axis[0] * double(look.basis[3u * column]) + axis[1] * double(look.basis[3u * column + 1u]) +
                             axis[2] * double(look.basis[3u * column + 2u]);
        row[column] = float(sum);
    }
    return row;
}

void writeRecords(uint instance, uint landing) {
    InstanceSphere sphere = spheres[instance];
    InstanceLook look = looks[instance];
    MaterialRecord material = materials[look.material];
    precise double ahead = viewDistance(sphere);
    DrawRecord record;
    record.right = vec4(turned(view.right, look), float(along(view.right, sphere)));
    record.up = vec4(turned(view.up, look), float(along(view.up, sphere)));
    record.ahead = vec4(turned(view.ahead, look), 0.0);
    record.id = look.id;
    record.cutoffAndMetallicRoughness = material.cutoffAndMetallicRoughness;
    record.baseColorRg = material.baseColorRg;
    record.baseColorBa = material.baseColorBa;
    for (uint c = 0u; c < landingCascades(landing); ++c) {
        uint bucket = landingBucket(landing) + 2u * c;
        uint slot = blockDraws[bucket * view.blocks + gl_WorkGroupID.x] + landedBefore(bucket, gl_LocalInvocationIndex);
        precise double beyond = ahead - view.anchors[bucket / 2u];
        record.ahead.w = float(beyond);
        if (slot < view.recordCapacity) {
            records[slot] = record;
        }
    }
}

void main() {
    clearMasks();
    barrier();
    uint instance = gl_GlobalInvocationID.x;
    bool isInstance = instance < view.instances;
    uint landing = isInstance ? landings[instance] : 0u;
    markLanding(landing);
    barrier();
    if (landing != 0u) {
        writeRecords(instance, landing);
    }
    if (isInstance && (instance == 0u || spheres[instance].run != spheres[instance - 1u].run)) {
        for (uint bucket = 0u; bucket < bucketCount(); ++bucket) {
            runFirsts[bucket * view.runs + spheres[instance].run] =
                blockDraws[bucket * view.blocks + gl_WorkGroupID.x] + landedBefore(bucket, gl_LocalInvocationIndex);
        }
    }
}
