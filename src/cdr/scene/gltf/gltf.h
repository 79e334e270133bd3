#pragma once

#include <cdr/scene/animation/orthographic.h>
#include <cdr/scene/animation/scene_animation.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/gltf/import_progress.h>
#include <cdr/scene/lod/mesh_pieces.h>
#include <cdr/scene/scene.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cdr::scene {

/// What the importer refuses to go beyond. Any file may be hostile.
struct GltfLimits {
    /// Each file read. Four times this for all files beside it, and again for pictures in buffer views.
    std::uintmax_t maxFileBytes = 1ull << 30;
    std::uint64_t maxTriangles = 50'000'000; ///< after instancing
    std::uint64_t maxBytes = 4ull << 30; ///< of memory for meshes and instances, predicted from their counts
    std::uint32_t maxNodes = 1'000'000;
    std::uint32_t maxNodeDepth = 1'000;
    /// Not refused but cut: meshes wider than this become pieces (cutIntoPieces()). Scene units, where the
    /// mesh's largest node has it.
    double pieceRadius = kPieceRadius;
    /// Not refused but shrunk, with a note: the bytes of all textures with their levels. The largest levels of the largest
    /// textures are left out. Without it, what takes over 1366 MiB is refused, and with it pictures of over 2^36 texels together.
    std::optional<std::uint64_t> textureMemory{};
    /// Not refused but used: radius of points and lines, above 0. It is in scene units at the mesh's largest node, and in
    /// units of the mesh where a skin deforms it. Without it, each primitive gets one. That follows from how far apart its
    /// points are, or from the size of all its lines together.
    std::optional<double> pointRadius{};
    /// Not refused but used: threads that decode pictures, at most; 0: as many as there are processors. What is imported
    /// does not depend on it.
    std::size_t threads = 0;
    ImportProgress progress{}; ///< may be empty
};

struct GltfChoice;
/// The limits that a choice sets. base::InputError for a choice that is out of range.
GltfLimits limitsOf(const GltfChoice& choice);

/// A camera of a file, in world space. Its aspect ratio is left to the picture; where the file gives no far plane it is
/// kGltfFarRatio times the near one.
struct GltfCamera {
    std::string name;
    Camera camera; ///< where it stands, and through what it looks unless it is orthographic
    int node = 0;  ///< of the file
    std::optional<OrthographicLens> orthographic{}; ///< openGltf() shows it as fromAfar() does
};
inline constexpr double kGltfFarRatio = 1e7;

/// A light of a file (KHR_lights_punctual), in world space.
struct GltfLight {
    std::string name;
    glm::dvec3 position{0.0};
    std::optional<glm::dvec3>
        direction{};       ///< that it shines in, of length one, from infinitely far; none: from its position
    glm::vec3 color{1.0f}; ///< linear
    double intensity = 1.0;          ///< candela, or lux with a direction
    std::optional<LightCone> cone{}; ///< of a spot light
    std::optional<double> range{};   ///< scene units; none: unlimited
    int node = 0;                    ///< of the file
};

/// A glTF file as a scene. Objects are the primitives of the nodes that carry a mesh, in the order of the file's node array. A
/// single one has the node's name, several have those of their materials as well. The scene has no lights.
struct GltfImport {
    Scene scene;
    std::vector<GltfCamera>
        cameras; ///< of the scene's nodes, in the order of the file's node array, orthographic ones last
    std::vector<GltfLight> lights; ///< of the scene's nodes, at rest, in the order of the file's node array
    std::vector<std::string> ignored; ///< one line per feature of the file that was not used
    /// What nodes move; the scene is as it is at rest. Null where nothing of it can move.
    std::shared_ptr<const SceneAnimation> animation;
    /// By node of the file: which one of the animation's rig it is.
    std::vector<std::optional<std::size_t>> rigNodeOf;
};

/// Imports glTF 2.0 (`.gltf` with embedded or external buffers, or `.glb`). Node transforms are composed in float64. Skins and
/// morph targets deform meshes as they are at rest. Buffers and images outside the file's folder are
/// refused. base::InputError with one line naming the file and the fault for anything that is not sound.
/// @param scene which of the file's scenes; without it the file's default one, else its first, else all
/// nodes.
GltfImport loadGltf(const std::filesystem::path& path, const GltfLimits& limits = {},
                    std::optional<std::uint32_t> scene = {});

/// The same of bytes in memory, which are read during the call alone and may refer to no file.
/// @param name of the bytes in messages.
GltfImport loadGltf(std::span<const std::byte> file, const std::string& name, const GltfLimits& limits = {},
                    std::optional<std::uint32_t> scene = {});

/// A file that a glTF file refers to.
struct GltfReference {
    std::string uri; ///< as the glTF file names it
    std::filesystem::path path;
};

/// The files beside a glTF file that its buffers and images name, in that order and each URI once. They need not exist. Of a
/// file that loadGltf() refuses, those whose references are sound. base::InputError if the file cannot be read.
std::vector<GltfReference> gltfReferences(const std::filesystem::path& path, const GltfLimits& limits = {});

} // namespace cdr::scene
