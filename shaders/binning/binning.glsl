// What the four passes of GPU-driven binning share: count, scan, fill, commands. Float64 throughout, in the order of the
// CPU's operations and never contracted. So both paths decide alike and write the same records to the bit.
#ifndef CDR_SHADERS_BINNING_GLSL
#define CDR_SHADERS_BINNING_GLSL

#include "shared.h"
#include "binning/binning_shared.h"

layout(set = 0, binding = 0, std430) readonly buffer View { BinningView view; };
layout(set = 0, binding = 1, std430) readonly buffer Spheres { InstanceSphere spheres[]; };
layout(set = 0, binding = 2, std430) readonly buffer Looks { InstanceLook looks[]; };
layout(set = 0, binding = 3, std430) readonly buffer Materials { MaterialRecord materials[]; };
layout(set = 0, binding = 4, std430) readonly buffer Runs { KindRun runs[]; };
layout(set = 0, binding = 5, std430) readonly buffer Groups { RunGroup groups[]; };
layout(set = 0, binding = 6, std430) readonly buffer Levels { CoarserLevel levels[]; };
layout(set = 0, binding = 7, std430) buffer Landings { uint landings[]; };       // by instance: packLanding()
layout(set = 0, binding = 8, std430) buffer Blocks { uint blockDraws[]; };       // by bucket, then block
layout(set = 0, binding = 9, std430) buffer RunFirsts { uint runFirsts[]; };     // by bucket, then run
layout(set = 0, binding = 10, std430) writeonly buffer Records { DrawRecord records[]; };
layout(set = 0, binding = 11, std430) writeonly buffer Commands { IndirectCommand commands[]; }; // by bucket, then run
layout(set = 0, binding = 12, std430) writeonly buffer Counts { uint commandCounts[]; }; // by bucket, then group
layout(set = 0, binding = 13, std430) buffer Result { BinningResult result; };

// How far along an axis of the camera an instance lies.
double along(double axis[3], InstanceSphere sphere) {
    precise double dx = sphere.x - view.position[0];
    precise double dy = sphere.y - view.position[1];
    precise double dz = sphere.z - view.position[2];
    precise double sum = dx * axis[0] + dy * axis[1] + dz * axis[2];
    return sum;
}

double viewDistance(InstanceSphere sphere) { return along(view.ahead, sphere); }

uint bucketCount() { return 2u * view.cascades; }

// Where an instance lands: `cascades` buckets from `bucket` on, two apart; 0 is nowhere.
uint packLanding(uint bucket, uint cascades) { return bucket | cascades << 8u; }
uint landingBucket(uint landing) { return landing & 0xffu; }
uint landingCascades(uint landing) { return landing >> 8u; }

// One bit per instance of the block and bucket: who lands there. Setting bits in any order gives the same masks. So
// ranks, and with them the order of draws, do not depend on how invocations are scheduled.
const uint kMaskWords = kBinBlock / 32u;
shared uint masks[(kBinBuckets + 1u) * kMaskWords]; // the last row: lands anywhere

void clearMasks() {
    for (uint i = gl_LocalInvocationIndex; i < (kBinBuckets + 1u) * kMaskWords; i += kBinBlock) {
        masks[i] = 0u;
    }
}

void markLanding(uint landing) {
    uint word = gl_LocalInvocationIndex / 32u;
    uint bit = 1u << (gl_LocalInvocationIndex % 32u);
    for (uint c = 0u; c < landingCascades(landing); ++c) {
        atomicOr(masks[(landingBucket(landing) + 2u * c) * kMaskWords + word], bit);
    }
    if (landing != 0u) {
        atomicOr(masks[bucketCount() * kMaskWords + word], bit);
    }
}

// How many of the block's first `end` instances land in a bucket.
uint landedBefore(uint bucket, uint end) {
    uint landed = 0u;
    for (uint word = 0u; word < end / 32u; ++word) {
        landed += bitCount(masks[bucket * kMaskWords + word]);
    }
    if (end % 32u != 0u) {
        landed += bitCount(masks[bucket * kMaskWords + end / 32u] & ((1u << (end % 32u)) - 1u));
    }
    return landed;
}

#endif
