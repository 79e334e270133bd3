#pragma once

/// @file
/// @errors None: neither that a pixel is in the picture nor that the G-buffer was copied is checked, but by Frame::pick().

#include <cdr/base/export.h>
#include <cdr/depth/cascade.h>
#include <cdr/image/image.h>
#include <cdr/render/shadows/shadows.h>
#include <cdr/render/targets/gbuffer_pixel.h>
#include <cdr/render/translucency/translucency.h>
#include <cdr/scene/camera.h>

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace cdr::render {

/// Where a frame's time went. Record and execute are never added up.
struct FrameTimes {
    double cullMs = 0.0;  ///< CPU, finding what the camera sees
    double splitMs = 0.0; ///< CPU, cutting the range into cascades
    double occludersMs =
        0.0;            ///< drawing occluders and testing what they hide, the wait for the device included
    double binMs = 0.0; ///< CPU, listing what each cascade draws
    double translucentMs = 0.0; ///< CPU culling, binning and writing the translucent draws
    double shadowsMs = 0.0;     ///< CPU, finding what casts shadows
    double recordMs = 0.0;      ///< CPU writing commands
    double executeMs = 0.0;     ///< from submit until the device has finished
    /// From the beginning to the end of the frame's commands by the device's own clock. Empty without
    /// RenderOptions::deviceClock, where the queue has no timestamps, and of frames that a host records.
    std::optional<double> deviceMs{};
};

/// Counts of occlusion culling.
struct OccluderStats {
    std::size_t draws = 0;  ///< of occluders, before the frame's own
    std::size_t hidden = 0; ///< instances in the frustum that were left out, since others hide them
};

/// Statistics of a frame.
struct FrameStats {
    std::size_t visible = 0;        ///< opaque instances in at least one cascade
    std::size_t draws = 0;          ///< with those that straddle a boundary counted once per cascade
    double duplication = 1.0;       ///< draws per visible instance
    FrameTimes times;               ///< where its time went
    TranslucencyStats translucency; ///< of the blended ones
    OccluderStats occluders;        ///< where there is occlusion culling
    ShadowStats shadows;            ///< where lights cast them
    /// Metallic-roughness surfaces were drawn matt: ambient occlusion per cascade takes their bits.
    bool lostMetallicRoughness = false;
    /// Surfaces emit light or have occlusion textures, and were drawn without. Ambient occlusion per cascade and a lens with
    /// a focus support neither.
    bool lostEmission = false;
};

/// What a pixel shows, in float64: as exact as the technique, so with anchored as the anchored step.
struct Pick {
    std::uint32_t object = 0;  ///< index
    double distanceView = 0.0; ///< along the view axis
    glm::dvec3 position{0.0};  ///< world space, on the ray through the pixel's centre
    glm::dvec3 normal{0.0};    ///< world space, unit, to 16 bits
};

/// One of several pictures beside each other in a frame: joinedFrame().
struct JoinedView {
    scene::Camera camera; ///< that looked
    /// The frame's column at which the view's own picture begins, though what it was moved by may cut that off.
    std::int64_t firstColumn = 0;
};

/// What Renderer::render() copies to main memory: the picture, or the G-buffer too, which is four times as large.
enum class FrameCopy : std::uint8_t { color, everything };

/// One rendered frame in main memory. Pixels run from the top left.
struct CDR_EXPORT Frame {
    scene::Camera camera;            ///< that looked, at all of it unless there are `views`
    std::vector<JoinedView> views{}; ///< of a joinedFrame(), from the left, of one width; else empty
    depth::Cascades cascades;        ///< nearest first
    std::vector<double> anchorsView; ///< each cascade's anchor plane, 0 where the mapping is not anchored
    image::ImageRgba8 color;         ///< sRGB
    /// Linear light with Rec. 709 primaries, before exposure, tone mapping and antialiasing. Above 65,504 it is cut off, or
    /// infinite. Empty without RenderOptions::linear, or where FrameCopy::color was asked for.
    image::Raster<glm::vec3> linear{};
    /// The G-buffer: opaque surfaces, blended ones are seen through; empty where FrameCopy::color was asked
    /// for.
    image::Raster<GBufferPixel> gbuffer;
    /// From each pixel to where its surface was in the last frame, in pixels, to the right and down: cdr_gbuffer.glsl.
    /// Empty without RenderOptions::motion, or where FrameCopy::color was asked for.
    image::Raster<glm::vec2> motion;
    /// Of each of scene::shadowLights() 255 where it reaches the opaque surface, else 0. Where its cone or
    /// range leaves no light, either. Empty without RenderOptions::shadows, or where FrameCopy::color was asked for.
    image::ImageRgba8 litMask;
    /// Translucent fragments at or in front of the opaque surface, at most 2048; empty unless they were counted.
    image::ImageU32 fragmentCounts;
    FrameStats stats; ///< of this frame

    /// Pixels of a row.
    std::uint32_t width() const { return color.width; }
    /// Rows.
    std::uint32_t height() const { return color.height; }

    /// Object index + 1, 0 for background.
    std::uint32_t id(std::uint32_t x, std::uint32_t y) const;
    /// The cascade that drew the pixel; 0 for background.
    std::uint32_t cascade(std::uint32_t x, std::uint32_t y) const;
    /// Metric view distance in float64: anchor plane plus what the pixel holds; infinity for background.
    double distanceView(std::uint32_t x, std::uint32_t y) const;
    /// The same of a pixel that is not background.
    double distanceView(const GBufferPixel& pixel) const {
        return anchorsView[pixel.cascade()] + static_cast<double>(pixel.ahead);
    }
    /// Unit normal in view space; zero for background.
    glm::vec3 normalView(std::uint32_t x, std::uint32_t y) const;

    /// The opaque surface at a pixel. Empty for background, outside the picture, and where the G-buffer was not copied.
    std::optional<Pick> pick(std::uint32_t x, std::uint32_t y) const;

    /// id() of every pixel.
    image::ImageU32 ids() const;
};

} // namespace cdr::render
