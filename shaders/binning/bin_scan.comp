#version 460
#extension GL_GOOGLE_include_directive : require
#include "binning/binning.glsl"

// Second pass, one workgroup: turns the draws of each bucket and block into where they begin, bucket by bucket. The row
// after the last bucket counts visible instances, so its first entry becomes the number of draws.
layout(local_size_x = kBinBlock) in;

shared uint sums[kBinBlock];

void main() {
    uint self = gl_LocalInvocationIndex;
    uint entries = (bucketCount() + 1u) * view.blocks;
    uint perInvocation = (entries + kBinBlock - 1u) / kBinBlock;
    uint begin = min(self * perInvocation, entries);
    uint end = min(begin + perInvocation, entries);
    uint sum = 0u;
    for (uint i = begin; i < end; ++i) {
        sum += blockDraws[i];
    }
    sums[self] = sum;
    barrier();
    uint next = 0u;
    for (uint i = 0u; i < self; ++i) {
        next += sums[i];
    }
    for (uint i = begin; i < end; ++i) {
        uint draws = blockDraws[i];
        blockDraws[i] = next;
        if (i == bucketCount() * view.blocks) {
            result.draws = next;
        }
        next += draws;
    }
    if (self == kBinBlock - 1u) {
        result.drawsAndVisible = next;
    }
}
