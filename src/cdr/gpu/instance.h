#pragma once

#include <cdr/base/export.h>

#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace cdr::gpu {

/// Collects the messages of the validation layers. A test that renders fails unless it stays empty.
/// @threads Any number at once.
/// @errors None.
class CDR_EXPORT ValidationLog {
  public:
    /// Keeps a message.
    void add(std::string message);
    /// A copy of all so far.
    std::vector<std::string> messages() const;
    /// How many there are so far.
    std::size_t count() const;

  private:
    mutable std::mutex m_mutex;
    std::vector<std::string> m_messages;
};

/// What an Instance is made with.
struct InstanceOptions {
    /// Turn on the Khronos validation layer with synchronisation validation. base::InputError when it is not
    /// installed.
    bool validate = false;
    /// Instance extensions a window system asks for.
    std::vector<const char*> extensions;
};

/// An instance of the Vulkan loader in use: a host's that a BorrowedDevice brought, else the system's.
/// @threads Any number at once may ask what it is.
/// @errors None but the constructor's.
/// @lifetime The handle and references are valid as long as the instance; moving it takes them along.
class CDR_EXPORT Instance {
  public:
    /// @throws base::RunError when there is no loader, no Vulkan 1.3 or no driver.
    /// @throws base::InputError for InstanceOptions::validate without the layer, and for an extension that is not there.
    /// @throws std::system_error for Vulkan's other errors.
    explicit Instance(const InstanceOptions& options = {});
    ~Instance();
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;
    /// What is moved from may only be destroyed or assigned to.
    Instance(Instance&&) noexcept;
    /// As the constructor that moves. Devices of this instance must be gone.
    Instance& operator=(Instance&&) noexcept;

    /// For calls beside cdr's.
    VkInstance handle() const;
    /// Whether it has VK_EXT_debug_utils, so that objects can be named.
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
