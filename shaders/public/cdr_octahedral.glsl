// Unit vectors as two numbers in [-1, 1]: Cigolle et al. 2014, A Survey of Efficient Representations for Independent
// Unit Vectors, section 3.1.
#ifndef CDR_OCTAHEDRAL_GLSL
#define CDR_OCTAHEDRAL_GLSL

vec2 cdrSignNotZero(vec2 v) { return vec2(v.x >= 0.0 ? 1.0 : -1.0, v.y >= 0.0 ? 1.0 : -1.0); }

vec2 cdrEncodeOctahedral(vec3 n) {
    vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    return n.z >= 0.0 ? p : (1.0 - abs(p.yx)) * cdrSignNotZero(p);
}

// Not normalised.
vec3 cdrDecodeOctahedral(vec2 p) {
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (n.z < 0.0) {
        n.xy = (1.0 - abs(n.yx)) * cdrSignNotZero(n.xy);
    }
    return n;
}

#endif
