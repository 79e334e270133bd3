#pragma once

#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace cdr::render_test {

/// While it lives, one Vulkan call of this program runs out of memory. There is one at a time, and other threads make none
/// of these calls meanwhile.
class FailingCall {
  public:
    /// @param name vkCreateBuffer, vkCreateFence, vkCreateSampler, vkQueueSubmit2 or vkGetQueryPoolResults
    /// @param after calls that succeed first
    explicit FailingCall(std::string_view name, std::size_t after = 0);
    ~FailingCall();
    FailingCall(const FailingCall&) = delete;
    FailingCall& operator=(const FailingCall&) = delete;

    /// Whether it has failed.
    static bool hasFailed();
};

/// While it lives, what is made on a physical device finds heaps of at most so many bytes.
class SmallHeaps {
  public:
    explicit SmallHeaps(std::uint64_t bytes);
    ~SmallHeaps();
    SmallHeaps(const SmallHeaps&) = delete;
    SmallHeaps& operator=(const SmallHeaps&) = delete;
};

/// While it lives, physical devices say that a shader stage reads at most so many storage buffers.
class FewStorageBuffers {
  public:
    explicit FewStorageBuffers(std::uint32_t most);
    ~FewStorageBuffers();
    FewStorageBuffers(const FewStorageBuffers&) = delete;
    FewStorageBuffers& operator=(const FewStorageBuffers&) = delete;
};

/// While it lives, physical devices say that draws name at most so many vertices of a mesh, from 0 on.
class FewIndices {
  public:
    explicit FewIndices(std::uint32_t most);
    ~FewIndices();
    FewIndices(const FewIndices&) = delete;
    FewIndices& operator=(const FewIndices&) = delete;
};

/// While it lives, physical devices say that a buffer has at most so many bytes.
class SmallBuffers {
  public:
    explicit SmallBuffers(std::uint64_t bytes);
    ~SmallBuffers();
    SmallBuffers(const SmallBuffers&) = delete;
    SmallBuffers& operator=(const SmallBuffers&) = delete;
};

/// While it lives, physical devices say that they do not draw to depth images of this format.
class NoDepthFormat {
  public:
    explicit NoDepthFormat(VkFormat format);
    ~NoDepthFormat();
    NoDepthFormat(const NoDepthFormat&) = delete;
    NoDepthFormat& operator=(const NoDepthFormat&) = delete;
};

/// While it lives, a counter of four bytes that a frame sets to 0 begins with `first`.
class CounterFrom {
  public:
    explicit CounterFrom(std::uint32_t first);
    ~CounterFrom();
    CounterFrom(const CounterFrom&) = delete;
    CounterFrom& operator=(const CounterFrom&) = delete;
};

} // namespace cdr::render_test
