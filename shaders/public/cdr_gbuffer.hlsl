// cdr_gbuffer.glsl for HLSL: the same functions, with types and functions named as HLSL has them.
// Afterwards vec2, vec3, uvec4, floatBitsToUint and uintBitsToFloat are no macros: include it before macros of your own with
// these names.
#ifndef CDR_GBUFFER_HLSL
#define CDR_GBUFFER_HLSL

#define vec2 float2
#define vec3 float3
#define uvec4 uint4
#define floatBitsToUint asuint
#define uintBitsToFloat asfloat
#include "cdr_gbuffer.glsl"
#undef vec2
#undef vec3
#undef uvec4
#undef floatBitsToUint
#undef uintBitsToFloat

#endif
