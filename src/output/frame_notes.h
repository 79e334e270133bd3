#pragma once

#include <cdr/render/frame.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace cdr::output {

/// Why a frame's translucent surfaces were not sorted, in words.
/// @param device that drew the frame, by name. @param width of the picture. @param height likewise.
std::string noteOn(const render::ListRefusal& refusal, std::string_view device, std::uint32_t width,
                   std::uint32_t height);

/// What FrameStats::lostEmission means, in words.
std::string_view noteOnLostEmission();

/// What FrameStats::lostMetallicRoughness means, in words.
std::string_view noteOnLostMetallicRoughness();

} // namespace cdr::output
