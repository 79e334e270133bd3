// What the motion of surfaces is made from. Coordinates are right, up and view distance; pairs are a float and the rest
// that it leaves out. Every struct is laid out the same by std430 and by C++.
#ifndef CDR_SHADERS_MOTION_SHARED_H
#define CDR_SHADERS_MOTION_SHARED_H

#include "sharing.h"

CDR_SHARED_BEGIN

// What the camera did since the last frame.
struct MotionHeader {
    // What its turn adds to right, to up and to the view distance. Component x is per unit of right, and y
    // per unit of up. The pair zw is per unit of view distance.
    vec4 turnRight;
    vec4 turnUp;
    vec4 turnAhead;
    vec4 shift;     // what its move adds to each, in xyz
    vec4 shiftRest; // the rest of that
    vec2
        pixels; // per unit of right or up at view distance 1, as the last camera's lens had them; y points down
    vec2 pixelsAdded; // those less this camera's
    uint objects;     // that the table of records covers
    uint unused;
    vec2 middle; // by how many pixels the view axis meets the picture elsewhere than it did
};

// An object that moved itself.
struct MotionRecord {
    // What its turn adds per unit beside its centre, in xyz; in w the centre's right, up and view distance.
    vec4 right;
    vec4 up;
    vec4 ahead;
    vec4
        shift; // what its move and the camera's add to each, in xyz; in w the rest of the centre's view distance
    vec4 shiftRest; // the rest of xyz
};

// An instance whose mesh has other vertices than in the last frame; push constants. Rows are of object to view space.
struct DeformedPush {
    vec4 right; // in w that of the instance's origin
    vec4 up;
    vec4 ahead;
    vec4 rightBefore; // rows to the last camera's coordinates; in w the rest that ahead.w leaves out
    vec4 upBefore;
    vec4 aheadBefore;
    vec2 projection; // clip x and y per unit of right and up, at view distance 1
    vec2 lens;       // CascadePush's lensX and lensY
    uint id;         // object index + 1
    uint unused;
};

static_assert(sizeof(DeformedPush) == 120);
static_assert(sizeof(MotionHeader) == 112);
static_assert(sizeof(MotionRecord) == 80);

CDR_SHARED_END

#endif
