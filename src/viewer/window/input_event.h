#pragma once

#include <filesystem>
#include <variant>
#include <vector>

namespace cdr::viewer {

// What a person does to the window, in GLFW's terms: key and button codes, and screen coordinates from the
// window's top left corner.

struct KeyInput {
    int key = 0;
    bool pressed = false;
    bool repeated = false;
    int modifiers = 0;
};
struct CharacterInput {
    unsigned codepoint = 0;
};
struct ButtonInput {
    int button = 0;
    bool pressed = false;
    int modifiers = 0;
};
struct MoveInput {
    double x = 0.0;
    double y = 0.0;
};
/// The pointer is no longer over the window.
struct LeaveInput {};
struct ScrollInput {
    double x = 0.0;
    double y = 0.0;
};
struct DropInput {
    std::vector<std::filesystem::path> paths;
};
/// The picture area in pixels; 0x0 while the window is minimised.
struct ResizeInput {
    int width = 0;
    int height = 0;
};

using InputEvent = std::variant<KeyInput, CharacterInput, ButtonInput, MoveInput, LeaveInput, ScrollInput,
                                DropInput, ResizeInput>;

} // namespace cdr::viewer
