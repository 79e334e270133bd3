// What the passes for translucent surfaces share with C++. Every struct is laid out the same by std430 and by
// C++.
#ifndef CDR_SHADERS_TRANSLUCENT_SHARED_H
#define CDR_SHADERS_TRANSLUCENT_SHARED_H

#include "sharing.h"

CDR_SHARED_BEGIN

// One translucent draw: object to view space, relative to the plane through the instance's own centre. It is drawn in one range
// of view distances: a cascade's, or all of them where fragments are sorted. The record is the same for every cascade and
// mapping. So a triangle has the same bits in every cascade.
struct TranslucentRecord {
    vec4 right;       // row of (view * basis) in xyz, translation in w: view-space x
    vec4 up;          // the same for view-space y
    vec4 ahead;       // the same for the view distance, without translation
    vec4 centreRange; // view distance of the centre, a float and its rest; then [near, far) of the range
                      // less the centre, formed in float64: the far end of one range is the near end of the
                      // next to the bit
    uint id;          // DrawRecord's
    uint baseColorRg; // linear base colour factor as four halves
    uint baseColorBa;
    uint metallicRoughness; // DrawRecord's
};

// What the draws of one range share; push constants.
struct TranslucentPush {
    float projectionX; // as CascadePush has them
    float projectionY;
    float
        behind; // view distance below which vertices are clipped: nearer than anything visible, and in front
    float nearView;    // the range's, for weights
    float spread;      // 1 / ln(far / near)
    uint width;        // of the picture
    uint capacity;     // of the fragment list, in fragments
    float layerOffset; // scene::Material::layer
    float layerSlope;  // render::LayerPlace::rank, times the pixels by which two vertices are rounded apart
    float lensX;       // as CascadePush has them
    float lensY;
};

// What follows TranslucentPush where translucent surfaces receive shadows: the fragments that a draw keeps, and their maps.
struct TranslucentSlice {
    float nearView; // view distance, included
    float farView;  // left out
    uint firstMap;
    uint mapCount;
};

// One translucent fragment of a pixel's list.
struct FragmentNode {
    float red; // lit, linear, straight alpha
    float green;
    float blue;
    float alpha;
    float distance; // view distance, and what that float leaves out
    float rest;
    uint id;
    uint next; // towards the end of the list; kNoNode ends it
};

// Node 0 is nobody's. Zero, because it is what helper invocations read on lavapipe, who must find no list to
// walk.
CDR_CONST kNoNode = 0u;

// Where counting fragments ends. A device never runs as many shaders at once, so the counter does not get to 2^32.
CDR_CONST kMostCounted = 0x80000000u;

static_assert(sizeof(TranslucentRecord) == 80);
static_assert(sizeof(TranslucentPush) == 44);
static_assert(sizeof(TranslucentSlice) == 16);
static_assert(sizeof(FragmentNode) == 32);

CDR_SHARED_END

#endif
