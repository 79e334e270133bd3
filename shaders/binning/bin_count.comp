#version 460
#extension GL_GOOGLE_include_directive : require
#include "binning/binning.glsl"
#if defined(CHOOSES_OCCLUDERS) || defined(DROPS_HIDDEN)
#include "occluders/hidden.glsl"
#endif

// First pass: sphere against frustum and cascades, as visibility::cullSpheres() and visibility::binByDistance() do it, and how
// many instances of the block land in each bucket. CHOOSES_OCCLUDERS: none but occluders. DROPS_HIDDEN: none that they
// hide, and the next frame is told what was seen.
layout(local_size_x = kBinBlock) in;

uint landingOf(InstanceSphere sphere) {
    double w = viewDistance(sphere);
    precise double vx = along(view.right, sphere) - w * view.centreX;
    precise double vy = along(view.up, sphere) - w * view.centreY;
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

#ifdef DROPS_HIDDEN
shared uint hiddenInBlock;
#endif

uint shownLanding(uint instance) {
    uint landing = landingOf(spheres[instance]);
    if (landing == 0u) {
        return 0u;
    }
#ifdef CHOOSES_OCCLUDERS
    return isOccluder(instance, spheres[instance]) ? landing : 0u;
#elif defined(DROPS_HIDDEN)
    if (isHidden(spheres[instance])) {
        atomicAdd(hiddenInBlock, 1u);
        return 0u;
    }
#endif
    return landing;
}

void main() {
    clearMasks();
#ifdef DROPS_HIDDEN
    hiddenInBlock = 0u;
#endif
    barrier();
    uint instance = gl_GlobalInvocationID.x;
    if (instance < view.instances) {
        uint landing = shownLanding(instance);
        landings[instance] = landing;
        markLanding(landing);
    }
    barrier();
    for (uint row = gl_LocalInvocationIndex; row <= bucketCount(); row += kBinBlock) {
        blockDraws[row * view.blocks + gl_WorkGroupID.x] = landedBefore(row, kBinBlock);
    }
#ifdef DROPS_HIDDEN
    if (gl_LocalInvocationIndex < kMaskWords) {
        seen[gl_WorkGroupID.x * kMaskWords + gl_LocalInvocationIndex] =
            masks[bucketCount() * kMaskWords + gl_LocalInvocationIndex];
    }
    if (gl_LocalInvocationIndex == 0u && hiddenInBlock != 0u) {
        atomicAdd(result.hidden, hiddenInBlock);
    }
#endif
}
