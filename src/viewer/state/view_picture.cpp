#include "view_picture.h"

#include "picture_parts.h"

#include <cdr/base/error.h>

#include <output/aov.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace cdr::viewer {

namespace {

constexpr image::Rgba8 kBlack{0, 0, 0, 255};

/// output::cascadeTint() at every lightness.
struct TintTable {
    std::array<std::array<image::Rgba8, 256>, depth::kMaxCascades> at;

    TintTable() : at{} {
        for (std::size_t cascade = 0; cascade < at.size(); ++cascade) {
            for (std::size_t light = 0; light < 256; ++light) {
                at[cascade][light] = output::cascadeTint(cascade, static_cast<std::uint8_t>(light));
            }
        }
    }
};

const TintTable& tints() {
    static const TintTable kTable;
    return kTable;
}

void paintCascades(const render::Frame& frame, image::ImageRgba8& picture) {
    const TintTable& table = tints();
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const render::GBufferPixel& pixel = frame.gbuffer.pixels[i];
        const image::Rgba8& color = frame.color.pixels[i];
        const std::uint8_t light = std::max({color[0], color[1], color[2]});
        picture.pixels[i] = pixel.id() == 0 ? kBlack : table.at[pixel.cascade() % depth::kMaxCascades][light];
    }
}

/// Natural logarithm of a normal positive float to 1e-6: enough for 256 greys, and a tenth of std::log's
/// time.
float quickLog(float x) {
    const auto bits = std::bit_cast<std::uint32_t>(x);
    // Exponent counted so that the mantissa lies about 1.
    const auto exponent = static_cast<std::int32_t>(bits - 0x3f3504f3u) >> 23;
    const float mantissa = std::bit_cast<float>(bits - (static_cast<std::uint32_t>(exponent) << 23));
    const float s = (mantissa - 1.0f) / (mantissa + 1.0f);
    const float s2 = s * s;
    return 0.6931472f * static_cast<float>(exponent) +
           2.0f * s * (1.0f + s2 * (1.0f / 3.0f + s2 * (0.2f + s2 / 7.0f)));
}

/// ln(1 + x) for x from 0 on. Near 0, where x + 1 would round, by its series.
float quickLog1p(double x) {
    if (x < 0.03) {
        return static_cast<float>(x * (1.0 - x * (0.5 - x * (1.0 / 3.0 - x * 0.25))));
    }
    return quickLog(static_cast<float>(1.0 + std::min(x, 1e30)));
}

struct DistanceSpan {
    double low = std::numeric_limits<double>::infinity();
    double high = 0.0;
};

DistanceSpan spanOf(const render::Frame& frame) {
    DistanceSpan span;
    for (const render::GBufferPixel& pixel : frame.gbuffer.pixels) {
        if (pixel.id() != 0) {
            const double w = frame.distanceView(pixel);
            span.low = std::min(span.low, w);
            span.high = std::max(span.high, w);
        }
    }
    return span;
}

void paintDistance(const render::Frame& frame, image::ImageRgba8& picture) {
    const DistanceSpan span = spanOf(frame);
    const double perLow = 1.0 / span.low;
    const float spread = std::max(quickLog1p((span.high - span.low) * perLow), 1e-30f);
    const float scale = -0.9f * 255.0f / spread;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const render::GBufferPixel& pixel = frame.gbuffer.pixels[i];
        if (pixel.id() == 0) {
            picture.pixels[i] = kBlack;
            continue;
        }
        const float beyond = quickLog1p((frame.distanceView(pixel) - span.low) * perLow);
        const auto grey = static_cast<std::uint8_t>(255.5f + scale * std::min(beyond, spread));
        picture.pixels[i] = {grey, grey, grey, 255};
    }
}

void paintIds(const render::Frame& frame, image::ImageRgba8& picture) {
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        picture.pixels[i] = idColor(frame.gbuffer.pixels[i].id());
    }
}

} // namespace

image::Rgba8 cascadeColor(std::size_t cascade) {
    return output::cascadeTint(cascade, 255);
}

image::Rgba8 idColor(std::uint32_t id) {
    if (id == 0) {
        return kBlack;
    }
    // Mixes all bits of the id into each channel (the finaliser of MurmurHash3, Appleby 2011).
    std::uint32_t h = id;
    h = (h ^ (h >> 16)) * 0x85ebca6bu;
    h = (h ^ (h >> 13)) * 0xc2b2ae35u;
    h ^= h >> 16;
    const auto channel = [&](unsigned shift) {
        return static_cast<std::uint8_t>(48u + ((h >> shift) & 0xffu) * 207u / 255u);
    };
    return {channel(0), channel(8), channel(16), 255};
}

void paintView(const render::Frame& frame, ViewKind view, image::ImageRgba8& picture) {
    if (needsReference(view)) {
        throw base::InputError("this view compares with another frame");
    }
    resize(picture, frame.width(), frame.height());
    switch (view) {
    case ViewKind::cascades:
        return paintCascades(frame, picture);
    case ViewKind::distance:
        return paintDistance(frame, picture);
    case ViewKind::ids:
        return paintIds(frame, picture);
    default:
        picture.pixels.assign(frame.color.pixels.begin(), frame.color.pixels.end());
    }
}

} // namespace cdr::viewer
