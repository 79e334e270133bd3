#pragma once

#include <cdr/gpu/device.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Visibility by atomics on 64-bit keys in place of a fixed depth test, for comparison alone.
/// @threads Functions depend on their arguments alone: any thread may call them, many at once.
namespace cdr::rivals {

/// What a fragment knows of its view distance.
enum class Distance : std::uint8_t {
    view,       ///< one float32, interpolated
    vertexPair, ///< two float32 of each vertex, interpolated one by one
    object, ///< two float32 of the object, the same in all of it, and an interpolated float32 offset from them
};

/// How a distance becomes a number that is compared.
enum class Key : std::uint8_t {
    log40,   ///< a logarithm of 40 bits, which leaves room for an id: one pass
    fixed64, ///< fixed point; ids in a second pass
    pair64,  ///< the bits of two float32, so no float64 is needed; ids in a second pass
};

/// A technique that no fixed depth test can do.
struct Rival {
    Distance distance = Distance::view; ///< what is compared
    Key key = Key::log40;               ///< by what
    /// A float32 depth buffer is drawn first, and what surely lies behind it costs no atomics.
    bool prepass = false;

    bool operator==(const Rival&) const = default;
};

/// A rival under the name it was asked for.
struct NamedRival {
    std::string name; ///< as it was asked for
    Rival rival;      ///< that it stands for
};

/// Those that have names, without a prepass: atomic-log, two-float, atomic-log-object, atomic-fixed, object-anchors.
/// @lifetime The program's.
std::span<const NamedRival> namedRivals();

/// A name of these, "/prepass" behind it for one with a prepass.
/// @throws base::InputError with a suggestion for an unknown name.
NamedRival parseRival(std::string_view name);

/// The features of Vulkan that a rival needs, by their names.
/// @errors None.
std::vector<std::string> featuresOf(const Rival& rival);

/// Those of featuresOf() that a device lacks, and the depth buffer of a prepass.
/// @errors None.
std::vector<std::string> missingFeatures(const gpu::DeviceInfo& device, const Rival& rival);

/// @throws base::InputError that names the device and what it lacks.
void requireFeatures(const gpu::DeviceInfo& device, const Rival& rival);

/// How often every draw is drawn.
/// @errors None.
std::uint32_t geometryPassesOf(const Rival& rival);

/// Of what decides visibility and of the ids.
/// @errors None.
std::uint32_t bytesPerPixelOf(const Rival& rival);

} // namespace cdr::rivals
