#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/frame_view.h>
#include <cdr/render/submit/cascade_commands.h>
#include <cdr/render/targets/gbuffer.h>
#include <cdr/render/targets/targets_choice.h>

#include <memory>
#include <vector>

namespace cdr::render {

/// What every kind of targets is made from.
struct TargetsOptions {
    vk::Extent2D extent;
    vk::Format format = kGBufferFormat; ///< or kVisibilityFormat
    depth::DepthFormat depthFormat = depth::DepthFormat::d32f;
    bool reversedDepth = false; ///< clear to 0 instead of 1
    bool emission = false;      ///< whether an emission buffer lies beside the G-buffer
    /// Of ambient occlusion that each layer works out for itself before it is merged; 0 for none.
    double occlusionRadius = 0.0;
};

/// Of the colour attachments of a scope over these images.
std::vector<vk::Format> surfaceFormats(const TargetsOptions& options);

/// One way for cascades to reach the final G-buffer. Owns its images; every frame starts from nothing.
class Targets {
  public:
    virtual ~Targets() = default;
    Targets() = default;
    Targets(const Targets&) = delete;
    Targets& operator=(const Targets&) = delete;

    /// Slice of the depth range in which cascade `cascade` of `cascades` draws: all of it, unless they share.
    virtual DepthSlice depthSlice(std::size_t /*cascade*/, std::size_t /*cascades*/) const { return {}; }

    /// Takes the images over from whoever used them before, as far as that can be done ahead of record(). That follows in
    /// the same frame. Other targets' draws may lie in between, and then need not wait for each other.
    virtual void begin(vk::CommandBuffer primary) const;

    /// Has the cascades drawn, after begin(). Afterwards gbuffer() holds for each pixel the nearest cascade's surface. It is
    /// in the colour attachment layout, written by colour attachment output. The number of cascades may change
    /// from frame to frame; base::RunError when it asks for more memory than there is.
    virtual void record(CascadeCommands& commands, const FrameView& view) = 0;

    virtual const gpu::Image& gbuffer() const = 0;
    /// The emission buffer, in the same layout after record(); null: there is none.
    virtual const gpu::Image* emission() const { return nullptr; }
    /// A depth attachment whose stencil plane is 1 after record() where gbuffer() holds a surface, else 0; null: there is
    /// none.
    virtual const gpu::Image* marks() const { return nullptr; }
};

/// The emission buffer of targets or of a layer, where they have one.
std::unique_ptr<gpu::Image> makeEmission(const gpu::Device& device, const TargetsOptions& options,
                                         const std::string& name);

/// Makes the targets chosen. base::RunError when the device has too little memory for
/// them. base::InputError for a pool whose layers are out of range.
std::unique_ptr<Targets> makeTargets(const gpu::Device& device, const TargetsChoice& choice,
                                     const TargetsOptions& options);

} // namespace cdr::render
