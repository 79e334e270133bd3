// Most that a surface sends, of any colour.
#ifndef CDR_SHADERS_BRIGHTEST_GLSL
#define CDR_SHADERS_BRIGHTEST_GLSL

// Half floats, and their sums where surfaces blend, must hold it.
const float kBrightest = 16.0;

#endif
