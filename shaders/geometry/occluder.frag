#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "geometry/depth_mapping.glsl"

// Cuts wide draws where geometry.frag does; depth alone is written.
layout(push_constant) uniform Push { CascadePush cascade; };

layout(location = 1) in float inAhead;

void main() {
    if (isCut(clipDistances(inAhead, cascade), inAhead, gl_ClipDistance[1], cascade)) {
        discard;
    }
}
