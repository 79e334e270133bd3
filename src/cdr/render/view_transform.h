#pragma once

#include <cdr/depth/mapping.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>
#include <cdr/shaders/shared.h>

#include <cstdint>

namespace cdr::render {

/// The picture's half size at view distance 1: what perspective divides by.
struct Lens {
    double tanX = 1.0;
    double tanY = 1.0;
};
Lens lensOf(const scene::Camera& camera, double aspect);

/// One instance as a cascade's vertex shader wants it. The camera's position, and the cascade's anchor, are
/// subtracted in float64; only the small remainder is rounded to float32.
/// @param anchorView view distance of the cascade's anchor plane, 0 for mappings that are not anchored.
shaders::DrawRecord makeDrawRecord(const scene::Instances& instances, std::uint32_t instance,
                                   const scene::Camera& camera, double anchorView);

/// A part of the depth range, [0, 1], for a viewport and for shaders that set their depth.
struct DepthSlice {
    float min = 0.0f;
    float max = 1.0f;
};

/// What the draws of one cascade share.
shaders::CascadePush makeCascadePush(const depth::ClipTerms& terms, const depth::Cascade& clipRange,
                                     const Lens& lens, const DepthSlice& slice, std::uint32_t cascade);

/// A light in view space, each coordinate as a float and its rest.
shaders::LightRecord makeLightRecord(const scene::PointLight& light, const scene::Camera& camera);

/// A float64 as a float and the rest that the float left out.
glm::vec2 splitDouble(double value);

} // namespace cdr::render
