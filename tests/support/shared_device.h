#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/instance.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace cdr::test {

/// The validated device that all tests of a program share, opened when the first one needs it: opening a device takes
/// longer than most tests. What validation says while it closes fails the program.
class SharedDevice final : public testing::Environment {
  public:
    const gpu::Instance& instance() {
        if (!m_instance) {
            m_instance.emplace(gpu::InstanceOptions{.validate = true, .extensions = {}});
        }
        return *m_instance;
    }

    const gpu::Device& device() {
        if (!m_device) {
            m_device.emplace(instance(), "");
        }
        return *m_device;
    }

    /// Validation messages so far.
    std::size_t messageCount() { return instance().validation().count(); }

    /// Fails the running test for each validation message after the first `count`.
    void expectNoMessagesAfter(std::size_t count) { report(*instance().validationLog(), count); }

    void TearDown() override {
        if (!m_instance) {
            return;
        }
        const std::shared_ptr<const gpu::ValidationLog> log = m_instance->validationLog();
        const std::size_t count = log->count();
        m_device.reset();
        m_instance.reset();
        report(*log, count);
    }

  private:
    static void report(const gpu::ValidationLog& log, std::size_t count) {
        const auto messages = log.messages();
        for (std::size_t i = count; i < messages.size(); ++i) {
            ADD_FAILURE() << messages[i];
        }
    }

    std::optional<gpu::Instance> m_instance;
    std::optional<gpu::Device> m_device;
};

/// Googletest owns it and closes it after the last test.
inline SharedDevice* const kSharedDevice = [] {
    auto* const shared = new SharedDevice;
    testing::AddGlobalTestEnvironment(shared);
    return shared;
}();

/// A test on the shared device; a validation message while it runs fails it.
class DeviceTest : public testing::Test {
  protected:
    void TearDown() override { kSharedDevice->expectNoMessagesAfter(m_messagesBefore); }

    const gpu::Device& device() const { return kSharedDevice->device(); }
    const gpu::Instance& instance() const { return kSharedDevice->instance(); }
    /// Validation messages since the test began.
    std::size_t messageCount() const { return kSharedDevice->messageCount() - m_messagesBefore; }

  private:
    const std::size_t m_messagesBefore = kSharedDevice->messageCount();
};

} // namespace cdr::test
