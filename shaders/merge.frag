#version 460

// Lays one layer G-buffer over the accumulated one. Texels are read and written as plain bits, whatever they hold, so a
// merged pixel is the layer's own, sRGB and float images included.
layout(set = 0, binding = 0) uniform usampler2D albedoBits;
layout(set = 0, binding = 1) uniform usampler2D normalBits;
layout(set = 0, binding = 2) uniform usampler2D aheadBits;
layout(set = 0, binding = 3) uniform usampler2D idBits;

layout(location = 0) out uint outAlbedo;
layout(location = 1) out uint outNormal;
layout(location = 2) out uint outAhead;
layout(location = 3) out uint outId;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uint id = texelFetch(idBits, pixel, 0).r;
    if (id == 0u) {
        discard; // background: what lies farther stays
    }
    outAlbedo = texelFetch(albedoBits, pixel, 0).r;
    outNormal = texelFetch(normalBits, pixel, 0).r;
    outAhead = texelFetch(aheadBits, pixel, 0).r;
    outId = id;
}
