#include "interface.h"

#include "style.h"
#include "thumbnails.h"

#include <cdr/gpu/commands.h>

#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_vulkan.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace cdr::viewer {

namespace {

constexpr float kTextHeight = 15.0f; ///< at 96 dots per inch

void checkResult(VkResult result) {
    if (result < 0) {
        vk::resultCheck(static_cast<vk::Result>(result), "the interface");
    }
}

ImGui_ImplVulkan_InitInfo initInfo(const UiDevice& ui, vk::DescriptorPool pool) {
    ImGui_ImplVulkan_InitInfo info{};
    info.Instance = ui.instance().handle();
    info.PhysicalDevice = ui.device().physical();
    info.Device = ui.device().handle();
    info.QueueFamily = ui.device().queueFamily();
    info.Queue = ui.device().queue();
    info.DescriptorPool = pool;
    info.MinImageCount = 2;
    info.ImageCount = Presenter::kFramesInFlight + 1; // buffers it takes in turn
    info.CheckVkResultFn = checkResult;
#if IMGUI_VERSION_NUM >= 19200
    info.ApiVersion = VK_API_VERSION_1_3;
#endif
    return info;
}

void initVulkan(ImGui_ImplVulkan_InitInfo info, vk::RenderPass renderPass) {
#if IMGUI_VERSION_NUM >= 19240
    info.PipelineInfoMain.RenderPass = renderPass;
    ImGui_ImplVulkan_Init(&info);
#elif IMGUI_VERSION_NUM >= 19030
    info.RenderPass = renderPass;
    ImGui_ImplVulkan_Init(&info);
#else
    ImGui_ImplVulkan_Init(&info, renderPass);
#endif
}

} // namespace

Interface::Interface(const UiDevice& ui, Window& window, const Presenter& presenter, double scale)
    : m_device(ui.device()),
      m_window(window),
      m_scale(static_cast<float>(scale > 0.0 ? scale : window.textScale())) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // layout is ours, nothing is left behind
    io.LogFilename = nullptr;
    applyStyle(m_scale);
    reserveThumbnails(*io.Fonts);
    loadFont();
    copyThumbnails(*io.Fonts);
    constexpr std::uint32_t kSets = 8;
    const vk::DescriptorPoolSize size{vk::DescriptorType::eCombinedImageSampler, kSets};
    // Back ends since 1.89 give their sets back one by one.
    m_descriptors =
        vk::Device(m_device.handle())
            .createDescriptorPoolUnique({.flags = vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet,
                                         .maxSets = kSets,
                                         .poolSizeCount = 1,
                                         .pPoolSizes = &size});
    ImGui_ImplGlfw_InitForVulkan(window.handle(), false);
    initVulkan(initInfo(ui, *m_descriptors), presenter.renderPass());
    uploadFont();
}

Interface::~Interface() {
    try {
        vk::Device(m_device.handle()).waitIdle(); // frames in flight read what goes now
    } catch (const vk::Error&) {
        // Reported where somebody waits for a frame.
    }
}

Interface::Context::Context() {
    ImGui::CreateContext();
}

Interface::Context::~Context() {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.BackendRendererUserData != nullptr) {
        ImGui_ImplVulkan_Shutdown();
    }
    if (io.BackendPlatformUserData != nullptr) {
        ImGui_ImplGlfw_Shutdown();
    }
    ImGui::DestroyContext();
}

void Interface::loadFont() const {
    ImGuiIO& io = ImGui::GetIO();
    const auto pixelsPerUnit = static_cast<float>(m_window.pixelsPerUnit());
    const float pixels = std::round(kTextHeight * m_scale * pixelsPerUnit);
    // Drawn at the display's pixels, laid out in screen coordinates. It keeps its size there if the display changes.
    io.FontGlobalScale = 1.0f / pixelsPerUnit;
#ifdef CDR_VIEWER_FONT
    // Latin, Greek and Cyrillic letters, as names have them, and the signs of our own text.
    static constexpr ImWchar kGlyphs[] = {0x20,   0x17f,  0x370,  0x52f,  0x2013, 0x2026, 0x2070, 0x207b,
                                          0x2190, 0x2193, 0x2212, 0x2212, 0x2264, 0x2265, 0};
    if (std::filesystem::is_regular_file(CDR_VIEWER_FONT) &&
        io.Fonts->AddFontFromFileTTF(CDR_VIEWER_FONT, pixels, nullptr, kGlyphs) != nullptr) {
        return;
    }
#endif
    ImFontConfig config;
    config.SizePixels = std::round(pixels * 13.0f / kTextHeight);
    io.Fonts->AddFontDefault(&config);
}

void Interface::uploadFont() const {
#if IMGUI_VERSION_NUM < 19000
    gpu::runOnce(m_device, [](vk::CommandBuffer commands) { ImGui_ImplVulkan_CreateFontsTexture(commands); });
    ImGui_ImplVulkan_DestroyFontUploadObjects();
#endif // newer back ends upload when they first need it
}

void Interface::begin(double seconds, ArrowKeys keys) {
    ImGui_ImplVulkan_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGuiIO& io = ImGui::GetIO();
    io.ConfigFlags = keys == ArrowKeys::choose ? ImGuiConfigFlags_NavEnableKeyboard : ImGuiConfigFlags_None;
    io.DeltaTime = static_cast<float>(std::clamp(seconds, 1e-4, 1.0));
    // The window's size as the callbacks told it, so that injected sizes count too.
    const vk::Extent2D extent = m_window.extent();
    const auto pixelsPerUnit = static_cast<float>(m_window.pixelsPerUnit()); // another one on another display
    io.DisplaySize = {static_cast<float>(extent.width) / pixelsPerUnit,
                      static_cast<float>(extent.height) / pixelsPerUnit};
    io.DisplayFramebufferScale = {pixelsPerUnit, pixelsPerUnit};
#if IMGUI_VERSION_NUM < 18700 // asks GLFW for the pointer, which knows nothing of injected input
    const Pointer& pointer = m_window.pointer();
    io.MousePos = {static_cast<float>(pointer.x), static_cast<float>(pointer.y)};
    for (std::size_t button = 0; button < pointer.buttons.size(); ++button) {
        io.MouseDown[button] =
            pointer.buttons[button] || pointer.pressed[button]; // a click within one frame too
    }
    m_window.forgetPresses();
#endif
    ImGui::NewFrame();
}

ImDrawData* Interface::end() {
    ImGui::Render();
    return ImGui::GetDrawData();
}

bool Interface::wantsPointer() const {
    return ImGui::GetIO().WantCaptureMouse;
}

bool Interface::wantsKeys() const {
    return ImGui::GetIO().WantTextInput;
}

bool Interface::wantsEscape() const {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup) || ImGui::IsAnyItemActive();
}

} // namespace cdr::viewer
