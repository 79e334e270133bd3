#pragma once

#include <cdr/depth/format.h>
#include <cdr/depth/mapping.h>
#include <cdr/depth/split.h>

#include <span>
#include <string>
#include <string_view>

namespace cdr::depth {

/// Mapping x split x depth format.
struct Technique {
    Mapping mapping = Mapping::standard;
    Split split = SplitNone{};
    DepthFormat format = DepthFormat::d32f;

    bool operator==(const Technique&) const = default;
};

/// A technique under the name it was asked for.
struct NamedTechnique {
    std::string name;
    Technique technique;
};

/// The named techniques: standard, cdr, log, logcdr (thesis), reversed (what the industry ships) and anchored
/// (ours), worst first. All have the format d32f.
std::span<const NamedTechnique> presets();

/// The preset with this mapping and split, in any format; else the parts.
std::string nameOf(const Technique& technique);

/// "mapping/split", such as "anchored-reversed/fitted".
std::string partsOf(const Technique& technique);

/// Reads a preset's name, or "mapping/split" with the format d32f.
/// base::InputError with a suggestion for an unknown name.
Technique parseTechnique(std::string_view name);

/// parseTechnique(), with the preset's name or the parts as the name, whichever was given.
NamedTechnique namedTechnique(std::string_view name);
/// The same, refused instead of thrown.
base::Result<NamedTechnique> tryNamedTechnique(std::string_view name);

} // namespace cdr::depth
