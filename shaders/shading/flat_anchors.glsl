// What ambient occlusion and receivers of shadows need of the frame, handed over from flat_anchors.vert as flat varyings. A
// software rasteriser loads what lies in a buffer once for each pixel, and a flat varying once for each triangle. The vertex
// shader defines HANDS_OVER_ANCHORS.
#ifndef CDR_SHADERS_FLAT_ANCHORS_GLSL
#define CDR_SHADERS_FLAT_ANCHORS_GLSL

#ifdef HANDS_OVER_ANCHORS
#define HANDED_ANCHORS flat out
#else
#define HANDED_ANCHORS flat in
#endif
layout(location = 0) HANDED_ANCHORS vec4 flatRays; // rayScale, rayCentre
layout(location = 1) HANDED_ANCHORS vec3 flatPicture; // pictureSize, occlusionRadius
layout(location = 2) HANDED_ANCHORS vec2 flatAnchors[kFlatLights]; // as many as the shading pass has

#ifdef HANDS_OVER_ANCHORS
void handOverAnchors() {
    flatRays = vec4(header.rayScale, header.rayCentre);
    flatPicture = vec3(header.pictureSize, header.occlusionRadius);
    for (uint i = 0u; i < kFlatLights; ++i) {
        flatAnchors[i] = header.anchors[i];
    }
}
#else
vec2 flatAnchor(uint cascade) {
    vec2 anchor = flatAnchors[0];
    for (uint i = 1u; i < kFlatLights; ++i) {
        anchor = cascade == i ? flatAnchors[i] : anchor;
    }
    return anchor;
}

layout(constant_id = 0) const uint kAnchored = 1u; // as in shading.frag

vec2 anchorOf(uint cascade) {
    if (kAnchored == 2u) {
        return flatAnchor(cascade);
    }
    return kAnchored != 0u ? header.anchors[cascade] : vec2(0.0);
}
#endif

#endif
