#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/render/frame_view.h>
#include <cdr/render/submit/cascade_commands.h>
#include <cdr/render/targets/gbuffer.h>

#include <vulkan/vulkan.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace cdr::render {

/// How cascades reach the final G-buffer: the four methods of the thesis (chapter 3), and ours.
enum class TargetsKind : std::uint8_t { single, accumulate, pool, layers, onePass };

inline constexpr std::array kTargetsKinds{TargetsKind::single, TargetsKind::accumulate, TargetsKind::pool,
                                          TargetsKind::layers, TargetsKind::onePass};

/// "single", "accumulate", "pool", "layers" or "one-pass".
std::string_view nameOf(TargetsKind kind);

/// Layers a pool may have; with one it would be `accumulate`.
inline constexpr std::uint32_t kMinPoolLayers = 2;
inline constexpr std::uint32_t kMaxPoolLayers = 16;
inline constexpr std::uint32_t kDefaultPoolLayers = 3;

/// A kind of targets and what it leaves to choose.
struct TargetsChoice {
    TargetsKind kind = TargetsKind::single;
    std::uint32_t layers = 0; ///< of a pool; 0 for the other kinds, which have no say in it

    TargetsChoice() = default;
    /// A kind as it comes: a pool has kDefaultPoolLayers.
    TargetsChoice(TargetsKind ofKind); // NOLINT(google-explicit-constructor): a kind is a choice
    /// base::InputError unless kMinPoolLayers to kMaxPoolLayers.
    static TargetsChoice pool(std::uint32_t layers);

    bool operator==(const TargetsChoice&) const = default;
};

/// The kind's name, a pool's with its layers: "pool:4".
std::string nameOf(const TargetsChoice& choice);

/// Reads a kind's name, or "pool:N". base::InputError with a suggestion for an unknown name, and for a number
/// that does not fit.
TargetsChoice parseTargets(std::string_view text);

/// What every kind of targets is made from.
struct TargetsOptions {
    vk::Extent2D extent;
    depth::DepthFormat depthFormat = depth::DepthFormat::d32f;
    bool reversedDepth = false; ///< clear to 0 instead of 1
    /// Of ambient occlusion that each layer works out for itself before it is merged; 0 for none.
    double occlusionRadius = 0.0;
};

/// One way for cascades to reach the final G-buffer. Owns its images; every frame starts from nothing.
class Targets {
  public:
    virtual ~Targets() = default;
    Targets() = default;
    Targets(const Targets&) = delete;
    Targets& operator=(const Targets&) = delete;

    /// Slice of the depth range in which cascade `cascade` of `cascades` draws: all of it, unless they share.
    virtual DepthSlice depthSlice(std::size_t cascade, std::size_t cascades) const;

    /// Has the cascades drawn, so that afterwards gbuffer() holds for each pixel the nearest cascade's
    /// surface, in the colour attachment layout, written by colour attachment output. The number of cascades
    /// may change from frame to frame; base::RunError, with both figures, when it asks for more memory than
    /// there is.
    virtual void record(CascadeCommands& commands, const FrameView& view) = 0;

    virtual const gpu::Image& gbuffer() const = 0;
};

/// Whether cascades are drawn into layers of their own before they meet: accumulate, pool and layers.
bool hasLayers(TargetsKind kind);

/// Makes the targets chosen. base::RunError, with both figures, when the device has too little memory for
/// them; base::InputError for a pool whose layers are out of range.
std::unique_ptr<Targets> makeTargets(const gpu::Device& device, const TargetsChoice& choice,
                                     const TargetsOptions& options);

} // namespace cdr::render
