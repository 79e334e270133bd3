#include <cdr/render/frame_split.h>
#include <cdr/render/part_scene.h>
#include <cdr/visibility/bin_cells.h>
#include <cdr/visibility/instance_cells.h>

#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace cdr::render {

namespace {

depth::Cascades clipRangesOf(depth::Mapping mapping, const depth::Cascades& ranges) {
    depth::Cascades clipRanges;
    for (std::size_t cascade = 0; cascade < ranges.size(); ++cascade) {
        clipRanges.push_back(depth::clipRange(mapping, ranges, cascade));
    }
    return clipRanges;
}

/// By instance, whether any camera draws it in a cascade of the part.
std::vector<bool> drawnInstances(const scene::Scene& scene, const RenderOptions& options,
                                 std::span<const scene::Camera> cameras, platform::WorkerPool& workers) {
    std::vector<bool> isDrawn(scene.instances.size());
    visibility::InstanceCells cells;
    cells.build(scene, workers);
    FrameSplit split(options.technique);
    visibility::VisibleCells visible;
    visibility::CellBinner binner;
    visibility::DrawLists lists;
    for (const scene::Camera& camera : cameras) {
        scene::requireUsable(camera);
        const scene::Frustum frustum = scene::frustumOf(camera, options.width, options.height);
        visibility::cullCells(cells, camera, frustum, workers, visible);
        const depth::Cascades ranges = split.cut(camera, frustum, std::array{&visible}, {});
        binner.bin(visible, clipRangesOf(options.technique.mapping, ranges),
                   std::numeric_limits<double>::infinity(), workers, lists);
        visibility::keepCascades(lists, options.part.of(ranges.size()));
        for (std::size_t draw = 0; draw < lists.draws(); ++draw) {
            isDrawn[lists.instance[draw]] = true;
        }
    }
    return isDrawn;
}

/// A mesh of its own, since assigning {} to a vector keeps its memory.
scene::Mesh withoutTriangles(scene::Mesh mesh) {
    scene::Mesh left;
    left.name = std::move(mesh.name);
    left.boundingRadius = mesh.boundingRadius;
    left.boxHalfSides = mesh.boxHalfSides;
    return left;
}

} // namespace

void dropOtherParts(scene::Scene& scene, const RenderOptions& options, std::span<const scene::Camera> cameras,
                    platform::WorkerPool& workers) {
    const std::vector<bool> isDrawn = drawnInstances(scene, options, cameras, workers);
    std::vector<bool> usesMesh(scene.meshes.size());
    std::vector<bool> usesTexture(scene.textures.size());
    for (std::size_t i = 0; i < isDrawn.size(); ++i) {
        if (isDrawn[i]) {
            usesMesh[scene.instances.mesh[i]] = true;
            scene::forEachTexture(scene.materials[scene.instances.material[i]],
                                  [&](std::uint32_t texture) { usesTexture[texture] = true; });
        }
    }
    for (std::size_t mesh = 0; mesh < usesMesh.size(); ++mesh) {
        if (!usesMesh[mesh]) {
            scene.meshes[mesh] = withoutTriangles(std::move(scene.meshes[mesh]));
        }
    }
    for (std::size_t texture = 0; texture < usesTexture.size(); ++texture) {
        if (!usesTexture[texture]) {
            scene.textures[texture].pixels = image::ImageRgba8(1, 1);
        }
    }
}

} // namespace cdr::render
