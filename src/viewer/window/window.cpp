#include "window.h"

#include <cdr/base/format_error.h>
#include <viewer/state/overloaded.h>

// vulkan.hpp stands above, so that GLFW declares its Vulkan functions.
#include <GLFW/glfw3.h>
#include <imgui_impl_glfw.h>

#include <cmath>

namespace cdr::viewer {

namespace {

std::string lastError() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? text : "no reason given";
}

} // namespace

WindowSystem::WindowSystem(const std::string& fallback) {
    if (glfwInit() != GLFW_TRUE) {
        throw base::runError("no window system ({}); without one, render with: {}", lastError(), fallback);
    }
    if (glfwVulkanSupported() != GLFW_TRUE) {
        glfwTerminate();
        throw base::RunError("the window system cannot show Vulkan; install a driver that can, such as "
                             "mesa-vulkan-drivers");
    }
}

WindowSystem::~WindowSystem() {
    glfwTerminate();
}

std::vector<const char*> WindowSystem::instanceExtensions() const {
    std::uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    return {names, names + count};
}

void WindowSystem::wake() {
    glfwPostEmptyEvent();
}

/// What GLFW calls. Each passes the event on to Dear ImGui's back end and keeps it for takeEvents().
struct Window::Callbacks {
    static Window& of(GLFWwindow* handle) { return *static_cast<Window*>(glfwGetWindowUserPointer(handle)); }

    static void key(GLFWwindow* handle, int key, int scancode, int action, int modifiers) {
        ImGui_ImplGlfw_KeyCallback(handle, key, scancode, action, modifiers);
        of(handle).m_events.emplace_back(KeyInput{.key = key,
                                                  .pressed = action != GLFW_RELEASE,
                                                  .repeated = action == GLFW_REPEAT,
                                                  .modifiers = modifiers});
    }
    static void character(GLFWwindow* handle, unsigned codepoint) {
        ImGui_ImplGlfw_CharCallback(handle, codepoint);
        of(handle).m_events.emplace_back(CharacterInput{codepoint});
    }
    static void button(GLFWwindow* handle, int button, int action, int modifiers) {
        ImGui_ImplGlfw_MouseButtonCallback(handle, button, action, modifiers);
        Window& window = of(handle);
        if (button >= 0 && static_cast<std::size_t>(button) < window.m_pointer.buttons.size()) {
            const auto index = static_cast<std::size_t>(button);
            window.m_pointer.buttons[index] = action == GLFW_PRESS;
            window.m_pointer.pressed[index] = window.m_pointer.pressed[index] || action == GLFW_PRESS;
        }
        window.m_events.emplace_back(ButtonInput{button, action == GLFW_PRESS, modifiers});
    }
    static void move(GLFWwindow* handle, double x, double y) {
#if IMGUI_VERSION_NUM >= 18700 // older back ends ask GLFW instead, see Interface::begin()
        ImGui_ImplGlfw_CursorPosCallback(handle, x, y);
#endif
        Window& window = of(handle);
        window.m_pointer.x = x;
        window.m_pointer.y = y;
        window.m_events.emplace_back(MoveInput{x, y});
    }
    static void enter(GLFWwindow* handle, int entered) {
        ImGui_ImplGlfw_CursorEnterCallback(handle, entered);
        if (entered == GLFW_FALSE) {
            of(handle).m_events.emplace_back(LeaveInput{});
        }
    }
    static void focus(GLFWwindow* handle, int focused) {
        ImGui_ImplGlfw_WindowFocusCallback(handle, focused);
    }
    static void scroll(GLFWwindow* handle, double x, double y) {
        ImGui_ImplGlfw_ScrollCallback(handle, x, y);
        of(handle).m_events.emplace_back(ScrollInput{x, y});
    }
    static void drop(GLFWwindow* handle, int count, const char** paths) {
        of(handle).m_events.emplace_back(DropInput{{paths, paths + count}});
    }
    static void resize(GLFWwindow* handle, int width, int height) {
        Window& window = of(handle);
        window.m_extent = vk::Extent2D{static_cast<std::uint32_t>(std::max(width, 0)),
                                       static_cast<std::uint32_t>(std::max(height, 0))};
        window.m_events.emplace_back(ResizeInput{width, height});
    }
};

void Window::Destroy::operator()(GLFWwindow* window) const {
    glfwDestroyWindow(window);
}

