// What shadow maps are drawn and read with. A light's view has axes right and up across its direction, and ahead away from
// it. Clip w, and clip z, grow evenly ahead, so that a distant light and one near by are drawn alike. Every struct is laid
// out the same by std430 and by C++.
#ifndef CDR_SHADERS_SHADOWS_SHARED_H
#define CDR_SHADERS_SHADOWS_SHARED_H

#include "sharing.h"

CDR_SHARED_BEGIN

// A pixel's depth is the number of its slice over this. 16 bits of depth hold that exactly.
CDR_CONST_FLOAT kMaxSlices = 65535.0;

// One caster: object space to a light's view. Per instance.
struct CasterRecord {
    vec4 right; // row of (axis * basis) in xyz, the origin's place on the axis in w
    vec4 up;
    vec4 ahead;
    float rounding;   // scene units: by how much a vertex may be off
    float leastAlpha; // of vertex and texture, that a mask keeps; 0 where nothing is masked
};

// How a light's view becomes clip space, and depths in it become lengths.
struct LightLens {
    float wOffset; // clip w: wOffset + wPerUnit * ahead
    float wPerUnit;
    float zOffset; // clip z, nearer the light the larger
    float zPerUnit;
    float texel; // of the map, in units of right / w
};

struct CasterPush {
    vec2 scale; // of right / w and up / w to normalised device coordinates
    vec2 shift;
    LightLens lens;
};

// A map, and how surfaces are compared with it.
struct ReceiverPush {
    // In xyz, the light's axes along the camera's right, up and ahead. In w, the coordinates on these axes of the point
    // straight ahead of the camera at referenceView.
    vec4 right;
    vec4 up;
    vec4 ahead;
    vec2 low;            // of the map, in units of right / w and up / w
    ivec2 mapCorner;     // of the map's first texel in its image
    float nearView;      // of the surfaces that read this map
    float farView;       // the first that does not
    float referenceView; // view distance
    LightLens lens;
    float snap;    // by how much the device may shift a surface, scene units per unit of view distance
    float mapSnap; // the same of casters, texels
    uint channel;  // of the mask
    uint isPlain;  // whether surfaces are compared as today's practice is
    ivec2 mapLast; // texel of the map
    vec2 part;     // of a part of a map, the last place in texels that it decides about; of a whole map 0
};

// Where slices of distances begin.
struct SlicePush {
    vec4 nearView; // the first four slices' ends, if isPlain; infinite where there is none
    uint isPlain;  // else slices begin at powers of two, whose exponents are their numbers
};

static_assert(sizeof(CasterRecord) == 56);
static_assert(sizeof(CasterPush) == 36);
static_assert(sizeof(ReceiverPush) == 128);
static_assert(sizeof(SlicePush) == 20);

CDR_SHARED_END

#ifndef __cplusplus
// Clip z per unit of w that a texel's length towards the light amounts to, at a depth.
float depthPerTexel(LightLens lens, float z) {
    precise float perUnit = lens.zPerUnit - z * lens.wPerUnit;
    return lens.texel * abs(perUnit);
}
#endif

#endif
