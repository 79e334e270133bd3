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
    std::string name; ///< a preset's, or "mapping/split"
    Mapping mapping = Mapping::standard;
    Split split = SplitNone{};
    DepthFormat format = DepthFormat::d32f;
};

/// The named techniques: standard, cdr, log, logcdr (thesis), reversed (what the industry ships) and anchored
/// (ours), worst first.
std::span<const Technique> presets();

/// The preset of that name, or for "mapping/split", such as "anchored-reversed/fitted", that technique with
/// d32f. base::InputError with a suggestion for an unknown name.
Technique parseTechnique(std::string_view name);

/// A technique put together by hand, named after its parts.
Technique makeTechnique(Mapping mapping, Split split, DepthFormat format);

} // namespace cdr::depth