Window::Window(const WindowSystem&, const FirstSize& size, const std::string& title) {
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, size.isScaled ? GLFW_TRUE : GLFW_FALSE);
    m_handle.reset(glfwCreateWindow(static_cast<int>(size.width), static_cast<int>(size.height),
                                    title.c_str(), nullptr, nullptr));
    if (m_handle == nullptr) {
        throw base::runError("no window: {}", lastError());
    }
    GLFWwindow* window = m_handle.get();
    glfwSetWindowUserPointer(window, this);
    int pixelsWide = 0;
    int pixelsHigh = 0;
    glfwGetFramebufferSize(window, &pixelsWide, &pixelsHigh);
    m_extent = vk::Extent2D{static_cast<std::uint32_t>(pixelsWide), static_cast<std::uint32_t>(pixelsHigh)};
    glfwSetKeyCallback(window, Callbacks::key);
    glfwSetCharCallback(window, Callbacks::character);
    glfwSetMouseButtonCallback(window, Callbacks::button);
    glfwSetCursorPosCallback(window, Callbacks::move);
    glfwSetCursorEnterCallback(window, Callbacks::enter);
    glfwSetWindowFocusCallback(window, Callbacks::focus);
    glfwSetScrollCallback(window, Callbacks::scroll);
    glfwSetDropCallback(window, Callbacks::drop);
    glfwSetFramebufferSizeCallback(window, Callbacks::resize);
}

vk::UniqueSurfaceKHR Window::makeSurface(vk::Instance instance) const {
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    const auto result =
        static_cast<vk::Result>(glfwCreateWindowSurface(instance, m_handle.get(), nullptr, &surface));
    vk::resultCheck(result, "glfwCreateWindowSurface");
    return vk::UniqueSurfaceKHR(surface, instance);
}

void Window::wait(double seconds) const {
    glfwWaitEventsTimeout(seconds);
}

void Window::inject(const InputEvent& event) {
    GLFWwindow* window = m_handle.get();
    std::visit(
        Overloaded{
            [&](const KeyInput& key) {
                const int pressed = key.repeated ? GLFW_REPEAT : GLFW_PRESS;
                Callbacks::key(window, key.key, glfwGetKeyScancode(key.key),
                               key.pressed ? pressed : GLFW_RELEASE, key.modifiers);
            },
            [&](const CharacterInput& character) { Callbacks::character(window, character.codepoint); },
            [&](const ButtonInput& button) {
                Callbacks::button(window, button.button, button.pressed ? GLFW_PRESS : GLFW_RELEASE,
                                  button.modifiers);
            },
            [&](const MoveInput& move) { Callbacks::move(window, move.x, move.y); },
            [&](const LeaveInput&) { Callbacks::enter(window, GLFW_FALSE); },
            [&](const ScrollInput& scroll) { Callbacks::scroll(window, scroll.x, scroll.y); },
            [&](const DropInput& drop) {
                std::vector<std::string> texts(drop.paths.begin(), drop.paths.end());
                std::vector<const char*> paths;
                for (const std::string& text : texts) {
                    paths.push_back(text.c_str());
                }
                Callbacks::drop(window, static_cast<int>(paths.size()), paths.data());
            },
            [&](const ResizeInput& size) { Callbacks::resize(window, size.width, size.height); }},
        event);
}

bool Window::isClosing() const {
    return glfwWindowShouldClose(m_handle.get()) == GLFW_TRUE;
}

double Window::pixelsPerUnit() const {
    int width = 0;
    int height = 0;
    glfwGetWindowSize(m_handle.get(), &width, &height);
    int pixels = 0;
    glfwGetFramebufferSize(m_handle.get(), &pixels, &height);
    return width > 0 && pixels > 0 ? static_cast<double>(pixels) / width : 1.0;
}

double Window::textScale() const {
    float x = 1.0f;
    float y = 1.0f;
    glfwGetWindowContentScale(m_handle.get(), &x, &y);
    const double scale = std::max(x, y) / pixelsPerUnit();
    return std::isfinite(scale) && scale > 0.0 ? scale : 1.0;
}

void Window::resize(int width, int height) const {
    glfwSetWindowSize(m_handle.get(), width, height);
}

ResizeInput Window::currentSize() const {
    ResizeInput size;
    glfwGetFramebufferSize(m_handle.get(), &size.width, &size.height);
    return size;
}

void Window::minimise() const {
    glfwIconifyWindow(m_handle.get());
}

void Window::hide() const {
    glfwHideWindow(m_handle.get());
    glfwPollEvents();
}

void Window::restore() const {
    glfwRestoreWindow(m_handle.get());
}

void Window::copyToClipboard(const std::string& text) const {
    glfwSetClipboardString(m_handle.get(), text.c_str());
}

} // namespace cdr::viewer
