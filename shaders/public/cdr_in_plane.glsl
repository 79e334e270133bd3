// Keeps triangles in their planes where a device rounds vertices to sub-pixels. It does so across the picture and leaves their
// depth, so triangles tilt, and surfaces that are close together swap. For GLSL 4.00 or newer, or HLSL by cdr_in_plane.hlsl. It
// relies on float32 sums and products that are rounded to nearest.
//
// @units Distances are view distances in scene units; `ahead` is one less anchorView, as in cdr_depth.glsl.
// @range Finite numbers.
#ifndef CDR_IN_PLANE_GLSL
#define CDR_IN_PLANE_GLSL

#include "cdr_float_pair.glsl"

// How far view-space x lies from the middle of a sub-pixel, or y. Its terms are exact, since their difference is as small as what
// float32 rounds them by.
// x: view space. distanceView: of it. subPixel: a whole number, from the picture's middle. perSlope: sub-pixels per unit of x / w.
// @units Scene units. @range perSlope: not 0.
float cdrAcrossToSubPixel(float x, float distanceView, float subPixel, float perSlope) {
    vec2 wanted = cdrExactProduct(subPixel, distanceView);
    vec2 given = cdrExactProduct(x, perSlope);
    return ((wanted.x - given.x) + (wanted.y - given.y)) / perSlope;
}

// A vertex, moved in the plane of its triangle to the middle of the nearest sub-pixel. The device rounds it to itself. Call it
// before cdrCascadePosition() and the like. All triangles of the vertex must lie in that plane. place: view-space x and y, and
// the distance beyond anchorView. normal: of the plane, in the axes of `place`. The third axis points away from the camera.
// perSlope: sub-pixels per unit of x / w and of y / w. That is half the picture's size in pixels times 2^subPixelPrecisionBits,
// times what view-space x and y are multiplied by. mostView: what the distance may change by, best the vertex's own distance to
// its object's origin. A plane that is seen from the edge leaves its object within a sub-pixel.
// @range normal: any length but 0. perSlope: not 0. A vertex behind the camera stays where it is. One that would move farther than
// mostView, or than a quarter of its distance, keeps its distance, as the device does.
vec3 cdrInPlane(vec3 place, vec3 normal, vec2 perSlope, float mostView, float anchorView) {
    float distanceView = anchorView + place.z;
    if (!(distanceView > 0.0)) {
        return place;
    }
    vec2 nearest = floor(vec2(place.x, place.y) / distanceView * perSlope + 0.5);
    vec2 across = vec2(cdrAcrossToSubPixel(place.x, distanceView, nearest.x, perSlope.x),
                       cdrAcrossToSubPixel(place.y, distanceView, nearest.y, perSlope.y));
    vec2 ray = nearest / perSlope;
    float farther = -(normal.x * across.x + normal.y * across.y) / dot(normal, vec3(ray, 1.0));
    if (!(abs(farther) < min(mostView, 0.25 * distanceView))) {
        farther = 0.0; // still to the same sub-pixel as the vertex' other triangles
    }
    return place + vec3(across + ray * farther, farther);
}

#endif
