#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace vk {
class Instance;
}

namespace cdr::gpu {

/// Collects the messages of the validation layers, from any thread. A test that renders fails unless it stays
/// empty.
class ValidationLog {
  public:
    void add(std::string message);
    std::vector<std::string> messages() const;
    std::size_t count() const;

  private:
    mutable std::mutex m_mutex;
    std::vector<std::string> m_messages;
};

struct InstanceOptions {
    /// Turn on the Khronos validation layer with synchronisation validation. base::InputError when it is not
    /// installed.
    bool validate = false;
    /// Instance extensions a window system asks for.
    std::vector<const char*> extensions;
};

/// The Vulkan loader's instance. base::RunError when there is no loader or no Vulkan 1.3.
class Instance {
  public:
    explicit Instance(const InstanceOptions& options = {});
    ~Instance();
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;
    Instance(Instance&&) noexcept;
    Instance& operator=(Instance&&) noexcept;

    vk::Instance handle() const;
    bool hasDebugNames() const { return m_hasDebugUtils; }
    /// Empty unless validation is on and reported something.
    const ValidationLog& validation() const { return *m_validation; }
    /// The same, for messages while the instance itself is destroyed.
    std::shared_ptr<const ValidationLog> validationLog() const { return m_validation; }

  private:
    struct Handles;

    // Declared before the handles that write to it, so it outlives them.
    std::shared_ptr<ValidationLog> m_validation;
    bool m_hasDebugUtils = false;
    std::unique_ptr<Handles> m_handles;
};

} // namespace cdr::gpu
