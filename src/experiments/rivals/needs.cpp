#include "needs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cdr::experiments {

RivalNeeds needsOf(const std::string& name, const rivals::Competing& competing) {
    if (const auto* rival = std::get_if<rivals::Rival>(&competing)) {
        return {.contender = name,
                .geometryPasses = rivals::geometryPassesOf(*rival),
                .bytesPerPixel = rivals::bytesPerPixelOf(*rival),
                .features = rivals::featuresOf(*rival)};
    }
    const auto& technique = std::get<depth::Technique>(competing);
    const auto depthBits = static_cast<std::uint32_t>(depth::traitsOf(technique.format).bits);
    return {.contender = name,
            .geometryPasses = 1,
            // An attachment of 24 bits takes 4 bytes.
            .bytesPerPixel = 8 + (depthBits <= 16 ? 2u : 4u),
            .features = {}};
}

output::Columns<RivalNeeds> rivalNeedsColumns() {
    using Result = RivalNeeds;
    return {
        {.key = "technique", .value = &Result::contender, .heading = "technique"},
        {.key = "geometry_passes", .value = &Result::geometryPasses, .heading = "geometry passes"},
        {.key = "bytes_per_pixel", .value = &Result::bytesPerPixel, .heading = "bytes a pixel"},
        {.key = "features",
         .value = &Result::features,
         .heading = "features beyond those of cdr",
         .text = [](const Result& result) { return fmt::format("{}", fmt::join(result.features, ", ")); }}};
}

} // namespace cdr::experiments
