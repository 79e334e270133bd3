// Binding 1 of set 0, unless LIGHTING_SET and LIGHTING_BINDING are defined first.
#ifndef CDR_SHADERS_LIGHTING_BUFFER_GLSL
#define CDR_SHADERS_LIGHTING_BUFFER_GLSL

#ifndef LIGHTING_SET
#define LIGHTING_SET 0
#define LIGHTING_BINDING 1
#endif

layout(set = LIGHTING_SET, binding = LIGHTING_BINDING, std430) readonly buffer Lighting {
    ShadingHeader header;
    LightRecord lights[];
};

#endif
