#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <list>
#include <memory>
#include <utility>
#include <vector>

namespace cdr::gpu {

/// Objects that were replaced while what the queue was given may still read them. They are freed once that is done, so
/// that nobody waits for it.
/// @threads One thread at a time.
class Retired {
  public:
    /// The device must outlive this.
    explicit Retired(const Device& device) : m_device(device) {}
    /// Waits for what is in flight.
    ~Retired();
    Retired(const Retired&) = delete;
    Retired& operator=(const Retired&) = delete;

    /// Takes what nothing that is submitted from now on reads.
    template <typename Object>
    void add(Object object) {
        m_open.push_back(std::make_shared<Object>(std::move(object)));
    }

    /// What was added is kept until all is done that the queue was given before this call.
    void close();
    /// Frees what was kept long enough. Does not wait.
    void free();

  private:
    struct Batch {
        vk::UniqueFence done;
        std::vector<std::shared_ptr<void>> objects;
    };

    const Device& m_device;
    std::vector<std::shared_ptr<void>> m_open;
    std::list<Batch> m_batches; ///< oldest first
};

} // namespace cdr::gpu
