#include <cdr/measure/certify/true_surfaces.h>
#include <cdr/measure/shadows/shadow_truth.h>
#include <cdr/measure/truth/layered_truth.h>
#include <cdr/measure/truth/truth_finish.h>
#include <cdr/measure/truth/truth_light.h>
#include <cdr/measure/truth/truth_shading.h>
#include <cdr/measure/truth/visible_instances.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_set>
#include <utility>

namespace cdr::measure {

namespace {

bool isBlended(const scene::Material& material) {
    return material.alphaMode == scene::AlphaMode::blend;
}

/// Lays what is blended over repairs.
void blendRepairs(const scene::Scene& scene, std::span<const Shape> shapes, const DrawnFrame& frame,
                  const TruthFinish& finish, platform::WorkerPool& workers,
                  std::vector<PixelRepair>& repairs) {
    std::vector<glm::uvec2> pixels(repairs.size());
    std::transform(repairs.begin(), repairs.end(), pixels.begin(),
                   [](const PixelRepair& repair) { return glm::uvec2(repair.x, repair.y); });
    const std::vector<LayeredPixel> shown = castLayersAt(
        scene, shapes, frame.camera, {frame.ids.width, frame.ids.height}, pixels, frame.hasShadows, workers);
    for (std::size_t i = 0; i < repairs.size(); ++i) {
        if (shown[i].fragments > 0) {
            repairs[i].color = encode(finished(shown[i].color, finish));
        }
    }
}

} // namespace

void lightRepairs(const scene::Scene& scene, std::span<const Shape> shapes, const DrawnFrame& frame,
                  platform::WorkerPool& workers, std::vector<PixelRepair>& repairs) {
    if (repairs.empty()) {
        return;
    }
    std::vector<VisibleInstance> visible =
        visibleInstances(scene, shapes, frame.camera, frame.ids.width, frame.ids.height, workers);
    std::unordered_set<std::uint32_t> shown;
    for (const PixelRepair& repair : repairs) {
        shown.insert(repair.id);
    }
    std::erase_if(visible, [&](const VisibleInstance& instance) { return !shown.contains(instance.id); });
    // Frames with effects are not certified, so the scene alone decides on tone mapping.
    const TruthFinish finish{.neutral = scene.sky.has_value() || scene.air.has_value()};
    std::optional<ShadowTruthCaster> shadows;
    if (frame.hasShadows) {
        shadows.emplace(scene, shapes);
    }
    const TruthTextures textures(scene);
    const TruthShader shader(scene, textures, frame.camera, {frame.ids.width, frame.ids.height},
                             std::move(visible), shadows ? &*shadows : nullptr, finish);
    workers.run(repairs.size(), [&](std::size_t i, std::size_t) {
        PixelRepair& repair = repairs[i];
        const ShadedPixel pixel = shader.at(repair.x, repair.y, repair.id, repair.distanceView);
        repair.color = pixel.color;
        repair.normal = pixel.normal;
        repair.baseColor = pixel.baseColor;
    });
    if (std::any_of(scene.materials.begin(), scene.materials.end(), isBlended)) {
        blendRepairs(scene, shapes, frame, finish, workers, repairs);
    }
}

} // namespace cdr::measure
