// The key of a fragment, by which the nearest one of a pixel is found. Keys ascend with distance.
// OBJECT, VERTEX_PAIR or neither: as visibility.vert. LOG, FIXED or neither, which takes pairs by their bits.
#ifndef CDR_SHADERS_RIVALS_KEY_GLSL
#define CDR_SHADERS_RIVALS_KEY_GLSL

#include "public/cdr_float_pair.glsl"

layout(location = 0) flat in uint inId;
#if defined(OBJECT)
layout(location = 1) in float inOffset;
layout(location = 2) flat in vec2 inCentre;
#elif defined(VERTEX_PAIR)
layout(location = 1) in vec2 inDistance;
#else
layout(location = 1) in float inAhead;
#endif

#if defined(LOG) && defined(OBJECT)
// The upper bits of a float64 are a logarithm, linear between powers of two.
uint64_t distanceKey() {
    uint64_t origin = uint64_t(rival.originTop) << 32;
    double distanceView = double(inCentre.x) + (double(inCentre.y) + double(inOffset));
    uint64_t bits = doubleBitsToUint64(max(distanceView, uint64BitsToDouble(origin)));
    return min((bits - origin) >> rival.shift, (uint64_t(1) << kLogKeyBits) - 1);
}
#elif defined(LOG)
// More than a float32 has need not be kept.
uint64_t distanceKey() { return uint64_t(floatBitsToUint(max(inAhead, 0.0))) << (kLogKeyBits - 32); }
#elif defined(FIXED)
uint64_t distanceKey() {
    double distanceView = double(inCentre.x) + (double(inCentre.y) + double(inOffset));
    return uint64_t(max(distanceView, 0.0lf) * double(rival.scale));
}
#else
uint64_t distanceKey() {
#ifdef OBJECT
    vec2 pair = cdrPairSum(inCentre, inOffset);
#else
    vec2 pair = cdrExactSum(inDistance.x, inDistance.y);
#endif
    // Rests have both signs: negative ones come first, the largest of them last.
    uint rest = floatBitsToUint(pair.y + 0.0);
    uint ordered = (rest & 0x80000000u) != 0u ? ~rest : rest | 0x80000000u;
    return (uint64_t(floatBitsToUint(max(pair.x, 0.0))) << 32) | ordered;
}
#endif

uint pixelIndex() { return uint(gl_FragCoord.y) * rival.width + uint(gl_FragCoord.x); }

#endif
