#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "shading/fullscreen.glsl"
#include "shading/lighting_buffer.glsl"
#define HANDS_OVER_ANCHORS
#include "shading/flat_anchors.glsl"

// Covers the picture, and reads once what all its pixels share.
void main() {
    handOverAnchors();
    gl_Position = fullscreenCorner();
}
