// What a texel of a shadow map keeps beside its depth, in two half floats: how the surface slopes, and a bound of how far the
// depth may be off. The bound is a power of two, whose exponent takes the two lowest bits of each half float.
#ifndef CDR_SHADERS_PACKED_SLOPE_GLSL
#define CDR_SHADERS_PACKED_SLOPE_GLSL

const float kMaxSlope = 1000.0;
const float kMinSlope = 1.0 / 8192.0;  // smaller half floats may become 0
const float kKeptSlope = 1.0 / 512.0;  // of a slope, how much of it rounding may take

const uint kLowestBit = 13u;           // of a half float, in a float of the same value
const uint kFirstExponent = 122u;      // of a float: bounds are from 1/32 texel
const uint kLastExponent = 15u;        // to 1024

struct MapSlope {
    vec2 perTexel;  // texels towards the light per texel across and down
    float rounding; // texels
};

vec2 packedSlope(vec2 slope, float rounding) {
    // The float's exponent says a power of two that is not above the bound, so the next one is taken.
    uint exponent = floatBitsToUint(rounding) >> 23;
    uint above = clamp(exponent + 1u, kFirstExponent, kFirstExponent + kLastExponent) - kFirstExponent;
    vec2 size = clamp(abs(slope), kMinSlope, kMaxSlope);
    uvec2 rounded = (floatBitsToUint(size) + (2u << kLowestBit)) & ~((4u << kLowestBit) - 1u);
    uvec2 signs = floatBitsToUint(slope) & 0x80000000u;
    return uintBitsToFloat(signs | rounded | (uvec2(above, above >> 2) & 3u) << kLowestBit);
}

MapSlope unpackedSlope(vec2 texel) {
    uvec2 bits = floatBitsToUint(texel);
    uvec2 parts = (bits >> kLowestBit) & 3u;
    return MapSlope(uintBitsToFloat(bits & ~((4u << kLowestBit) - 1u)),
                    uintBitsToFloat((kFirstExponent + (parts.x | parts.y << 2)) << 23));
}

#endif
