#include <cdr/base/error.h>
#include <cdr/measure/truth/visible_instances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace cdr::measure {

namespace {

ViewBox viewBox(const Shape& shape, const scene::Camera& camera, const glm::dvec3& position,
                const glm::mat3& basis, double skew) {
    const glm::dmat3 worldToView = glm::transpose(glm::dmat3(camera.right, camera.up, -camera.back));
    const glm::dmat3 objectToView = worldToView * glm::dmat3(basis);
    ViewBox box;
    box.centre = worldToView * (position - camera.position) + objectToView * shape.centre();
    double extent = glm::length(objectToView * shape.centre());
    for (int axis = 0; axis < 3; ++axis) {
        box.halfSides[static_cast<std::size_t>(axis)] = objectToView[axis] * shape.halfSides()[axis];
        extent += glm::length(objectToView[axis] * shape.halfSides()[axis]);
    }
    // A few dozen roundings at the size of the largest term, on the way here and on a ray's way to its hit.
    box.rounding = 64.0 * std::numeric_limits<double>::epsilon() * skew *
                   (glm::length(position - camera.position) + extent);
    return box;
}

/// A visible instance before its rays are prepared.
struct Candidate {
    std::uint32_t instance;
    Footprint footprint;
    double layer;

    double nearestRank() const { return footprint.nearestView - layer; }
};

std::vector<Candidate> candidates(const scene::Scene& scene, std::span<const Shape> shapes,
                                  const scene::Camera& camera, std::uint32_t width, std::uint32_t height,
                                  platform::WorkerPool& workers, double marginPixels) {
    constexpr std::size_t kChunk = 1024;
    const scene::Instances& instances = scene.instances;
    const std::size_t jobs = (instances.size() + kChunk - 1) / kChunk;
    std::vector<std::vector<Candidate>> found(jobs);
    workers.run(jobs, [&](std::size_t job, std::size_t) {
        for (std::size_t i = job * kChunk; i < std::min((job + 1) * kChunk, instances.size()); ++i) {
            requireSoundInstance(scene, i);
            const std::optional<InverseBasis> inverse = invertBasis(instances.basis[i]);
            if (!inverse) {
                continue;
            }
            const ViewBox box = viewBox(shapes[instances.mesh[i]], camera, instances.position(i),
                                        instances.basis[i], inverse->skew);
            if (const auto seen = footprint(box, camera, width, height, marginPixels)) {
                found[job].push_back(
                    {static_cast<std::uint32_t>(i), *seen, scene.materials[instances.material[i]].layer});
            }
        }
    });
    std::vector<Candidate> all;
    for (const std::vector<Candidate>& chunk : found) {
        all.insert(all.end(), chunk.begin(), chunk.end());
    }
    return all;
}

} // namespace

void requireSoundInstance(const scene::Scene& scene, std::size_t instance) {
    const scene::Instances& instances = scene.instances;
    const auto fail = [&](const char* what) {
        throw base::InputError("instance " + std::to_string(instance) + " " + what);
    };
    if (instances.mesh[instance] >= scene.meshes.size()) {
        fail("refers to a mesh that is not there");
    }
    if (instances.material[instance] >= scene.materials.size()) {
        fail("refers to a material that is not there");
    }
    if (instances.object[instance] > scene::kMaxObjects) {
        fail("has an object index that no id can hold");
    }
    const glm::dvec3 p = instances.position(instance);
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
        fail("has a position that is not finite");
    }
}

std::vector<VisibleInstance> visibleInstances(const scene::Scene& scene, std::span<const Shape> shapes,
                                              const scene::Camera& camera, std::uint32_t width,
                                              std::uint32_t height, platform::WorkerPool& workers,
                                              double marginPixels) {
    std::vector<Candidate> nearestFirst =
        candidates(scene, shapes, camera, width, height, workers, marginPixels);
    std::sort(nearestFirst.begin(), nearestFirst.end(), [](const Candidate& a, const Candidate& b) {
        return std::make_pair(a.nearestRank(), a.instance) < std::make_pair(b.nearestRank(), b.instance);
    });
    const scene::Instances& instances = scene.instances;
    std::vector<VisibleInstance> visible;
    visible.reserve(nearestFirst.size());
    for (const Candidate& candidate : nearestFirst) {
        const std::size_t i = candidate.instance;
        visible.push_back(
            {&shapes[instances.mesh[i]], candidate.instance,
             sidednessOf(scene.materials[instances.material[i]]), instances.object[i] + 1,
             candidate.footprint.nearestView, candidate.layer, candidate.footprint.pixels,
             placeCamera(camera, instances, i, invertBasis(instances.basis[i])->worldToObject)});
    }
    return visible;
}

} // namespace cdr::measure
