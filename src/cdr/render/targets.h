#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/render/cascade_recorder.h>
#include <cdr/render/gbuffer.h>

#include <vulkan/vulkan.hpp>

#include <cstdint>
#include <memory>
#include <string_view>

namespace cdr::render {

/// How cascades reach the final G-buffer (thesis chapter 3).
enum class TargetsKind : std::uint8_t { single };

std::string_view nameOf(TargetsKind kind);
/// base::InputError with a suggestion for an unknown name.
TargetsKind parseTargets(std::string_view name);

/// What every kind of targets is made from.
struct TargetsOptions {
    vk::Extent2D extent;
    vk::Format depthFormat = vk::Format::eUndefined;
    bool reversedDepth = false; ///< clear to 0 instead of 1
};

/// One way for cascades to reach the final G-buffer. Owns its images; every frame starts from nothing.
class Targets {
  public:
    virtual ~Targets() = default;
    Targets() = default;
    Targets(const Targets&) = delete;
    Targets& operator=(const Targets&) = delete;

    /// Slice of the depth range in which cascade `cascade` of `cascades` draws.
    struct DepthSlice {
        float min = 0.0f;
        float max = 1.0f;
    };
    virtual DepthSlice depthSlice(std::size_t cascade, std::size_t cascades) const;

    /// Puts the cascades' secondaries into `primary`, so that afterwards gbuffer() holds for each pixel the
    /// nearest cascade's surface, in the colour attachment layout, written by colour attachment
    /// output.
    virtual void record(vk::CommandBuffer primary, const CascadeRecorder& recorder, std::size_t cascades) = 0;

    virtual const gpu::Image& gbuffer() const = 0;
};

/// Makes the targets of a kind. base::RunError, with both figures, when the device has too little memory for
/// them.
std::unique_ptr<Targets> makeTargets(const gpu::Device& device, TargetsKind kind,
                                     const TargetsOptions& options);

} // namespace cdr::render
