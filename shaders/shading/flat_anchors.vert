#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "shading/fullscreen.glsl"
#define LIGHTING_SET 0
#define LIGHTING_BINDING 1
#include "shading/lighting_buffer.glsl"
#define HANDS_OVER_ANCHORS
#include "shading/flat_anchors.glsl"

// Covers the picture, and reads once what all its pixels share.
void main() {
    handOverAnchors();
    gl_Position = fullscreenCorner();
}
