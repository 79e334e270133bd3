#version 460
#extension GL_GOOGLE_include_directive : require
#include "binning/binning.glsl"

// First pass: sphere against frustum and cascades, as scene::cullSpheres() and scene::binByDistance() do it, and how
// many instances of the block land in each bucket.
layout(local_size_x = 256) in;

uint landingOf(InstanceSphere sphere) {
    precise double dx = sphere.x - view.position[0];
    precise double dy = sphere.y - view.position[1];
    precise double dz = sphere.z - view.position[2];
    precise double vx = dx * view.right[0] + dy * view.right[1] + dz * view.right[2];
    precise double vy = dx * view.up[0] + dy * view.up[1] + dz * view.up[2];
    double w = viewDistance(sphere);
    precise double sideX = w * view.sinX - abs(vx) * view.cosX;
    precise double sideY = w * view.sinY - abs(vy) * view.cosY;
    double depth = min(w - view.nearView, view.farView - w);
    double radius = double(sphere.radius);
    precise double margin = min(min(sideX, sideY), depth) + radius;
    if (!(margin >= 0.0)) {
        return 0u;
    }
    precise double low = w - radius;
    precise double high = w + radius;
    uint first = 0u;
    uint end = 0u;
    for (uint c = 0u; c < view.cascades; ++c) {
        first += view.farViews[c] < low ? 1u : 0u;
        end += view.nearViews[c] <= high ? 1u : 0u;
    }
    precise double widest = view.wideSpan * max(low, 0.0);
    uint wide = view.hasWideSpan != 0u && high - low > widest ? 1u : 0u;
    return end > first ? packLanding(2u * first + wide, end - first) : 0u;
}

void main() {
    clearMasks();
    barrier();
    uint instance = gl_GlobalInvocationID.x;
    if (instance < view.instances) {
        uint landing = landingOf(spheres[instance]);
        landings[instance] = landing;
        markLanding(landing);
    }
    barrier();
    for (uint row = gl_LocalInvocationIndex; row <= bucketCount(); row += kBinBlock) {
        blockDraws[row * view.blocks + gl_WorkGroupID.x] = landedBefore(row, kBinBlock);
    }
}
