// Define LIGHTING_SET and LIGHTING_BINDING first.
#ifndef CDR_SHADERS_LIGHTING_BUFFER_GLSL
#define CDR_SHADERS_LIGHTING_BUFFER_GLSL

layout(set = LIGHTING_SET, binding = LIGHTING_BINDING, std430) readonly buffer Lighting {
    ShadingHeader header;
    LightRecord lights[];
};

#endif
