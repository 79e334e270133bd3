#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"
#include "shading/fullscreen.glsl"
#include "shading/lighting_buffer.glsl"
#define HANDS_OVER_LIGHTING
#include "shading/flat_lighting.glsl"

// Covers the picture, and reads once what all its pixels share.
void main() {
    handOverLighting();
    gl_Position = fullscreenCorner();
}
