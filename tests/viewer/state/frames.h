#pragma once

#include <cdr/render/frame.h>
#include <cdr/shaders/shared.h>

#include <cstdint>
#include <functional>

namespace cdr::viewer_test {

/// What a pixel of a made-up frame holds.
struct MadePixel {
    std::uint32_t id = 0;
    std::uint32_t cascade = 0;
    float ahead = 0.0f;
};

/// A frame as if rendered: two cascades, anchored at 1 and 1000.
inline render::Frame makeFrame(std::uint32_t width, std::uint32_t height,
                               const std::function<MadePixel(std::uint32_t x, std::uint32_t y)>& pixel) {
    render::Frame frame;
    frame.cascades = {{1.0, 100.0}, {1000.0, 1e5}};
    frame.anchorsView = {1.0, 1000.0};
    frame.color = image::ImageRgba8(width, height);
    frame.gbuffer = image::Raster<render::GBufferPixel>(width, height);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const MadePixel made = pixel(x, y);
            frame.gbuffer.at(x, y) = {.albedo = 0,
                                      .normal = 0,
                                      .ahead = made.ahead,
                                      .idAndCascade = made.id | made.cascade << shaders::kIdBits};
            frame.color.at(x, y) = {static_cast<std::uint8_t>(x * 7 + y), static_cast<std::uint8_t>(y * 5),
                                    static_cast<std::uint8_t>(x ^ y), 255};
        }
    }
    return frame;
}

} // namespace cdr::viewer_test
