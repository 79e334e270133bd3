#version 460
#extension GL_GOOGLE_include_directive : require
#define CDR_LIST_SET 0
#include "translucency/fragment_list.glsl"
#include "public/cdr_float_pair.glsl"

// Sorts a pixel's fragments, nearest first, and lays them over the opaque picture by gpu::Blend::over.
layout(push_constant) uniform Push {
    uint width; // of the picture
    uint height;
};

layout(location = 0) out vec4 outColor;

// Whether fragment a is laid over fragment b. A total order over all that a fragment shows. So lists of the same fragments
// come out alike, whichever was first in. The order is by distance, at the same distance by object, and in one object by
// colour.
bool isNearer(uint a, uint b) {
    vec2 distanceA = vec2(nodes[a].distance, nodes[a].rest);
    vec2 distanceB = vec2(nodes[b].distance, nodes[b].rest);
    if (distanceA != distanceB) {
        return cdrPairLess(distanceA, distanceB);
    }
    if (nodes[a].id != nodes[b].id) {
        return nodes[a].id < nodes[b].id;
    }
    vec4 colorA = vec4(nodes[a].red, nodes[a].green, nodes[a].blue, nodes[a].alpha);
    vec4 colorB = vec4(nodes[b].red, nodes[b].green, nodes[b].blue, nodes[b].alpha);
    for (int i = 0; i < 4; ++i) {
        if (colorA[i] != colorB[i]) {
            return colorA[i] < colorB[i];
        }
    }
    return false;
}

// Merge sort in place, from runs of one up: it needs no array, so a list may be of any length. Returns the new head.
uint sorted(uint head) {
    for (uint runLength = 1u;; runLength *= 2u) {
        uint left = head;
        uint tail = kNoNode;
        uint merges = 0u;
        while (left != kNoNode) {
            ++merges;
            uint right = left;
            uint leftLength = 0u;
            while (leftLength < runLength && right != kNoNode) {
                right = nodes[right].next;
                ++leftLength;
            }
            uint rightLength = runLength;
            while (leftLength > 0u || (rightLength > 0u && right != kNoNode)) {
                bool rightIsEmpty = rightLength == 0u || right == kNoNode;
                uint taken;
                if (leftLength > 0u && (rightIsEmpty || !isNearer(right, left))) {
                    taken = left;
                    left = nodes[left].next;
                    --leftLength;
                } else {
                    taken = right;
                    right = nodes[right].next;
                    --rightLength;
                }
                if (tail == kNoNode) {
                    head = taken;
                } else {
                    nodes[tail].next = taken;
                }
                tail = taken;
            }
            left = right;
        }
        nodes[tail].next = kNoNode;
        if (merges <= 1u) {
            return head;
        }
    }
}

void main() {
    uvec2 place = uvec2(gl_FragCoord.xy);
    // Devices may shade beside the picture to fill a quad, where the list would be another pixel's.
    if (place.x >= width || place.y >= height) {
        discard;
    }
    uint pixel = place.y * width + place.x;
    if (heads[pixel] == kNoNode) {
        discard;
    }
    precise vec3 color = vec3(0.0);
    precise float transmittance = 1.0;
    for (uint node = sorted(heads[pixel]); node != kNoNode; node = nodes[node].next) {
        float alpha = nodes[node].alpha;
        color += transmittance * alpha * vec3(nodes[node].red, nodes[node].green, nodes[node].blue);
        transmittance *= 1.0 - alpha;
    }
    outColor = vec4(color, transmittance);
}
