// A number as the unevaluated sum of two floats, the second no more than half a unit in the last place of the first.
#ifndef CDR_SHADERS_FLOAT_PAIR_GLSL
#define CDR_SHADERS_FLOAT_PAIR_GLSL

// Exactly a + b: Knuth, The Art of Computer Programming 2, section 4.2.2, theorem B.
vec2 exactSum(float a, float b) {
    precise float sum = a + b;
    precise float partB = sum - a;
    precise float partA = sum - partB;
    precise float rest = (a - partA) + (b - partB);
    return vec2(sum, rest);
}

// pair + value, rounded to a pair.
vec2 pairSum(vec2 pair, float value) {
    vec2 sum = exactSum(pair.x, value);
    precise float rest = sum.y + pair.y;
    return exactSum(sum.x, rest);
}

bool isLess(vec2 a, vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

#endif
