#pragma once

#include <string>

namespace cdr::options {

// What help says of options that several commands declare. One wording for one meaning.

inline constexpr const char* kDeviceHelp =
    "Vulkan device, by its number or by part of its name; cdr devices lists them";
inline constexpr const char* kValidateHelp =
    "Enable the Khronos validation layer; any message from it is an error";
inline constexpr const char* kUnitHelp =
    "Unit for printed lengths: none (scene units), auto (a suitable one), um, mm, m or km. All but none are "
    "for scenes in metres";

inline constexpr const char* kFovHelp = "Vertical field of view in degrees, above 0 and below 180";
inline constexpr const char* kNearHelp = "Distance of the near plane from the camera, in scene units";
inline constexpr const char* kFarHelp = "Distance of the far plane from the camera, in scene units";

inline constexpr const char* kCameraHelp = "Camera of a glTF file's scene, by its index from 0";
inline constexpr const char* kAnimationHelp =
    "Animation of a glTF file, by its name or its index from 0; #N is the index N if another is named N";
inline constexpr const char* kTimeHelp = "Time in the animation, in seconds";
inline constexpr const char* kLightHelp =
    "Light of a glTF file: sky (computed), lamps (two lamps) or file (the file's own lights)";

inline constexpr const char* kSplitHelp =
    "How distances are divided into cascades: none, ratio:R (far / near of each), count:K (K of equal ratio), "
    "at:A,B,... (boundaries), minimax:K (K with the smallest depth step), or fitted[:TARGET[px][,max=K]] (to "
    "visible objects; TARGET is the largest depth step, in scene units or pixels)";
inline constexpr const char* kSurfaceHelp =
    "What the geometry pass stores of surfaces: gbuffer, visibility (which triangle), or lit (nothing: matt "
    "surfaces are shaded at once)";
inline constexpr const char* kTranslucencyMemoryHelp =
    "Memory for sorted fragments in MiB; frames that need more are drawn weighted";

/// "cubes, afc, ..., or a .gltf or .glb file".
std::string sceneHelp();
/// The presets, and how else a technique is named.
std::string techniqueHelp();
/// For --depth.
std::string mappingHelp();
/// For --shadow-texels.
std::string shadowTexelsHelp();

} // namespace cdr::options
