// Places and distances that one float is too coarse for, on devices without float64. One is the view distance of what the
// recipe drew. Others are the places of objects that the device itself moves or culls. The CPU makes one CdrView a frame
// and one CdrCascade a cascade; places of objects are pairs of floats, as cdr::depth::floatPair() makes them. This file
// needs GLSL 4.00 or newer, or HLSL by cdr_view.hlsl, and what it includes.
//
// @units Places and distances are in scene units: world space for what an object and the eye are at, view distances else.
// @range Places and distances up to 10^19 units, so that products of them stay below a float's greatest number.
#ifndef CDR_VIEW_GLSL
#define CDR_VIEW_GLSL

#include "cdr_depth.glsl"
#include "cdr_float_pair.glsl"

// View distance, metric, as a float and the rest that it leaves out: what lies `ahead` of the cascade's anchor. Off by at
// most 2^-47 of it or of the anchor. So the difference of two such pairs keeps what a float's would lose.
// ahead: as the vertex shader hands it on, or as the G-buffer kept it.
vec2 cdrDistanceViewPair(float ahead, CdrCascade cascade) {
    return cdrPairSum(vec2(cascade.terms.x, cascade.terms.w), ahead);
}

// A camera: cdr::depth::ViewConstants. Eight vec4, so that its 128 bytes are the same in every kind of buffer. What a name
// with `Rest` holds is added to the one before it; the fourth component of each is unused.
struct CdrView {
    vec4 eye, eyeRest; // world space
    vec4 right, rightRest;
    vec4 up, upRest;
    vec4 forward, forwardRest;
};

// One coordinate of an object about the eye, along an axis of world space, as a pair. placeRest and eyeRest:
// what `place` and `eye` leave out.
vec2 cdrFromEye(float place, float placeRest, float eye, float eyeRest) {
    return cdrPairAdd(vec2(place, placeRest), vec2(-eye, -eyeRest));
}

// How far (x, y, z), pairs of world space, reaches along an axis, as a pair. axisRest: what `axis` leaves out.
// @range axis: a unit vector.
vec2 cdrAlong(vec2 x, vec2 y, vec2 z, vec4 axis, vec4 axisRest) {
    return cdrPairAdd(cdrPairAdd(cdrPairProduct(x, vec2(axis.x, axisRest.x)), cdrPairProduct(y, vec2(axis.y, axisRest.y))),
                      cdrPairProduct(z, vec2(axis.z, axisRest.z)));
}

// View-space x and y of a place, and its view distance beyond the cascade's anchor. A vertex shader adds to it what lies
// about that place. Off by at most 2^-43 of the numbers that go in: a ten-thousandth of a unit at 10^9 units.
// place + placeRest: world space.
vec3 cdrPlace(vec3 place, vec3 placeRest, CdrView view, CdrCascade cascade) {
    vec2 x = cdrFromEye(place.x, placeRest.x, view.eye.x, view.eyeRest.x);
    vec2 y = cdrFromEye(place.y, placeRest.y, view.eye.y, view.eyeRest.y);
    vec2 z = cdrFromEye(place.z, placeRest.z, view.eye.z, view.eyeRest.z);
    vec2 distanceView = cdrAlong(x, y, z, view.forward, view.forwardRest);
    vec2 ahead = cdrPairAdd(distanceView, vec2(-cascade.terms.x, -cascade.terms.w));
    return vec3(cdrAlong(x, y, z, view.right, view.rightRest).x, cdrAlong(x, y, z, view.up, view.upRest).x, ahead.x);
}

#endif
