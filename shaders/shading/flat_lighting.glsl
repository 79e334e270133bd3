// What all pixels share of lighting, handed from shading.vert to shading.frag as flat varyings. A software rasteriser
// loads what lies in a buffer once for each pixel, and a flat varying once for each triangle. The vertex shader defines
// HANDS_OVER_LIGHTING.
#ifndef CDR_SHADERS_FLAT_LIGHTING_GLSL
#define CDR_SHADERS_FLAT_LIGHTING_GLSL

// How many lights the scene has. With kManyLights or kShapedLights their number and all of them are read from the buffer.
layout(constant_id = 2) const uint kLights = 0u;

#ifdef HANDS_OVER_LIGHTING
#define HANDED flat out
#else
#define HANDED flat in
#endif
// 64 components with gl_Position, as many as every device has.
layout(location = 0) HANDED vec4 flatAmbientAndFog;        // fog.a
layout(location = 1) HANDED vec4 flatBackgroundAndRadius;  // occlusionRadius; fog's colour is the background's
layout(location = 2) HANDED vec4 flatRay;                  // per pixel, and at the first corner
// LightRecords without beams and ranges. In their place, in w of the second and third, the anchors of as many cascades.
layout(location = 3) HANDED vec4 flatLights[3u * kFlatLights];

#ifdef HANDS_OVER_LIGHTING
void handOverLighting() {
    flatAmbientAndFog = vec4(header.ambient, header.fog.a);
    flatBackgroundAndRadius = vec4(header.background, header.occlusionRadius);
    vec2 corner = vec2(-1.0, 1.0) * header.rayScale;
    flatRay = vec4(-2.0 * corner / header.pictureSize, corner + header.rayCentre);
    for (uint i = 0u; i < kFlatLights; ++i) {
        LightRecord light = LightRecord(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
        if (kLights <= kFlatLights && i < kLights) {
            light = lights[i];
        }
        flatLights[3u * i] = light.position;
        flatLights[3u * i + 1u] = vec4(light.positionRest.xyz, header.anchors[i].x);
        flatLights[3u * i + 2u] = vec4(light.color.rgb, header.anchors[i].y);
    }
}
#else
vec3 ambientLight() { return flatAmbientAndFog.rgb; }
vec3 backgroundColor() { return flatBackgroundAndRadius.rgb; }
vec3 fogColor() { return backgroundColor(); }
float fogExtinction() { return flatAmbientAndFog.a; }
float occlusionRadius() { return flatBackgroundAndRadius.a; }
uint lightCount() { return kLights > kFlatLights ? header.lightCount : kLights; }
LightRecord lightAt(uint i) {
    if (kLights > kFlatLights) {
        return lights[i];
    }
    return LightRecord(flatLights[3u * i], flatLights[3u * i + 1u], flatLights[3u * i + 2u], vec4(0.0));
}
// A float and its rest.
vec2 flatAnchorOfFirst() { return vec2(flatLights[1].w, flatLights[2].w); }
// Of a cascade below kFlatLights.
vec2 flatAnchor(uint cascade) {
    vec2 anchor = flatAnchorOfFirst();
    for (uint i = 1u; i < kFlatLights; ++i) {
        anchor = cascade == i ? vec2(flatLights[3u * i + 1u].w, flatLights[3u * i + 2u].w) : anchor;
    }
    return anchor;
}
bool isShaped(LightRecord light) { return kLights == kShapedLights && light.color.w != 0.0; }
#endif

#endif
