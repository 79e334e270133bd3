#pragma once

#include <scenes/orbit/data.h>

#include <cstdint>

namespace cdr::test {

/// Maps of an Earth for tests that must run without the real ones: green, heights from 0 to 3 km at random.
inline scenes::EarthMaps syntheticEarth() {
    scenes::EarthMaps maps{.color = image::ImageRgba8(16, 8, {60, 90, 40, 255}),
                           .topography = image::ImageRgba8(256, 128)};
    std::uint32_t state = 1;
    for (image::Rgba8& pixel : maps.topography.pixels) {
        state = state * 1664525u + 1013904223u;
        const auto grey = static_cast<std::uint8_t>((state >> 24) % 120);
        pixel = {grey, grey, grey, 255};
    }
    return maps;
}

} // namespace cdr::test
