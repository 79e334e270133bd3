// What the GPU-driven path's compute passes and C++ share. Every struct is laid out the same by std430 and by
// C++.
#ifndef CDR_SHADERS_BINNING_SHARED_H
#define CDR_SHADERS_BINNING_SHARED_H

#include "shared.h"

CDR_SHARED_BEGIN

// Instances per workgroup, one invocation each.
CDR_CONST kBinBlock = 256u;
// Invocations per workgroup of bin_commands.comp, and of scatter.comp.
CDR_CONST kCommandsBlock = 64u;
CDR_CONST kChangesBlock = 256u;
// A compact and a wide bucket per cascade, nearest cascade first, as visibility::DrawLists has them.
CDR_CONST kBinBuckets = 128u;

// What culling and binning read of an instance.
struct InstanceSphere {
    double x; // world space
    double y;
    double z;
    float radius;
    uint run; // into the kind runs
};

// What its draw record takes besides.
struct InstanceLook {
    float basis[9]; // object to world, column by column
    uint id;        // DrawRecord::id
    uint material;
    uint pad0;
};

// Both, of an instance that was grouped before and is other now.
struct InstanceChange {
    InstanceSphere sphere;
    InstanceLook look;
    uint instance;
    uint pad0;
};

struct MaterialRecord {
    uint cutoffAndMetallicRoughness; // the words of a DrawRecord
    uint baseColorRg;
    uint baseColorBa;
    uint occludes; // 0: fragments may be missing, or lie nearer
};

// Consecutive instances of one mesh, material and handedness: one instanced draw per bucket. A run that has
// levels of detail to choose from is a single instance.
struct KindRun {
    uint firstIndex;
    uint indexCount;
    int vertexOffset;
    uint instance;   // the first
    uint firstLevel; // into the coarser levels
    uint levels;     // how many there are to choose from
    float boundingRadius;
};

// A mesh's level of detail but for level 0.
struct CoarserLevel {
    uint firstIndex;
    uint indexCount;
    float error; // scene::MeshLevel::error
};

// Consecutive runs between which nothing is bound: one indirect draw with a count per bucket.
struct RunGroup {
    uint begin;
    uint end;
};

// visibility::DetailMode.
CDR_CONST kDetailPerCascade = 2u;

// One frame's camera and cascades.
struct BinningView {
    double position[3]; // world space
    double right[3];
    double up[3];
    double ahead[3];
    double centreX; // scene::Frustum's
    double centreY;
    double cosX;
    double sinX;
    double cosY;
    double sinY;
    double nearView;
    double farView;
    double wideSpan;   // visibility::binByDistance()'s, where hasWideSpan
    double levelSlope; // visibility::LevelRule
    uint hasWideSpan;  // 0 where nothing is wide: no arithmetic with infinities
    uint instances;
    uint cascades;
    uint blocks;
    uint runs;
    uint groups;
    uint recordCapacity;
    uint detailMode;                 // visibility::DetailMode
    double nearViews[kCascadeSlots]; // clip ranges; the far ends ascend
    double farViews[kCascadeSlots];
    double anchors[kCascadeSlots]; // view distance of each cascade's anchor plane
};

// VkDrawIndexedIndirectCommand.
struct IndirectCommand {
    uint indexCount;
    uint instanceCount;
    uint firstIndex;
    int vertexOffset;
    uint firstInstance;
};

// What the CPU is told.
struct BinningResult {
    uint draws;           // wanted, even where the records have no room for them
    uint drawsAndVisible; // and the instances in at least one cascade
    uint hidden;          // instances that were left out, since occluders hide them
};

static_assert(sizeof(InstanceSphere) == 32);
static_assert(sizeof(InstanceLook) == 48);
static_assert(sizeof(InstanceChange) == 88);
static_assert(sizeof(MaterialRecord) == 16);
static_assert(sizeof(KindRun) == 28); // tight in std430 too: all members are words
static_assert(sizeof(CoarserLevel) == 12);
static_assert(sizeof(BinningView) == 208 + 3 * 8 * kCascadeSlots);
static_assert(sizeof(IndirectCommand) == 20);
static_assert(kBinBuckets == 2 * kCascadeSlots);

CDR_SHARED_END

#endif
