// Which instances hide others, and which are hidden, on the device: visibility::Occluders and dropHidden(). Include
// binning.glsl first where instances are looked at.
#ifndef CDR_SHADERS_OCCLUDERS_GLSL
#define CDR_SHADERS_OCCLUDERS_GLSL

#include "occluders/occluders_shared.h"

layout(set = 1, binding = 0, std430) readonly buffer Occluding { OccluderView occluders; };
layout(set = 1, binding = 1, std430) buffer Seen { uint seen[]; };          // a bit for each instance
layout(set = 1, binding = 2, std430) readonly buffer Depths { float zNdc[]; }; // near / view distance, by pixel
// View distances beyond which all is hidden: by tile, row by row, then by square.
layout(set = 1, binding = 3, std430) buffer Tiles { float hiddenBeyond[]; };

uint squareColumns() { return (occluders.columns + kSquareSide - 1u) / kSquareSide; }
uint squareRows() { return (occluders.rows + kSquareSide - 1u) / kSquareSide; }
uint firstSquare() { return occluders.columns * occluders.rows; }

#endif
