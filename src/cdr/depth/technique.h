#pragma once

/// @file
/// @errors None but those that a function names.

#include <cdr/base/export.h>
#include <cdr/depth/format.h>
#include <cdr/depth/mapping.h>
#include <cdr/depth/split.h>

#include <span>
#include <string>
#include <string_view>

/// Depth mappings, cascades, splits and forecasts: pure float64 functions without Vulkan.
/// @threads Functions depend on their arguments alone: any thread may call them, many at once.
namespace cdr::depth {

/// Mapping x split x depth format.
struct Technique {
    Mapping mapping = Mapping::standard;    ///< of view distance to depth
    Split split = SplitNone{};              ///< of the camera's range into cascades
    DepthFormat format = DepthFormat::d32f; ///< of the depth buffer

    bool operator==(const Technique&) const = default;
};

/// A technique under the name it was asked for.
struct NamedTechnique {
    std::string name;    ///< as it was asked for
    Technique technique; ///< that it stands for
};

/// The named techniques: standard, cdr, log, logcdr (thesis), reversed (what the industry ships) and anchored
/// (ours), worst first. All have the format d32f. The order is that of most scenes: where a picture spans many decades and
/// gaps are smaller than the target of SplitFitted, reversed can resolve more than anchored.
/// @lifetime The program's.
CDR_EXPORT std::span<const NamedTechnique> presets();

/// Where the last cascade of a split ends. Fitted ones are as thin as their content, so none may be open to infinity.
inline FarEnd farEndOf(const Split& split) {
    return std::holds_alternative<SplitFitted>(split) ? FarEnd::closed : FarEnd::open;
}

/// The preset with this mapping and split, in any format; else the parts.
CDR_EXPORT std::string nameOf(const Technique& technique);

/// "mapping/split", such as "anchored-reversed/fitted".
CDR_EXPORT std::string partsOf(const Technique& technique);

/// Reads a preset's name, or "mapping/split" with the format d32f.
/// @throws base::InputError with a suggestion for an unknown name.
CDR_EXPORT Technique parseTechnique(std::string_view name);
/// The same, refused instead of thrown.
CDR_EXPORT base::Result<Technique> tryParseTechnique(std::string_view name);

/// parseTechnique(), with the preset's name or the parts as the name, whichever was given.
/// @throws base::InputError as parseTechnique().
CDR_EXPORT NamedTechnique namedTechnique(std::string_view name);
/// namedTechnique(), refused instead of thrown.
CDR_EXPORT base::Result<NamedTechnique> tryNamedTechnique(std::string_view name);

} // namespace cdr::depth
