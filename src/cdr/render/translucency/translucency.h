#pragma once

/// @file
/// @errors None but those that a function names.
/// @lifetime Names live as long as the program.

#include <cdr/base/export.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace cdr::render {

/// How translucent surfaces (scene::AlphaMode::blend) of one cascade are laid over each other. Cascades are
/// composited far to near either way.
enum class Translucency : std::uint8_t {
    /// Weighted, blended, independent of order: McGuire and Bavoil 2013, with weights over the cascade's
    /// own range. One pass, memory known beforehand; colours are approximate where surfaces overlap.
    weighted,
    /// Exact: every fragment of a pixel kept in a list, sorted by metric view distance, blended in float32.
    /// Needs fragmentStoresAndAtomics, memory per fragment, and for surfaces that receive shadows five storage buffers in a
    /// fragment shader.
    sorted,
};

/// All of them.
inline constexpr std::array kTranslucencies{Translucency::weighted, Translucency::sorted};

/// "weighted" or "sorted".
CDR_EXPORT std::string_view nameOf(Translucency translucency);
/// @throws base::InputError with a suggestion for an unknown name.
CDR_EXPORT Translucency parseTranslucency(std::string_view name);

/// How blended surfaces are drawn.
struct TranslucencyOptions {
    Translucency method = Translucency::weighted; ///< how they blend
    /// Most device bytes that the lists of one frame in flight may take, for Translucency::sorted. A frame
    /// that has more fragments is drawn weighted, and says so. One that is submitted or recorded may be seen before that is
    /// known, and lacks fragments. Those after it are then drawn weighted, until the scene or the size changes, a frame that
    /// is waited for finds room, or Renderer::forgetFrames().
    std::uint64_t maxBytes = std::uint64_t{256} << 20u;
    bool countsFragments = false; ///< fills Frame::fragmentCounts

    bool operator==(const TranslucencyOptions&) const = default;
};

/// Why there are no lists for a frame whose translucent surfaces were to be sorted.
struct ListRefusal {
    /// What was in the way.
    enum class Cause : std::uint8_t {
        noFragmentStores, ///< the device lacks fragmentStoresAndAtomics; there are no bytes to say
        bound,            ///< TranslucencyOptions::maxBytes
        bufferSize,       ///< the largest storage buffer of the device
        memory,           ///< what the device has free
        storageBuffers, ///< the device has fewer in a fragment shader than are read; there are no bytes to say
    };
    Cause cause = Cause::noFragmentStores; ///< what was in the way
    std::uint64_t fragments = 0;           ///< that were to be kept; 0 where empty lists have no room
    std::uint64_t neededBytes = 0;         ///< more than are allowed
    std::uint64_t allowedBytes = 0;        ///< by what was in the way
    bool mayBeMore = false; ///< `fragments` is the least there were, since counting ended there

    bool operator==(const ListRefusal&) const = default;
};

/// What became of a frame's translucent surfaces.
struct TranslucencyStats {
    Translucency method = Translucency::weighted; ///< that drew the frame
    std::size_t draws = 0;              ///< instances; when weighted, those in several cascades once for each
    std::uint64_t fragments = 0;        ///< for lists, those that found no room among them; 0 when weighted
    std::uint64_t bytes = 0;            ///< of device memory for the method: images or lists
    std::optional<ListRefusal> refusal; ///< why the frame was not sorted, though it was to be
};

} // namespace cdr::render
