#version 460

// Lays one layer G-buffer over the accumulated one; a merged pixel is the layer's own, bit for bit.
layout(set = 0, binding = 0) uniform usampler2D layerBuffer;

layout(location = 0) out uvec4 outSurface;

void main() {
    outSurface = texelFetch(layerBuffer, ivec2(gl_FragCoord.xy), 0);
    if (outSurface.w == 0u) {
        discard; // background: what lies farther stays
    }
}
