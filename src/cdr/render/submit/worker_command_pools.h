#pragma once

#include <cdr/gpu/commands.h>

#include <cstdint>
#include <string>
#include <vector>

namespace cdr::render {

/// A command pool per worker, for one frame slot; no lock, since each worker touches its own.
class WorkerCommandPools {
  public:
    WorkerCommandPools(const gpu::Device& device, vk::CommandBufferLevel level, std::size_t workers,
                       const std::string& name) {
        for (std::size_t worker = 0; worker < workers; ++worker) {
            m_pools.push_back({gpu::CommandPool(device, level, name + " worker " + std::to_string(worker))});
        }
    }

    std::size_t workers() const { return m_pools.size(); }

    /// The slot's last frame has finished: its buffers may be taken back.
    void beginFrame() { ++m_frame; }

    /// A buffer in the initial state. The worker itself resets its pool, at its first buffer of a frame.
    /// Freeing a frame's commands takes about as long as writing them, and memory that a thread frees comes
    /// back to it warm.
    vk::CommandBuffer next(std::size_t worker) {
        Pool& pool = m_pools[worker];
        if (pool.frame != m_frame) {
            pool.commands.reset();
            pool.frame = m_frame;
        }
        return pool.commands.next();
    }

  private:
    struct Pool {
        gpu::CommandPool commands;
        std::uint64_t frame = 0; ///< it was last reset for
    };
    std::vector<Pool> m_pools;
    std::uint64_t m_frame = 0;
};

} // namespace cdr::render
