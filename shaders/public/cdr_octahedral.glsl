// Unit vectors as two numbers in [-1, 1]: Cigolle et al. 2014, A Survey of Efficient Representations for Independent
// Unit Vectors, section 3.1.
//
// @units Directions have none; the space is the caller's, and stays.
#ifndef CDR_OCTAHEDRAL_GLSL
#define CDR_OCTAHEDRAL_GLSL

// -1 or 1 for each component of v, 1 for 0.
// @range v: any numbers.
vec2 cdrSignNotZero(vec2 v) { return vec2(v.x >= 0.0 ? 1.0 : -1.0, v.y >= 0.0 ? 1.0 : -1.0); }

// A direction folded onto the square from -1 to 1.
// @range n: of any length but 0.
vec2 cdrEncodeOctahedral(vec3 n) {
    vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    return n.z >= 0.0 ? p : (1.0 - abs(p.yx)) * cdrSignNotZero(p);
}

// The direction of a point of the square. Not normalised: its length is from 0.57 to 1.
// @range p: from -1 to 1.
vec3 cdrDecodeOctahedral(vec2 p) {
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (n.z < 0.0) {
        n.xy = (1.0 - abs(n.yx)) * cdrSignNotZero(n.xy);
    }
    return n;
}

#endif
