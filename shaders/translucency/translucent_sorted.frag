#version 460
#extension GL_GOOGLE_include_directive : require
#define CDR_LIST_SET 2
#include "translucency/fragment_list.glsl"
#define DETAIL_SET 3
#include "translucency/translucent_fragment.glsl"

// Keeps every translucent fragment. In which order they come, and so which node each gets, changes nothing: the list
// is sorted by what the nodes hold.
layout(location = 0) out vec4 outCount; // red, by gpu::Blend::accumulate, where fragments are counted

void main() {
    TranslucentFragment fragment = translucentFragment();
    uint node = atomicAdd(fragmentCount, 1u) + 1u; // behind kNoNode
    if (node <= push.capacity) {
        uint pixel = uint(gl_FragCoord.y) * push.width + uint(gl_FragCoord.x);
        uint next = atomicExchange(heads[pixel], node);
        vec4 color = fragment.color;
        nodes[node] = FragmentNode(color.r, color.g, color.b, color.a, fragment.distanceView.x,
                                   fragment.distanceView.y, inId & kIdMask, next);
    } else if (node > kMostCounted) {
        atomicMin(fragmentCount, kMostCounted); // at 2^32 it would begin anew, and give nodes twice
    }
    outCount = vec4(1.0, 0.0, 0.0, 0.0);
}
