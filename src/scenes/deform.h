#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace cdr::scenes {

/// Who makes the vertices of meshes that joints and morph targets deform.
enum class Deform : std::uint8_t {
    cpu,    ///< worker threads; what they make is uploaded
    device, ///< the device, for what it draws; the scene keeps the vertices of an earlier frame
    both,   ///< the device for what it draws, and the CPU for truth, certificates and facets
};

/// Those that a person chooses from.
inline constexpr std::array kDeforms{Deform::cpu, Deform::device};

/// "cpu" or "device": who makes what is drawn.
std::string_view nameOf(Deform deform);
/// base::InputError for another name than those of kDeforms.
Deform parseDeform(std::string_view name);

} // namespace cdr::scenes
