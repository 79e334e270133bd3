#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "occluders/occluders.glsl"

// From where on all is hidden: one invocation for each tile; with SQUARES, for each square of tiles.
layout(local_size_x = kReduceBlock) in;

float never() { return uintBitsToFloat(0x7f800000u); }
// Of this pass and of the depths it reads.
const float kRounding = 1.000002;

// render::OrderMargin::at(), with a node more on each side for what a float logarithm rounds.
float marginAt(float distanceView) {
    float place = log(distanceView / float(occluders.nearView)) * occluders.nodesPerRatio;
    if (!(place >= 0.0) || place >= float(kMarginNodes - 1u)) {
        return never();
    }
    uint node = uint(place);
    float margin = max(occluders.margins[node], occluders.margins[node + 1u]);
    return max(margin, max(occluders.margins[max(node, 1u) - 1u], occluders.margins[min(node + 2u, kMarginNodes - 1u)]));
}

#ifdef SQUARES
void main() {
    uint square = gl_GlobalInvocationID.x;
    if (square >= squareColumns() * squareRows()) {
        return;
    }
    uvec2 first = kSquareSide * uvec2(square % squareColumns(), square / squareColumns());
    uvec2 end = min(first + kSquareSide, uvec2(occluders.columns, occluders.rows));
    float farthest = 0.0;
    for (uint row = first.y; row < end.y; ++row) {
        for (uint column = first.x; column < end.x; ++column) {
            farthest = max(farthest, hiddenBeyond[row * occluders.columns + column]);
        }
    }
    hiddenBeyond[firstSquare() + square] = farthest;
}
#else
void main() {
    uint tile = gl_GlobalInvocationID.x;
    if (tile >= firstSquare()) {
        return;
    }
    uvec2 first = kTileSide * uvec2(tile % occluders.columns, tile / occluders.columns);
    uvec2 end = min(first + kTileSide, uvec2(occluders.width, occluders.height));
    float least = 1.0;
    for (uint y = first.y; y < end.y; ++y) {
        for (uint x = first.x; x < end.x; ++x) {
            least = min(least, zNdc[y * occluders.width + x]);
        }
    }
    float distanceView = least > 0.0 ? float(occluders.nearView) / least * kRounding : never();
    hiddenBeyond[tile] = least > 0.0 ? (distanceView + marginAt(distanceView)) * kRounding : never();
}
#endif
