// Whether a light reaches a surface, by a map of it. Define MAP_SET and MAP_BINDING first, of two images: a map's depth and
// its slope.
#ifndef CDR_SHADERS_REACHED_GLSL
#define CDR_SHADERS_REACHED_GLSL

#extension GL_EXT_control_flow_attributes : require

#include "shadows/packed_slope.glsl"
#include "shadows/receiver.glsl"
#include "shadows/shadows_shared.h"

layout(set = MAP_SET, binding = MAP_BINDING) uniform sampler2D mapDepth;
layout(set = MAP_SET, binding = MAP_BINDING + 1) uniform sampler2D mapSlope;

const float kRounding = 1.0 / 2097152.0; // of what a place and a depth are made from
// Texels: what lies less before a surface casts no shadow on it. At the inner corners of thin paint all four texels near by may be
// of the paint, which then seems to shadow the ground. A map cannot show so narrow a shadow in its place.
const float kThin = 0.125;
// Of today's practice: texels of bias, and times the larger slope of the caster.
const float kPlainConstant = 0.5;
const float kPlainSlope = 1.75;

// How far the receiver lies beyond the map's view distance of reference: a small difference of two large distances.
float beyondReference(ReceiverPush map, Receiver receiver) {
    precise float beyond = (receiver.anchor.x - map.referenceView) + receiver.anchor.y + receiver.ahead;
    return beyond;
}

// A place of the light's view in texels of the map.
vec2 texelsAt(ReceiverPush map, vec2 inView) {
    precise vec2 texels = (inView - map.low) / map.lens.texel;
    return texels;
}

// How many texels the surface at a texel of the map lies before the receiver's depth.
float texelsBefore(ReceiverPush map, ivec2 texel, float z, float perTexel) {
    precise float texels = (texelFetch(mapDepth, map.mapCorner + texel, 0).r - z) / perTexel;
    return texels;
}

// The same of that surface continued to the receiver.
float gapAt(ReceiverPush map, ivec2 texel, vec2 inMap, float z, float perTexel, vec2 slope) {
    vec2 across = inMap - (vec2(texel) + 0.5);
    return texelsBefore(map, texel, z, perTexel) + dot(slope, across);
}

float sumOf(vec2 v) { return abs(v.x) + abs(v.y); }

// Along the light's axes.
vec3 alongLight(ReceiverPush map, vec3 v) { return vec3(dot(map.right.xyz, v), dot(map.up.xyz, v), dot(map.ahead.xyz, v)); }

// Texels towards the light per texel across and down, of a surface.
vec2 slopeOf(ReceiverPush map, vec3 normalView, vec2 inView) {
    vec3 normal = alongLight(map, vec3(normalView.xy, -normalView.z));
    float facing = normal.z + map.lens.wPerUnit * dot(normal.xy, inView);
    return clamp(normal.xy / (abs(facing) < 1e-4 ? 1e-4 : facing), -kMaxSlope, kMaxSlope);
}

// Whether the light reaches a surface. What the map has of that surface lies in one plane with it. What it has of a
// neighbouring one of a curved body differs by no more than their slopes do. So only what is farther before it casts a
// shadow.
bool isReached(ReceiverPush map, Receiver receiver, vec2 ray) {
    LightLens lens = map.lens;
    float beyond = beyondReference(map, receiver);
    float distanceView = distanceOf(receiver);
    vec3 offset = vec3(map.right.w, map.up.w, map.ahead.w);
    vec3 point = vec3(ray * distanceView, beyond);
    vec3 place = alongLight(map, point) + offset;
    float w = lens.wOffset + lens.wPerUnit * place.z;
    if (lens.wOffset == 0.0 && max(abs(place.x), abs(place.y)) > w) {
        return true; // another side of the light says
    }
    float z = (lens.zOffset + lens.zPerUnit * place.z) / w;
    float perTexel = depthPerTexel(lens, z);
    float texelLength = lens.texel * w; // scene units
    vec2 inMap = texelsAt(map, place.xy / w);
    if (map.part.x > 0.0 && (any(lessThan(inMap, vec2(1.0))) || any(greaterThan(inMap, map.part)))) {
        return true; // another part of the map says
    }
    vec2 slope = slopeOf(map, receiver.normal, place.xy / w);

    ivec2 last = map.mapLast;
    ivec2 corner = clamp(ivec2(floor(inMap - 0.5)), ivec2(0), last - 1);
    ivec2 nearest = clamp(ivec2(floor(inMap)) - corner, ivec2(0), ivec2(1));
    // Roundings of the point, of both pictures' snapped vertices, of slopes as a map keeps them, and of depths.
    float numbers = sumOf(point.xy) + abs(beyond) + abs(receiver.ahead) + sumOf(offset.xy) + abs(offset.z);
    float shift = (map.snap * distanceView + kRounding * numbers) / texelLength;
    vec2 lowest = slope;
    vec2 highest = slope;
    float steepest = sumOf(slope);
    float rounding = 0.0;
    float gap = 0.0;
    float leastGap = 1e38;
    float allowed = 0.0;
    // Each further texel allows more. So where the nearest one is near enough, the others are not read. Software devices skip
    // iterations of a loop that no pixel of a group needs, but not branches.
    [[dont_unroll]] for (int i = 0; i < 4; ++i) {
        ivec2 texel = corner + (nearest ^ ivec2(i & 1, i >> 1));
        MapSlope caster = unpackedSlope(texelFetch(mapSlope, map.mapCorner + texel, 0).xy);
        float gapHere = gapAt(map, texel, inMap, z, perTexel, caster.perTexel);
        if (i == 0) {
            gap = gapHere;
            if (map.isPlain != 0u) {
                float bias = kPlainConstant + kPlainSlope * max(abs(caster.perTexel.x), abs(caster.perTexel.y));
                return texelsBefore(map, texel, z, perTexel) <= bias;
            }
        }
        leastGap = min(leastGap, gapHere);
        lowest = min(lowest, caster.perTexel);
        highest = max(highest, caster.perTexel);
        steepest = max(steepest, sumOf(caster.perTexel));
        rounding = max(rounding, caster.rounding);
        allowed = shift * (1.0 + steepest) + steepest * (map.mapSnap + kKeptSlope) + rounding + kRounding * z / perTexel +
                  sumOf(highest - lowest) + kThin;
        if (!(gap > allowed)) { // what is not a number casts no shadow
            return true;
        }
    }
    // Near an edge of facets smaller than a texel another one may be the point's own.
    return leastGap <= allowed && gap <= 2.0 * steepest;
}

// Whether a map is of surfaces at that view distance.
bool isOf(ReceiverPush map, float distanceView) {
    return distanceView >= map.nearView && distanceView < map.farView;
}

#endif
