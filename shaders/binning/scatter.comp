#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "binning/binning_shared.h"

// Before the passes that bin: puts what changed of some instances where they stand, one invocation for each.
layout(local_size_x = kChangesBlock) in;

layout(set = 0, binding = 0, std430) readonly buffer Changes { InstanceChange changes[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Spheres { InstanceSphere spheres[]; };
layout(set = 0, binding = 2, std430) writeonly buffer Looks { InstanceLook looks[]; };
layout(push_constant) uniform Push { uint count; };

void main() {
    if (gl_GlobalInvocationID.x < count) {
        InstanceChange change = changes[gl_GlobalInvocationID.x];
        spheres[change.instance] = change.sphere;
        looks[change.instance] = change.look;
    }
}
