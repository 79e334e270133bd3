// Software rasterisers pay for a division what they pay for ten products: normalize() divides three times, and
// unpackUnorm4x8() four times.
#ifndef CDR_SHADERS_CHEAP_DIVISION_GLSL
#define CDR_SHADERS_CHEAP_DIVISION_GLSL

vec3 unit(vec3 v) { return v * inversesqrt(dot(v, v)); }

#endif
