// What the host and the shaders of the rivals share.
#ifndef CDR_SHADERS_RIVALS_SHARED_H
#define CDR_SHADERS_RIVALS_SHARED_H

#include "shared.h"

CDR_SHARED_BEGIN

// What a pipeline does with depth; specialisation constant 4.
CDR_CONST kDepthNone = 0u;    // there is no depth buffer
CDR_CONST kDepthDecides = 1u; // nearest wins
CDR_CONST kDepthSieves = 2u;  // what surely lies behind the depth of a prepass goes

CDR_CONST kLogKeyBits = 40u; // above the bits of the id

// One draw: object to view space. 64 bytes, as a DrawRecord.
struct VisibilityRecord {
    vec4 right; // row of (view * basis) in xyz, translation in w: view-space x
    vec4 up;
    vec4 ahead;      // the same for the view distance, beyond the cascade's anchor where there is one
    uint id;         // object index + 1
    float aheadRest; // what ahead.w leaves out of the float64
    uint unused0;
    uint unused1;
};

// How distances become keys; push constants behind a CascadePush.
struct RivalPush {
    uint width;     // of the picture, pixels
    float scale;    // fixed point: steps a scene unit, a power of two
    uint originTop; // logarithm: the upper half of the bits of the float64 that counts as 0
    uint shift;     // logarithm: lower bits that are dropped
};

static_assert(sizeof(VisibilityRecord) == 64);
static_assert(sizeof(RivalPush) == 16);

CDR_SHARED_END

#endif
