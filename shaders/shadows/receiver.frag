#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "targets/gbuffer.glsl"
#define LIGHTING_SET 0
#define LIGHTING_BINDING 1
#include "shading/lighting_buffer.glsl"
#include "shadows/shadows_shared.h"

// Which surfaces one light reaches, of those that read one of its maps: 1 or 0 in the light's channel. The least of what all
// maps say counts, so 1 is said of all else.
layout(push_constant) uniform Push { ReceiverPush push; };

layout(set = 0, binding = 0) uniform usampler2D gbuffer;
#ifdef FACETS
#define FACETS_BINDING 2
#include "targets/facets.glsl"
layout(set = 0, binding = 3) uniform sampler2D mapDepth;
layout(set = 0, binding = 4) uniform sampler2D mapSlope;
#else
layout(set = 0, binding = 2) uniform sampler2D mapDepth;
layout(set = 0, binding = 3) uniform sampler2D mapSlope;
#endif

layout(location = 0) out vec4 outReached;

const float kRounding = 1.0 / 2097152.0; // of what a place and a depth are made from
const float kHalf = 1.0 / 1024.0;        // of a number kept as a half
const float kMostSlope = 1000.0;
// Of today's practice: texels of bias, and times the larger slope of the caster.
const float kPlainConstant = 0.5;
const float kPlainSlope = 1.75;

vec2 rayHere() {
    return (gl_FragCoord.xy / header.pictureSize * 2.0 - 1.0) * vec2(1.0, -1.0) * header.rayScale;
}

// What is seen at the pixel; the anchor plane is a float and its rest.
struct Receiver {
    bool isSurface;
    vec2 anchor;
    float ahead;
    vec3 normal; // view space
};

#ifdef FACETS
Receiver receiverHere(vec2 ray) {
    uvec4 texel = texelFetch(gbuffer, ivec2(gl_FragCoord.xy), 0);
    Receiver receiver = Receiver(texel.x != 0u, vec2(0.0), 0.0, vec3(0.0, 0.0, 1.0));
    if (receiver.isSurface) {
        FacetRecord facet = facetAt(texel.x);
        receiver.anchor = header.anchors[(facet.id >> kIdBits) & kCascadeMask];
        receiver.normal = normalOf(facet);
        receiver.ahead = aheadOn(facet, receiver.normal, ray, receiver.anchor.x);
    }
    return receiver;
}
#else
Receiver receiverHere(vec2 ray) {
    uvec4 texel = texelFetch(gbuffer, ivec2(gl_FragCoord.xy), 0);
    return Receiver(texel.w != 0u, header.anchors[(texel.w >> kIdBits) & kCascadeMask], aheadOf(texel), normalOf(texel));
}
#endif

// How many texels the surface at a texel of the map, continued to the receiver, lies before it.
float gapAt(ivec2 texel, vec2 inMap, float z, float perTexel, vec3 slope) {
    vec2 across = inMap - (vec2(texel) + 0.5);
    return (texelFetch(mapDepth, texel, 0).r - z) / perTexel + dot(slope.xy, across);
}

float sumOf(vec2 v) { return abs(v.x) + abs(v.y); }

// Along the light's axes.
vec3 alongLight(vec3 v) { return vec3(dot(push.right.xyz, v), dot(push.up.xyz, v), dot(push.ahead.xyz, v)); }

// Texels towards the light per texel across and down, of a surface.
vec2 slopeOf(vec3 normalView, vec2 inView) {
    vec3 normal = alongLight(vec3(normalView.xy, -normalView.z));
    float facing = normal.z + push.lens.wPerUnit * dot(normal.xy, inView);
    return clamp(normal.xy / (abs(facing) < 1e-4 ? 1e-4 : facing), -kMostSlope, kMostSlope);
}

// Whether the light reaches a surface. What the map has of that surface lies in one plane with it, and what it has of a
// neighbouring one of a curved body differs by no more than their slopes do: only what is farther before it casts a shadow.
bool isReached(Receiver receiver, vec2 ray) {
    LightLens lens = push.lens;
    float beyond = (receiver.anchor.x - push.referenceView) + receiver.anchor.y + receiver.ahead;
    float distanceView = receiver.anchor.x + receiver.ahead;
    vec3 offset = vec3(push.right.w, push.up.w, push.ahead.w);
    vec3 point = vec3(ray * distanceView, beyond);
    vec3 place = alongLight(point) + offset;
    float w = lens.wOffset + lens.wPerUnit * place.z;
    if (lens.wOffset == 0.0 && max(abs(place.x), abs(place.y)) > w) {
        return true; // another side of the light says
    }
    float z = (lens.zOffset + lens.zPerUnit * place.z) / w;
    float perTexel = depthPerTexel(lens, z);
    float texelLength = lens.texel * w; // scene units
    vec2 inMap = (place.xy / w - push.low) / lens.texel;
    vec2 slope = slopeOf(receiver.normal, place.xy / w);

    ivec2 last = textureSize(mapDepth, 0) - 1;
    ivec2 corner = clamp(ivec2(floor(inMap - 0.5)), ivec2(0), last - 1);
    ivec2 nearest = clamp(ivec2(floor(inMap)) - corner, ivec2(0), ivec2(1));
    float gaps[4];
    vec3 slopes[4];
    vec2 lowest = slope;
    vec2 highest = slope;
    float steepest = sumOf(slope);
    float rounding = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 texel = corner + ivec2(i & 1, i >> 1);
        slopes[i] = texelFetch(mapSlope, texel, 0).xyz;
        gaps[i] = gapAt(texel, inMap, z, perTexel, slopes[i]);
        lowest = min(lowest, slopes[i].xy);
        highest = max(highest, slopes[i].xy);
        steepest = max(steepest, sumOf(slopes[i].xy));
        rounding = max(rounding, slopes[i].z);
    }
    // Roundings of the point, of both pictures' snapped vertices, of slopes kept as halves, and of depths.
    float numbers = sumOf(point.xy) + abs(beyond) + abs(receiver.ahead) + sumOf(offset.xy) + abs(offset.z);
    float shift = (push.snap * distanceView + kRounding * numbers) / texelLength;
    float allowed = shift * (1.0 + steepest) + steepest * (push.mapSnap + kHalf) + rounding + kRounding * z / perTexel +
                    sumOf(highest - lowest);
    float gap = gaps[nearest.x + 2 * nearest.y];
    if (push.isPlain != 0u) {
        vec3 caster = slopes[nearest.x + 2 * nearest.y];
        float atTexel = (texelFetch(mapDepth, corner + nearest, 0).r - z) / perTexel;
        return atTexel <= kPlainConstant + kPlainSlope * max(abs(caster.x), abs(caster.y));
    }
    if (!(gap > allowed)) { // what is not a number casts no shadow
        return true;
    }
    // Near an edge of facets smaller than a texel another one may be the point's own.
    bool isAnyBehind = false;
    for (int i = 0; i < 4; ++i) {
        isAnyBehind = isAnyBehind || gaps[i] <= allowed;
    }
    return isAnyBehind && gap <= 2.0 * steepest;
}

void main() {
    vec2 ray = rayHere();
    Receiver receiver = receiverHere(ray);
    float distanceView = receiver.anchor.x + receiver.ahead;
    outReached = vec4(1.0);
    if (receiver.isSurface && distanceView >= push.nearView && distanceView < push.farView) {
        float reached = isReached(receiver, ray) ? 1.0 : 0.0;
        for (uint i = 0u; i < 4u; ++i) {
            outReached[i] = i == push.channel ? reached : 1.0;
        }
    }
}
