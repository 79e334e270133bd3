#version 460
#extension GL_GOOGLE_include_directive : require

// Lays one layer's buffer over the accumulated one; a merged pixel is the layer's own, bit for bit.
layout(set = 0, binding = 0) uniform usampler2D layerBuffer;

// EMISSION: of the emission buffers beside them too.
#ifdef EMISSION
layout(set = 0, binding = 1) uniform usampler2D layerEmission;
layout(location = 1) out uint outEmission;
#endif

// Whether the buffers are visibility buffers, of one uint, in place of G-buffers.
layout(constant_id = 0) const uint kFacets = 0u;
layout(location = 0) out uvec4 outTexel;
bool isBackground(uvec4 texel) { return (kFacets != 0u ? texel.x : texel.w) == 0u; }

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
    if (isBackground(outTexel)) {
        discard; // background: what lies farther stays
    }
#ifdef EMISSION
    outEmission = texelFetch(layerEmission, pixel, 0).x;
#endif
#ifdef OCCLUDED
    outTexel.x = withOcclusion(outTexel.x, occlusionAt(layerBuffer, pixel, outTexel, layer.rayScale, layer.rayCentre, layer.radius));
#endif
}
