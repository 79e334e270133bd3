// Ambient occlusion from a G-buffer, after McGuire, Mara and Luebke 2012, "Scalable Ambient Obscurance". It is the share of
// the half-space above a pixel's surface that lies behind surfaces which the picture shows within `radius` (scene units).
// Works on metric view distances. The includer defines two functions for surfaces of its buffer:
//   float aheadBetween(uvec4 from, uvec4 to)   the difference of their view distances
//   float distanceOf(uvec4 texel)              the view distance itself, which only scales
#ifndef CDR_SHADERS_OCCLUSION_GLSL
#define CDR_SHADERS_OCCLUSION_GLSL

const int kSamples = 12;
const float kTurns = 5.0;         // of the spiral that the samples lie on; coprime to their number
const float kMaxPixels = 96.0;   // of the spiral's radius: what lies wider apart is too far in memory
const float kBias = 0.02;         // of the radius: a normal of 16 bits lets a flat surface rise by less
const float kDistanceNoise = 3e-7; // a few steps of a float, of the view distance
const float kStrength = 1.5;      // obscurance as it is usually shown

// rayScale, rayCentre: as ShadingHeader has them. 0 is open, 1 is closed.
float occlusionAt(usampler2D gbuffer, ivec2 pixel, uvec4 texel, vec2 rayScale, vec2 rayCentre, float radius) {
    ivec2 size = textureSize(gbuffer, 0);
    vec2 perPixel = vec2(2.0, -2.0) * rayScale / vec2(size);
    float distance = distanceOf(texel);
    float spiral = min(radius / (distance * abs(perPixel.y)), kMaxPixels);
    if (spiral < 1.0) {
        return 0.0;
    }
    vec3 normal = normalOf(texel);
    vec2 ray = (vec2(pixel) + 0.5 - 0.5 * vec2(size)) * perPixel + rayCentre;
    // Sixteen angles in a 4 x 4 tile, which the reader's 4 x 4 average evens out.
    float turn = float((7 * pixel.x + 12 * pixel.y) & 15) * (6.2831853 / 16.0);
    float bias = kBias * radius + kDistanceNoise * abs(aheadOf(texel));
    float radius2 = radius * radius;
    float sum = 0.0;
    for (int i = 0; i < kSamples; ++i) {
        float share = (float(i) + 0.5) / float(kSamples);
        float angle = share * kTurns * 6.2831853 + turn;
        ivec2 offset = ivec2(round(share * spiral * vec2(cos(angle), sin(angle))));
        ivec2 there = pixel + offset;
        if (any(lessThan(there, ivec2(0))) || any(greaterThanEqual(there, size))) {
            continue;
        }
        uvec4 other = texelFetch(gbuffer, there, 0);
        if (other.w == 0u) {
            continue;
        }
        float farther = aheadBetween(texel, other);
        vec3 toOther = vec3(vec2(offset) * perPixel * (distance + farther) + ray * farther, -farther);
        float length2 = dot(toOther, toOther);
        float falloff = max(1.0 - length2 / radius2, 0.0);
        sum += falloff * falloff * max(dot(toOther, normal) - bias, 0.0) * inversesqrt(length2 + 1e-3 * radius2);
    }
    return clamp(kStrength * 2.0 * sum / float(kSamples), 0.0, 1.0);
}

#endif
