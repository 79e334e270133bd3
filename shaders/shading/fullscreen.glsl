// One triangle that covers the picture.
#ifndef CDR_SHADERS_FULLSCREEN_GLSL
#define CDR_SHADERS_FULLSCREEN_GLSL

vec4 fullscreenCorner() {
    vec2 corner = vec2(gl_VertexIndex == 1 ? 3.0 : -1.0, gl_VertexIndex == 2 ? 3.0 : -1.0);
    return vec4(corner, 0.0, 1.0);
}

#endif
