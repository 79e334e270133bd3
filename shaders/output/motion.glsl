// How far a pixel's surface has to go back to where it was in the last picture, for the passes that write motion.
// What moved is a sum of differences that the CPU formed in float64, so nothing large is subtracted here.
#ifndef CDR_SHADERS_MOTION_GLSL
#define CDR_SHADERS_MOTION_GLSL

#include "shared.h"
#include "output/motion_shared.h"
#include "public/cdr_gbuffer.glsl"
#include "shading/lighting.glsl"

layout(set = 0, binding = 0) uniform usampler2D gbuffer;
layout(set = 0, binding = 2, std430) readonly buffer Motion {
    MotionHeader motion;
    MotionRecord records[];
};
layout(set = 0, binding = 3, std430) readonly buffer Table { uint recordOf[]; }; // by object: 0, or 1 + its record

// a * b + c of pairs, as a float.
float turnedAndShifted(vec2 a, vec2 b, vec2 c) {
    vec2 product = cdrExactProduct(a.x, b.x);
    vec2 sum = cdrExactSum(product.x, c.x);
    precise float rest = ((product.y + (a.x * b.y + a.y * b.x)) + c.y) + sum.y;
    return sum.x + rest;
}

// What the last camera's coordinates of a point have more than this one's.
vec3 added(vec2 ray, vec2 distanceView, vec3 shift, vec3 shiftRest) {
    vec2 beside = ray * distanceView.x;
    return vec3(turnedAndShifted(motion.turnRight.zw, distanceView, vec2(shift.x, shiftRest.x)) + dot(motion.turnRight.xy, beside),
                turnedAndShifted(motion.turnUp.zw, distanceView, vec2(shift.y, shiftRest.y)) + dot(motion.turnUp.xy, beside),
                turnedAndShifted(motion.turnAhead.zw, distanceView, vec2(shift.z, shiftRest.z)) + dot(motion.turnAhead.xy, beside));
}

// In pixels, as cdr_gbuffer.glsl has motion. texel: of the G-buffer. pixel: its centre. deformed: by how much the last camera's
// coordinates of the point differ from those of one that stays in its mesh.
vec2 motionOf(uvec4 texel, vec2 pixel, vec3 deformed) {
    uint id = cdrIdOf(texel);
    vec2 ray = rayAt(pixel, vec2(textureSize(gbuffer, 0)));
    vec2 distanceView = vec2(1.0, 0.0); // of a direction: background only turns
    vec3 gained = added(ray, distanceView, vec3(0.0), vec3(0.0));
    if (id != 0u) {
        vec2 anchor = header.anchors[cdrCascadeOf(texel)];
        distanceView = cdrDistanceViewOf(texel, anchor);
        uint record = id <= motion.objects ? recordOf[id - 1u] : 0u;
        if (record == 0u) {
            gained = added(ray, distanceView, motion.shift.xyz, motion.shiftRest.xyz);
        } else {
            MotionRecord moved = records[record - 1u];
            vec3 fromCentre = vec3(ray * distanceView.x - vec2(moved.right.w, moved.up.w),
                                   distanceBetween(vec2(moved.ahead.w, moved.shift.w), 0.0, anchor, cdrAheadOf(texel)));
            gained = added(ray, distanceView, moved.shift.xyz, moved.shiftRest.xyz) +
                     vec3(dot(moved.right.xyz, fromCentre), dot(moved.up.xyz, fromCentre), dot(moved.ahead.xyz, fromCentre));
        }
    }
    gained += deformed;
    float distanceBefore = distanceView.x + gained.z;
    return distanceBefore > 0.0
               ? (gained.xy - ray * gained.z) / distanceBefore * motion.pixels + ray * motion.pixelsAdded + motion.middle
               : vec2(CDR_NO_MOTION);
}

#endif
