#pragma once

#include <cdr/image/image.h>
#include <cdr/measure/certify/device_bound.h>
#include <cdr/measure/certify/drawn_frame.h>
#include <cdr/measure/certify/layer_offset.h>
#include <cdr/measure/certify/mesh_outline.h>
#include <cdr/measure/certify/order_strip.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cdr::measure {

/// What a pixel that was drawn wrong has to show, all of it from float64.
struct PixelRepair {
    std::uint32_t x = 0;
    std::uint32_t y = 0;
    std::uint32_t id = 0;      ///< object index + 1, 0 for background
    double distanceView = 0.0; ///< infinity for background
    glm::dvec3 normal{0.0};    ///< world axes, unit
    glm::dvec3 baseColor{0.0}; ///< linear
    image::Rgba8 color{};      ///< sRGB, lit
};

/// What is known of a drawn picture. Where pixels are refused, no ray is cast for the others: they are in no count.
struct Certificate {
    std::uint64_t pixels = 0;
    std::uint64_t certified = 0; ///< right, without a ray
    std::uint64_t proven = 0;    ///< of those certified: where a device may have drawn something else
    std::uint64_t cast = 0;      ///< decided by a float64 ray
    std::uint64_t castMasked =
        0; ///< of those cast: where a masked surface may be seen, or what is behind its holes
    std::uint64_t refused = 0; ///< show what no device within its limits draws there
    std::uint64_t wrong = 0;   ///< of those cast: whose object was drawn wrong
    std::uint64_t blended =
        0; ///< where a blended surface may be seen: what is behind it is certified, its colour is not
    std::optional<glm::uvec2> firstRefused; ///< in the order of rows
    std::vector<PixelRepair> repairs;       ///< of those cast: what to draw there; in the order of rows
    FrameBound bound;                       ///< how far off the device may have drawn

    bool isRefused() const { return refused > 0; }
    double certifiedFraction() const {
        return pixels ? static_cast<double>(certified) / static_cast<double>(pixels) : 1.0;
    }
};

/// Proves, pixel by pixel, that a drawn picture is right, and repairs wrong pixels.
///
/// Coverage rule: the float64 ray through a pixel's centre decides, as TruthCaster has it.
///
/// 1. Triangles are placed in float64 and give each pixel intervals of distance (OrderStrip). A pixel is certified where its
///    drawn object surely covers it and was drawn at its place. It must also be nearer than every other object by more than
///    the device may be off.
/// 2. Where the bound allows two answers, the same is tested again with triangles that are off by roundings of float64 alone.
///    Nearly all pixels that were drawn right are proven so.
/// 3. Rays are cast for the others, which were drawn wrong or lie on an edge. Wrong ones are repaired.
/// 4. A mask keeps what it keeps in float64, as TruthCaster filters textures. No bound of a device's filter is used. So a pixel
///    where a masked surface may be the nearest one, or before it, is proven by 2. or cast, and never refused for the mask.
/// 5. Of surfaces with a layer, that is nearer whose distance less its layer is less.
/// 6. Blended surfaces hide nothing. What they are drawn over is certified, and their colours are not. A repaired pixel has
///    them over it in the order of their distances.
/// 7. A pixel that shows what the bound rules out is refused: driver, renderer or scene are not what they are said to be.
///
/// Why a certified pixel is right: every margin is larger than what float64 rounds where it places triangles, 10^-9 pixels in
/// most views. So an object that covers a pixel by more than the margins covers it. One that is nearer by more than them is
/// nearer. The device's limits decide only which pixels are refused, which of the others no such device can draw in another
/// way, and by how much a drawn distance may miss the nearest surface there. Each surface has its own limit.
class Certifier {
  public:
    /// @param scene must outlive the certifier. Instances may change, and meshes that follow() is told of, materials not.
    /// base::InputError as TruthCaster.
    Certifier(const scene::Scene& scene, platform::WorkerPool& workers);

    /// As TruthCaster::follow().
    void follow(std::span<const std::uint32_t> meshes, platform::WorkerPool& workers);

    /// The same for any number of workers. base::InputError when the sizes of the frame's rasters differ, base::RunError when
    /// the certificate takes more memory than is free.
    Certificate certify(const DrawnFrame& frame, platform::WorkerPool& workers) const;

  private:
    using Findings = image::Raster<PixelFinding>;

    Findings find(const DrawnFrame& frame, platform::WorkerPool& workers, FrameBound& bound) const;
    /// Casts what the findings leave open.
    void repair(const DrawnFrame& frame, const Findings& findings, platform::WorkerPool& workers,
                Certificate& certificate) const;

    const scene::Scene* m_scene;
    TruthCaster m_caster;
    std::vector<LayerOffset> m_layers;   ///< per material
    std::vector<MeshOutline> m_outlines; ///< per mesh
};

} // namespace cdr::measure
