#include <cdr/base/format_error.h>
#include <cdr/image/same_size.h>
#include <cdr/measure/truth/object_ray.h>
#include <cdr/measure/truth/truth_air.h>
#include <cdr/measure/truth/truth_light.h>
#include <cdr/measure/truth/truth_shading.h>

#include <cmath>
#include <optional>
#include <vector>

namespace cdr::measure {

namespace {

/// A box as the pixels that show it need it.
struct Box {
    PlacedCamera camera; ///< in its own space
    glm::dmat3 objectToWorld;
    glm::dmat3 worldToObject;
    glm::dvec3 halfSides;
    glm::dvec3 baseColor; ///< linear
    std::optional<scene::MetallicRoughness> metallicRoughness;
};

Box boxOf(const scene::Scene& scene, const scene::Camera& camera, std::size_t i) {
    const auto fail = [&](const char* what) {
        throw base::inputError("truth picture: instance {} {}", i, what);
    };
    const auto& halfSides = scene.meshes.at(scene.instances.mesh[i]).boxHalfSides;
    const scene::Material& material = scene.materials.at(scene.instances.material[i]);
    const std::optional<InverseBasis> inverse = invertBasis(scene.instances.basis[i]);
    if (!halfSides) {
        fail("is not a box");
    }
    if (material.baseColorTexture || material.unlit || scene::hasDetail(material)) {
        fail("is textured or unlit, or has detail");
    }
    if (!inverse) {
        fail("is flat");
    }
    return {.camera = placeCamera(camera, scene.instances, i, inverse->worldToObject),
            .objectToWorld = glm::dmat3(scene.instances.basis[i]),
            .worldToObject = inverse->worldToObject,
            .halfSides = glm::dvec3(*halfSides),
            .baseColor = glm::dvec3(glm::min(material.baseColorFactor, scene::kMaxBaseColor)),
            .metallicRoughness = material.metallicRoughness};
}

/// By object index; empty where the scene has no such object.
std::vector<std::optional<Box>> boxesOf(const scene::Scene& scene, const scene::Camera& camera) {
    std::vector<std::optional<Box>> boxes(scene.objectCount());
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        std::optional<Box>& box = boxes.at(scene.instances.object[i]);
        if (box) {
            throw base::inputError("truth picture: object {} has two instances", scene.instances.object[i]);
        }
        box = boxOf(scene, camera, i);
    }
    return boxes;
}

/// The outward normal, in world space, of the face that a point of the surface lies on.
glm::dvec3 normalAt(const Box& box, const glm::dvec3& point) {
    int face = 0;
    for (int axis = 1; axis < 3; ++axis) {
        if (std::abs(point[axis]) * box.halfSides[face] > std::abs(point[face]) * box.halfSides[axis]) {
            face = axis;
        }
    }
    glm::dvec3 normal(0.0);
    normal[face] = std::copysign(1.0, point[face]);
    return glm::normalize(glm::transpose(box.worldToObject) * normal);
}

image::Rgba8 shade(const scene::Scene& scene, const scene::Camera& camera, const Box& box,
                   const ObjectRay& ray, double distanceView) {
    const glm::dvec3 point = ray.origin + ray.direction * distanceView;
    const glm::dvec3 fromCamera = box.objectToWorld * (ray.direction * distanceView);
    const glm::dvec3 color = lightFrom(scene, camera,
                                       {.baseColor = box.baseColor,
                                        .metallicRoughness = box.metallicRoughness,
                                        .fromCamera = fromCamera,
                                        .normal = normalAt(box, point)});
    return encode(throughAir(scene, camera.position, fromCamera, color));
}

} // namespace

image::ImageRgba8 shadeTruth(const scene::Scene& scene, const scene::Camera& camera, const TruthImage& truth,
                             platform::WorkerPool& workers) {
    const std::vector<std::optional<Box>> boxes = boxesOf(scene, camera);
    const PixelSlopes slopes = pixelSlopes(camera, truth.width, truth.height);
    image::ImageRgba8 picture(truth.width, truth.height);
    workers.run(truth.height, [&](std::size_t row, std::size_t) {
        const auto y = static_cast<std::uint32_t>(row);
        for (std::uint32_t x = 0; x < truth.width; ++x) {
            const TruthPixel& pixel = truth.at(x, y);
            if (pixel.id != 0) {
                const Box& box = boxes.at(pixel.id - 1).value();
                picture.at(x, y) =
                    shade(scene, camera, box, box.camera.ray(slopes.x[x], slopes.y[y]), pixel.distanceView);
            } else {
                picture.at(x, y) = encode(
                    backgroundAlong(scene, camera.position,
                                    -camera.back + slopes.x[x] * camera.right + slopes.y[y] * camera.up));
            }
        }
    });
    return picture;
}

image::ImageRgba8 orderByTruth(const image::ImageRgba8& picture, const image::ImageU32& ids,
                               const TruthImage& truth, const image::ImageRgba8& shaded) {
    image::requireSameSize(picture, ids, "truth picture");
    image::requireSameSize(picture, truth, "truth picture");
    image::requireSameSize(picture, shaded, "truth picture");
    image::ImageRgba8 ordered = picture;
    for (std::size_t i = 0; i < ordered.pixels.size(); ++i) {
        if (ids.pixels[i] != truth.pixels[i].id) {
            ordered.pixels[i] = shaded.pixels[i];
        }
    }
    return ordered;
}

} // namespace cdr::measure
