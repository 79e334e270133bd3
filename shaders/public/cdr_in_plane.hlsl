// cdr_in_plane.glsl for HLSL: the same functions, with the types named as HLSL has them.
// Afterwards vec2, vec3 and vec4 are no macros: include it before macros of your own with these names.
#ifndef CDR_IN_PLANE_HLSL
#define CDR_IN_PLANE_HLSL

#define vec2 float2
#define vec3 float3
#define vec4 float4
#include "cdr_in_plane.glsl"
#undef vec2
#undef vec3
#undef vec4

#endif
