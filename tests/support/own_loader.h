#pragma once

#include <cdr/gpu/functions.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <gtest/gtest.h>

namespace cdr::test {

/// vkGetInstanceProcAddr of the system's loader.
inline PFN_vkGetInstanceProcAddr systemsLoader() {
    static const vk::DynamicLoader kLibrary;
    return kLibrary.getProcAddress<PFN_vkGetInstanceProcAddr>("vkGetInstanceProcAddr");
}

/// Has all of a test program call Vulkan by a loader of its own. A process has one loader, so it is brought before any test:
/// by testing::AddGlobalTestEnvironment().
class OwnLoader final : public testing::Environment {
  public:
    explicit OwnLoader(PFN_vkGetInstanceProcAddr loader) : m_loader(loader) {}
    void SetUp() override { gpu::loadFunctions(m_loader); }

  private:
    PFN_vkGetInstanceProcAddr m_loader;
};

} // namespace cdr::test
