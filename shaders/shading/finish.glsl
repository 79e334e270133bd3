// How light becomes a picture: exposure, and tone mapping that keeps base colours (Khronos PBR Neutral).
#ifndef CDR_SHADERS_FINISH_GLSL
#define CDR_SHADERS_FINISH_GLSL

#include "shading/brightest.glsl"
#include "shared.h"

vec3 neutral(vec3 color) {
    const float kCompressed = 0.8 - 0.04; // from here on highlights are compressed
    float least = min(color.r, min(color.g, color.b));
    color -= least < 0.08 ? least - 6.25 * least * least : 0.04;
    float peak = max(color.r, max(color.g, color.b));
    if (peak < kCompressed) {
        return color;
    }
    float room = 1.0 - kCompressed;
    float lower = 1.0 - room * room / (peak + room - kCompressed);
    float white = 1.0 - 1.0 / (0.15 * (peak - lower) + 1.0);
    return mix(color * (lower / peak), vec3(lower), white);
}

// finish: kFinishNone and its siblings.
vec3 finished(vec3 color, uint finish, float exposure) {
    if (finish == kFinishNone) {
        return color;
    }
    vec3 exposed = finish == kFinishExposed ? color * exposure : min(color * exposure, kMostHalf);
    return finish == kFinishNeutral ? neutral(exposed) : exposed;
}

#endif
