#version 460
#extension GL_GOOGLE_include_directive : require
#include "shading/fullscreen.glsl"

void main() { gl_Position = fullscreenCorner(); }
