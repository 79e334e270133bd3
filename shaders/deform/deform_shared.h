// What the compute pass that deforms meshes and C++ share.
#ifndef CDR_SHADERS_DEFORM_SHARED_H
#define CDR_SHADERS_DEFORM_SHARED_H

#include "sharing.h"

CDR_SHARED_BEGIN

// Invocations a workgroup: one for each vertex, or for each triangle of a flat mesh.
CDR_CONST kDeformBlock = 128u;

// DeformPush::flags
CDR_CONST kDeformFlat = 1u;    // scene::Deformer::isFlat
CDR_CONST kDeformDerived = 2u; // scene::Deformer::derivedTangents, of a mesh that is not flat
CDR_CONST kDeformDetails = 4u; // tangents are written too
CDR_CONST kDeformSkin = 8u;    // joints place the vertices

// Words of a vertex at rest: position, normal and tangent.
CDR_CONST kRestWords = 10u;
// Words of what a target does to a vertex: the target, then its position, normal and tangent.
CDR_CONST kDeltaWords = 10u;
// Words of what is written: render::PackedVertex and PackedDetail.
CDR_CONST kVertexWords = 7u;
CDR_CONST kDetailWords = 4u;
// Numbers of a pose before the weights: position and basis of its place, the deformer's centre, and one unused.
CDR_CONST kPlaceNumbers = 16u;

// Where what belongs to a mesh begins.
struct DeformPush {
    uint vertices;        // how many
    uint firstInfluences; // into the words of the deformer, as all that follow: by vertex, and the end
    uint influences;      // joint and weight of each
    uint firstDeltas;     // by vertex, and the end
    uint deltas;
    uint weights;         // how many the pose has
    uint firstVertexWord; // of what is written
    uint firstDetailWord;
    uint flags;
};

static_assert(sizeof(DeformPush) == 36);

CDR_SHARED_END

#endif
