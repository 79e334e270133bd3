#pragma once

/// @file
/// @errors None but those that a function names.

#include <cdr/base/export.h>
#include <cdr/scene/scene_setup.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace cdr::scene {

/// What lights a model, beside the lamps that stand around it.
enum class ModelLight : std::uint8_t {
    lamps, ///< the same light from everywhere, and more of the lamps
    sky,   ///< a clear sky
    file,  ///< none of the lamps, but the file's own lights, and a little light from everywhere
};

/// All of them.
inline constexpr std::array kModelLights{ModelLight::lamps, ModelLight::sky, ModelLight::file};

/// "lamps", "sky" or "file".
/// @lifetime The program's.
CDR_EXPORT std::string_view nameOf(ModelLight light);
/// @throws base::InputError with a suggestion for an unknown name.
CDR_EXPORT ModelLight parseModelLight(std::string_view name);

/// What of a glTF file is shown, and through which eyes.
struct GltfChoice {
    std::optional<std::uint32_t> scene; ///< else the file's default one
    /// Of the scene's cameras, perspective ones first, then orthographic ones; else one that frames all of it.
    std::optional<std::uint32_t> camera;
    std::optional<ModelLight> light{}; ///< else lamps
    /// As animationOf() takes it; else the first, if `seconds` or `framesPerSecond` are given. Else nothing moves.
    std::optional<std::string> animation{};
    std::optional<double> seconds{};         ///< of the animation at frame 0, at least 0; else 0
    std::optional<double> framesPerSecond{}; ///< above 0; else every frame shows the same moment
    /// Most MiB of all textures with their levels, at least 1: those that take most lose their largest levels, with a note.
    std::optional<std::uint64_t> textureMiB{};
    /// Radius of points and lines, in scene units at the mesh's largest node. Without it, it follows from how far apart a
    /// primitive's points are, or from the size of all its lines together.
    std::optional<double> pointRadius{};

    bool operator==(const GltfChoice&) const = default;
};

/// Most that GltfChoice::textureMiB takes: 4 TiB.
inline constexpr std::uint64_t kMaxTextureMiB = std::uint64_t{1} << 22u;

/// Least that GltfChoice::pointRadius takes.
inline constexpr double kMinPointRadius = 1e-30;
/// Most that GltfChoice::pointRadius takes.
inline constexpr double kMaxPointRadius = 1e30;

/// base::InputError for a number out of its range, whatever the file.
CDR_EXPORT void requireUsable(const GltfChoice& choice);

/// The number of the animation that a text means: of the first that has it as its name, or else the number that it is, from 0.
/// Where another has that number as its name, `#` before it means the number. Nothing where none is meant.
CDR_EXPORT std::optional<std::size_t> animationOf(std::span<const PlayableAnimation> animations,
                                                  std::string_view text);

/// The moment that a frame shows, in seconds of the animation, where one is played.
CDR_EXPORT std::optional<double> secondsAt(const GltfChoice& choice, std::uint32_t frame);

/// Whether a path is to be opened as glTF, by its extension.
CDR_EXPORT bool isGltfPath(const std::filesystem::path& path);

/// A glTF file lit and framed so that it fills the picture, or seen by a camera of its own.
/// @throws base::InputError in one line that names the file and the fault. It cannot be read, is not sound glTF, goes
///         beyond a limit, or has nothing to look at. When it has no such camera or animation, the line names those it
///         has. The same for a choice that is out of range.
CDR_EXPORT OpenedScene openGltf(const std::filesystem::path& path, const GltfChoice& choice = {});

/// The same of bytes in memory, such as a part of an archive: a whole `.glb`, or a `.gltf` whose buffers and images are data
/// URIs. They are read during the call alone.
/// @param name of the bytes in messages, as a file name. The scene is named by it, without an extension.
/// @throws base::InputError as above, and where the bytes refer to a file.
CDR_EXPORT OpenedScene openGltf(std::span<const std::byte> file, const std::string& name,
                                const GltfChoice& choice = {});

} // namespace cdr::scene
