#pragma once

#include "inspect.h"

#include <cdr/depth/advice.h>

#include <cstdint>
#include <string>
#include <vector>

namespace cdr::experiments {

/// The scene's name of an object as one printable line, since a file may name it anything; or "object 12".
std::string nameOfObject(const scene::Scene& scene, std::uint32_t object);

/// "anchored with d32f".
std::string nameOf(const InspectedTechnique& technique);

/// What was found, one sentence per line. It names the simplest technique that suffices and the surfaces that are nearest to
/// each other. It names what no technique can separate, with the remedy.
std::vector<std::string> explain(const Inspection& inspection, const scene::Scene& scene,
                                 const depth::LengthText& lengthText = depth::plainLength);

} // namespace cdr::experiments
