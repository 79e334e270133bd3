// cdr_depth.glsl for HLSL: the same functions, with the types named as HLSL has them.
// Afterwards vec2 and vec4 are no macros: include it before macros of your own with these names.
#ifndef CDR_DEPTH_HLSL
#define CDR_DEPTH_HLSL

#define vec2 float2
#define vec4 float4
#ifndef CDR_PRECISE
#define CDR_PRECISE precise
#endif
#include "cdr_depth.glsl"
#undef vec2
#undef vec4

#endif
