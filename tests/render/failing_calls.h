#pragma once

#include <gtest/gtest.h>
#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <string_view>

namespace cdr::render_test {

/// While it lives, one Vulkan call of this program runs out of memory. There is one at a time, and other threads make none
/// of these calls meanwhile.
class FailingCall {
  public:
    /// @param name vkAllocateDescriptorSets, vkCreateBuffer, vkCreateDescriptorPool, vkCreateFence, vkCreateSampler,
    ///             vkQueueSubmit2 or vkGetQueryPoolResults
    /// @param after calls that succeed first
    explicit FailingCall(std::string_view name, std::size_t after = 0);
    ~FailingCall();
    FailingCall(const FailingCall&) = delete;
    FailingCall& operator=(const FailingCall&) = delete;

    /// Whether it has failed.
    static bool hasFailed();
};

/// Whether an action makes more than `after` calls of this name: the next one fails. Nothing else may throw, and that throws no
/// other error.
template <typename Error = std::exception>
bool failsAt(std::string_view call, std::size_t after, const auto& action) {
    const FailingCall failing(call, after);
    try {
        action();
    } catch (const Error& error) {
        EXPECT_TRUE(FailingCall::hasFailed()) << error.what();
    }
    return FailingCall::hasFailed();
}

/// While it lives, Vulkan says something else, as the functions below set it.
template <typename Value>
class StandIn {
  public:
    StandIn(std::optional<Value>& said, Value value) : m_said(said) { m_said = value; }
    ~StandIn() { m_said.reset(); }
    StandIn(const StandIn&) = delete;
    StandIn& operator=(const StandIn&) = delete;

  private:
    std::optional<Value>& m_said;
};

/// What is made on a physical device finds heaps of at most so many bytes.
[[nodiscard]] StandIn<std::uint64_t> smallHeaps(std::uint64_t bytes);
/// Physical devices say that a shader stage reads at most so many storage buffers.
[[nodiscard]] StandIn<std::uint32_t> fewStorageBuffers(std::uint32_t most);
/// Physical devices say that draws name at most so many vertices of a mesh, from 0 on.
[[nodiscard]] StandIn<std::uint32_t> fewIndices(std::uint32_t most);
/// Physical devices say that a buffer has at most so many bytes.
[[nodiscard]] StandIn<std::uint64_t> smallBuffers(std::uint64_t bytes);
/// Physical devices say that an allocation has at most so many bytes.
[[nodiscard]] StandIn<std::uint64_t> smallAllocations(std::uint64_t bytes);
/// Physical devices say that they do not draw to depth images of this format.
[[nodiscard]] StandIn<VkFormat> noDepthFormat(VkFormat format);
/// How many barriers of this program's have left an image, so far, in
struct DepthLayouts {
    std::size_t separate =
        0; ///< a layout of depth or stencil alone, which needs the feature separateDepthStencilLayouts
    std::size_t whole = 0; ///< the layout of any attachment
};
DepthLayouts depthLayouts();
/// How many indexed draws this program has recorded so far.
std::size_t indexedDraws();
/// A counter of four bytes that a frame sets to 0 begins with `first`.
[[nodiscard]] StandIn<std::uint32_t> counterFrom(std::uint32_t first);

} // namespace cdr::render_test
