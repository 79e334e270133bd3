// A number as the unevaluated sum of two floats: 48 bits. The second is at most half a unit in the last place of the first.
// It relies on float32 sums and products that are rounded to nearest, as Vulkan requires of every device.
//
// @units Any, the same in a number and its rest. Terms of a sum have one unit.
// @range Finite, and so are the results. What is below 2^-126 may become 0.
#ifndef CDR_FLOAT_PAIR_GLSL
#define CDR_FLOAT_PAIR_GLSL

// Exactly a + b, as a pair: Knuth, The Art of Computer Programming 2, section 4.2.2, theorem B.
vec2 cdrExactSum(float a, float b) {
    precise float sum = a + b;
    precise float partB = sum - a;
    precise float partA = sum - partB;
    precise float rest = (a - partA) + (b - partB);
    return vec2(sum, rest);
}

// The upper 12 of the 24 bits of a: Dekker 1971, A floating-point technique for extending the available
// precision, section 4. An fma() would do without, but devices may round it twice.
// @range |a| below 2^115.
float cdrUpperHalf(float a) {
    precise float scaled = a * 4097.0;
    precise float upper = scaled - (scaled - a);
    return upper;
}

// Exactly a b, as a pair, unless parts of it are below 2^-126: Dekker 1971, section 5.
// @range |a| and |b| below 2^115, their product below 2^127.
vec2 cdrExactProduct(float a, float b) {
    float upperA = cdrUpperHalf(a);
    float upperB = cdrUpperHalf(b);
    precise float lowerA = a - upperA;
    precise float lowerB = b - upperB;
    precise float product = a * b;
    precise float rest = ((upperA * upperB - product) + upperA * lowerB + lowerA * upperB) + lowerA * lowerB;
    return vec2(product, rest);
}

// pair + value, rounded to a pair.
vec2 cdrPairSum(vec2 pair, float value) {
    vec2 sum = cdrExactSum(pair.x, value);
    precise float rest = sum.y + pair.y;
    return cdrExactSum(sum.x, rest);
}

// a + b of two pairs, off by at most 2^-46 of |a| + |b|.
vec2 cdrPairAdd(vec2 a, vec2 b) {
    vec2 sum = cdrExactSum(a.x, b.x);
    precise float rest = sum.y + (a.y + b.y);
    return cdrExactSum(sum.x, rest);
}

// a b of two pairs, off by at most 2^-44 of it.
// @range As cdrExactProduct() of their first parts.
vec2 cdrPairProduct(vec2 a, vec2 b) {
    vec2 product = cdrExactProduct(a.x, b.x);
    precise float rest = product.y + (a.x * b.y + a.y * b.x);
    return cdrExactSum(product.x, rest);
}

// Whether the number a is below b. Rests are at most half a step, as all functions here leave them.
bool cdrPairLess(vec2 a, vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

#endif
