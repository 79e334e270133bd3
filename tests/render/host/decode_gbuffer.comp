#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
#include "cdr_gbuffer.glsl"

// What cdr_gbuffer.glsl reads from each pixel, and whether it writes the same.
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) uniform utexture2D gbuffer;
layout(set = 0, binding = 1, std430) writeonly buffer Decoded { vec4 decoded[]; };
layout(push_constant) uniform Push { vec4 anchors[8]; };

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    uvec2 size = uvec2(textureSize(gbuffer, 0));
    if (pixel.x >= size.x || pixel.y >= size.y) {
        return;
    }
    uvec4 texel = texelFetch(gbuffer, ivec2(pixel), 0);
    uint cascade = cdrCascadeOf(texel);
    vec3 normal = cdrNormalOf(texel);
    vec3 albedo = cdrAlbedoOf(texel);
    uvec4 again = cdrGBufferTexel(albedo, normal, cdrAheadOf(texel), cdrIdOf(texel), cascade);
    vec2 distanceView = cdrDistanceViewOf(texel, vec2(anchors[cascade].x, anchors[cascade].y));
    uint first = 3u * (pixel.y * size.x + pixel.x);
    decoded[first] = vec4(distanceView.x, distanceView.y, float(cdrIdOf(texel)), float(cascade));
    decoded[first + 1u] = vec4(normal.x, normal.y, normal.z, float(again.w == texel.w && again.z == texel.z));
    decoded[first + 2u] = vec4(albedo.x, albedo.y, albedo.z, float(again.x == (texel.x & 0xffffffu)));
}
