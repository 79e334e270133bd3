#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/instance.h>
#include <cdr/gpu/pipeline.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cdr::test {

/// The validated device that all tests of a program share, opened when the first one needs it. Opening a device takes
/// longer than most tests. It keeps pipelines, which most renderers of tests have alike. What validation says while it
/// closes fails the program.
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
            gpu::keepPipelines(*m_device);
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

/// A test on the shared device; a validation message while it runs fails it. One that passes, but had to leave out what
/// the device lacks, ends as skipped and says what that was.
class DeviceTest : public testing::Test {
  protected:
    void TearDown() override {
        kSharedDevice->expectNoMessagesAfter(m_messagesBefore);
        if (!m_leftOut.empty()) {
            GTEST_SKIP() << "left out: " << m_leftOut << ", which " << device().info().name << " lacks";
        }
    }

    const gpu::Device& device() const { return kSharedDevice->device(); }
    const gpu::Instance& instance() const { return kSharedDevice->instance(); }
    /// The device as a host lends it.
    gpu::BorrowedDevice lentDevice() const {
        return {.instance = instance().handle(),
                .physical = device().physical(),
                .device = device().handle(),
                .queue = device().queue(),
                .queueFamily = device().queueFamily(),
                .hasDebugNames = instance().hasDebugNames()};
    }
    /// Those of the formats that the device can draw to, in their order.
    std::vector<depth::DepthFormat> available(std::span<const depth::DepthFormat> formats) {
        const std::vector<depth::DepthFormat>& has = device().info().depthFormats;
        std::vector<depth::DepthFormat> found;
        for (const depth::DepthFormat format : formats) {
            if (std::find(has.begin(), has.end(), format) != has.end()) {
                found.push_back(format);
            } else {
                leaveOut(std::string(nameOf(format)));
            }
        }
        return found;
    }
    std::vector<depth::DepthFormat> available(std::initializer_list<depth::DepthFormat> formats) {
        return available(std::span(formats.begin(), formats.size()));
    }
    /// Whether the device can cull and bin.
    bool canDrawGpuDriven() {
        const bool can = device().info().gpuDrivenMissing.empty();
        if (!can) {
            leaveOut("gpu-driven submission");
        }
        return can;
    }
    /// Validation messages since the test began.
    std::size_t messageCount() const { return kSharedDevice->messageCount() - m_messagesBefore; }

    /// Says what the test left out.
    void leaveOut(const std::string& what) {
        if (m_leftOut.find(what) == std::string::npos) {
            m_leftOut += (m_leftOut.empty() ? "" : " and ") + what;
        }
    }

  private:
    const std::size_t m_messagesBefore = kSharedDevice->messageCount();
    std::string m_leftOut;
};

} // namespace cdr::test
