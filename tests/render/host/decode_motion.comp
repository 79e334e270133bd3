#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
#include "cdr_gbuffer.glsl"

// Whether each pixel has motion, and which.
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) uniform texture2D motion;
layout(set = 0, binding = 1, std430) writeonly buffer Decoded { vec4 decoded[]; };

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    uvec2 size = uvec2(textureSize(motion, 0));
    if (pixel.x < size.x && pixel.y < size.y) {
        vec2 moved = texelFetch(motion, ivec2(pixel), 0).xy;
        decoded[3u * (pixel.y * size.x + pixel.x)] = vec4(float(cdrHasMotion(moved)), moved, 0.0);
    }
}
