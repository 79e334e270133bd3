#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared.h"

// Lays one lit layer, filtered up to the picture, over all that is farther, by gpu::Blend::over.
layout(set = 0, binding = 0) uniform sampler2D layerImage;

layout(push_constant) uniform Push { PictureSize picture; };

layout(location = 0) out vec4 outColor;

void main() {
    if (vec2(textureSize(layerImage, 0)) == picture.pixels) {
        outColor = texelFetch(layerImage, ivec2(gl_FragCoord.xy), 0); // nothing to filter
    } else {
        outColor = textureLod(layerImage, gl_FragCoord.xy / picture.pixels, 0.0);
    }
    if (outColor.a == 1.0) {
        discard; // nothing
    }
}
