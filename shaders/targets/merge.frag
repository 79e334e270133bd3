#version 460
#extension GL_GOOGLE_include_directive : require

// Lays one layer G-buffer over the accumulated one; a merged pixel is the layer's own, bit for bit.
layout(set = 0, binding = 0) uniform usampler2D layerBuffer;

layout(location = 0) out uvec4 outTexel;

#ifdef OCCLUDED
// And works out ambient occlusion on the layer alone, as the thesis' method 2 has it: what other cascades hold is not there.
#include "shared.h"
#include "targets/gbuffer.glsl"
layout(push_constant) uniform Push { LayerPush layer; };

float distanceOf(uvec4 texel) { return layer.anchorView + aheadOf(texel); }
float aheadBetween(uvec4 from, uvec4 to) { return aheadOf(to) - aheadOf(from); }
#include "shading/occlusion.glsl"
#endif

#ifdef SCALED
// The layer covers as much of the view in another number of pixels.
#include "shared.h"
layout(push_constant) uniform Push { PictureSize picture; };
#endif

void main() {
#ifdef SCALED
    ivec2 pixel = ivec2(gl_FragCoord.xy / picture.pixels * vec2(textureSize(layerBuffer, 0)));
#else
    ivec2 pixel = ivec2(gl_FragCoord.xy);
#endif
    outTexel = texelFetch(layerBuffer, pixel, 0);
    if (outTexel.w == 0u) {
        discard; // background: what lies farther stays
    }
#ifdef OCCLUDED
    outTexel.x = withOcclusion(outTexel.x, occlusionAt(layerBuffer, pixel, outTexel, layer.rayScale, layer.radius));
#endif
}
