// What occlusion culling on the device shares with C++. Every struct is laid out the same by std430 and by C++.
#ifndef CDR_SHADERS_OCCLUDERS_SHARED_H
#define CDR_SHADERS_OCCLUDERS_SHARED_H

#include "shared.h"

CDR_SHARED_BEGIN

// Pixels along the side of a tile, and tiles along that of a square.
CDR_CONST kTileSide = 8u;
CDR_CONST kSquareSide = 8u;
// Invocations per workgroup of reduce_depth.comp.
CDR_CONST kReduceBlock = 64u;
// Distances at which margins are known, each in the same ratio to the last.
CDR_CONST kMarginNodes = 512u;

// One frame's camera and picture.
struct OccluderView {
    double tanX; // scene::Frustum
    double tanY;
    double leastRadius; // of occluders, per unit of view distance
    double nearView;
    uint width; // of the picture, in pixels
    uint height;
    uint columns; // of tiles
    uint rows;
    uint hasSeen; // 0: no frame was before
    float nodesPerRatio;
    float unused[2];
    float margins[kMarginNodes]; // render::OrderMargin
};

static_assert(sizeof(OccluderView) == 64 + 4 * kMarginNodes);

CDR_SHARED_END

#endif
