// Most that a surface sends, of any colour.
#ifndef CDR_SHADERS_BRIGHTEST_GLSL
#define CDR_SHADERS_BRIGHTEST_GLSL

// Half floats, and their sums where surfaces blend, must hold it.
const float kBrightest = 16.0;
// Most that lights add up to: with an albedo of 0, infinity would not be a number.
const float kMostLight = 1e30;
// Most that half floats hold. Beyond it is infinity, and 0 times that is not a number.
const float kMostHalf = 65504.0;

#endif
