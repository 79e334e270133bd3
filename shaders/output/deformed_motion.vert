#version 460
#extension GL_GOOGLE_include_directive : require
#include "output/motion_shared.h"

// Draws a deformed mesh where this frame shows it, with how each vertex moved in the mesh.
layout(push_constant) uniform Push { DeformedPush push; };

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inBefore;

layout(location = 0) out vec3 outDeformed; // right, up and view distance of the last camera
layout(location = 1) out float outBeyond;  // view distance beyond the instance's origin

void main() {
    // Rounded as geometry.vert rounds: the fragment shader compares distances with those of the G-buffer.
    precise float right = dot(push.right.xyz, inPosition) + push.right.w;
    precise float up = dot(push.up.xyz, inPosition) + push.up.w;
    precise float beyond = dot(push.ahead.xyz, inPosition);
    precise float distanceView = push.ahead.w + beyond;
    // No depth is tested, so z only has to lie between the clip planes.
    precise vec2 across = vec2(right, up) * push.projection - distanceView * push.lens;
    gl_Position = vec4(across, 0.5 * distanceView, distanceView);
    precise vec3 moved = inBefore - inPosition;
    outDeformed = vec3(dot(push.rightBefore.xyz, moved), dot(push.upBefore.xyz, moved), dot(push.aheadBefore.xyz, moved));
    outBeyond = beyond;
}
