#pragma once

#include <cdr/shaders/shared.h>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace cdr::render {

/// Where a full-screen pass reads anchor planes: kAnchored of its fragment shader.
enum class AnchorForm : std::uint32_t {
    none,   ///< the mapping has none
    buffer, ///< of any number of cascades
    flat,   ///< from flat varyings, which have room for those of few; software devices are quicker with these
    single, ///< from a flat varying, of a frame's only cascade
};

/// @param anchored whether the mapping has anchor planes. @param cascades of the frame.
constexpr AnchorForm anchorFormOf(bool anchored, std::size_t cascades) {
    if (!anchored) {
        return AnchorForm::none;
    }
    if (cascades > shaders::kFlatLights) {
        return AnchorForm::buffer;
    }
    return cascades > 1 ? AnchorForm::flat : AnchorForm::single;
}

/// Of a full-screen pass or pipeline, one for frames with as few cascades as flat varyings have room for, and one for all
/// others where these read anchor planes otherwise. What is bound for one suits the other.
template <typename Pass>
struct ByCascades {
    Pass few;
    std::optional<Pass> many;

    /// @param make a Pass from the form in which it reads anchor planes. @param anchored whether the mapping has any.
    template <typename Make>
    static ByCascades make(bool anchored, const Make& make) {
        ByCascades passes{.few = make(anchorFormOf(anchored, shaders::kFlatLights)), .many = std::nullopt};
        if (anchored) {
            passes.many.emplace(make(anchorFormOf(anchored, shaders::kFlatLights + 1)));
        }
        return passes;
    }
    const Pass& of(std::size_t cascades) const {
        return many && cascades > shaders::kFlatLights ? *many : few;
    }
};

} // namespace cdr::render
