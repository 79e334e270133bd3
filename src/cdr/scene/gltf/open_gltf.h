#pragma once

#include <cdr/base/export.h>
#include <cdr/scene/scene_setup.h>

#include <cstdint>
#include <filesystem>
#include <optional>

namespace cdr::scene {

/// What of a glTF file is shown, and through which eyes.
struct GltfChoice {
    std::optional<std::uint32_t> scene; ///< else the file's default one
    std::optional<std::uint32_t>
        camera; ///< of the scene's perspective cameras; else one that frames all of it

    bool operator==(const GltfChoice&) const = default;
};

/// Whether a path is to be opened as glTF, by its extension.
CDR_EXPORT bool isGltfPath(const std::filesystem::path& path);

/// A glTF file lit and framed so that it fills the picture, or seen by a camera of its own. base::InputError
/// as loadGltf(), or when it has no such camera, which names those it has.
CDR_EXPORT OpenedScene openGltf(const std::filesystem::path& path, const GltfChoice& choice = {});

} // namespace cdr::scene
