// Depth of surfaces with a layer offset: they are moved towards the camera by an offset in scene units. Only the difference that
// the offset makes is formed here. So what the device rounds of the surface, it rounds of the surface below it too.
#ifndef CDR_SHADERS_LAYERED_DEPTH_GLSL
#define CDR_SHADERS_LAYERED_DEPTH_GLSL

layout(constant_id = 7) const float kLayerSlope = 0.0; // pixels by which the device rounds two vertices apart
layout(constant_id = 8) const float kDepthStep = 0.0;  // of the depth buffer; 0: float32
layout(constant_id = 9) const float kTowards = -1.0;   // the camera, in depth

// log(1 - x), exact for small x too, where 1 - x rounds.
float logOneMinus(float x) { return abs(x) < 0.01 ? -x * (1.0 + x * (0.5 + x / 3.0)) : log(1.0 - x); }

// What depth in [0, 1] gains where the view distance falls from distanceView by offset.
float depthGain(float distanceView, float offset) {
    if (kDepthForm == kDepthFormLinear) {
        float slope = cascade.depthScale * cascade.anchorView - cascade.depthOffset;
        return -(offset / distanceView) * (slope / (distanceView - offset)); // products of two lengths may be no floats
    }
    return logOneMinus(offset / distanceView) * cascade.depthOffset;
}

// By how much a surface is moved: its layer, and what rounded vertices may part surfaces at the same place. Call it where
// all fragments of a quad do.
float layerShift(float ahead) {
    float steepness = abs(dFdx(ahead)) + abs(dFdy(ahead));
    float shift = cascade.layerOffset + cascade.layerRank * kLayerSlope * steepness;
    return min(shift, 0.5 * (cascade.anchorView + ahead));
}

// clipDistances() of a moved surface. It belongs to the cascade in which its new place lies, which draws over what it is
// to hide. The cascade of its old place keeps it as well, since the other one may not list it.
vec2 layeredClipDistances(float ahead, float shift) {
    const float kRounding = 2e-6; // of distances, interpolated: anchored ones are as large as the cascade is thick
    float size = cascade.anchorView > 0.0 ? cascade.farAhead - cascade.nearAhead : ahead;
    float margin = sign(cascade.layerRank) * kRounding * size;
    float moved = ahead - shift;
    return vec2(max(ahead, moved) - cascade.nearAhead + max(-margin, 0.0),
                cascade.farAhead - min(ahead, moved) + max(margin, 0.0));
}

float layeredDepth(float ahead, float shift) {
    float distanceView = cascade.anchorView + ahead;
    float range = cascade.maxDepth - cascade.minDepth;
    float depth = kDepthForm == kDepthFormLogFragment ? logDepthInSlice(ahead, cascade) : gl_FragCoord.z;
    depth += depthGain(distanceView, shift) * range;
    float twoSteps = 2.0 * (kDepthStep > 0.0 ? kDepthStep : depth * 1.1920929e-7);
    return clamp(depth + kTowards * cascade.layerRank * twoSteps, cascade.minDepth, cascade.maxDepth);
}

#endif
