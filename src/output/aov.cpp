#include "aov.h"

#include <cdr/base/enum_names.h>
#include <cdr/base/error.h>
#include <cdr/image/compose.h>
#include <cdr/image/srgb.h>
#include <cdr/measure/compare/wrong_pixels.h>

#include <program/sha256.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>

namespace cdr::output {

namespace {

constexpr base::EnumNames<Aov, 8> kAovNames{
    "output", {"color", "linear", "id", "distance", "normal", "cascade", "wrong", "coverage"}};

/// Tints that most people can distinguish (Okabe and Ito 2008), repeated beyond eight cascades.
constexpr std::array<std::array<float, 3>, 8> kTints{{{0.90f, 0.62f, 0.00f},
                                                      {0.34f, 0.71f, 0.91f},
                                                      {0.00f, 0.62f, 0.45f},
                                                      {0.94f, 0.89f, 0.26f},
                                                      {0.00f, 0.45f, 0.70f},
                                                      {0.84f, 0.37f, 0.00f},
                                                      {0.80f, 0.47f, 0.65f},
                                                      {0.75f, 0.75f, 0.75f}}};

std::uint8_t toByte(double unit) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(unit, 0.0, 1.0)));
}

/// A picture, pixel by pixel.
image::ImageRgba8 paint(const render::Frame& frame,
                        const std::function<image::Rgba8(std::uint32_t x, std::uint32_t y)>& pixel) {
    return image::rasterOf<image::Rgba8>(frame.width(), frame.height(), pixel);
}

/// A float image, pixel by pixel.
image::ImageFloat values(const render::Frame& frame,
                         const std::function<double(std::uint32_t x, std::uint32_t y)>& value) {
    return image::rasterOf<float>(frame.width(), frame.height(),
                                  [&](auto x, auto y) { return static_cast<float>(value(x, y)); });
}

image::ImageRgba8 linearPicture(const render::Frame& frame) {
    return paint(frame, [&](auto x, auto y) -> image::Rgba8 {
        const glm::dvec3 light(frame.linear.at(x, y));
        return {image::srgbOfLinear(light.r), image::srgbOfLinear(light.g), image::srgbOfLinear(light.b),
                255};
    });
}

image::ImageRgba8 idPicture(const render::Frame& frame) {
    return paint(frame, [&](auto x, auto y) -> image::Rgba8 {
        const std::uint32_t id = frame.id(x, y);
        return {static_cast<std::uint8_t>(id), static_cast<std::uint8_t>(id >> 8),
                static_cast<std::uint8_t>(id >> 16), 255};
    });
}

image::ImageRgba8 distancePicture(const render::Frame& frame) {
    double low = std::numeric_limits<double>::infinity();
    double high = 0.0;
    for (std::uint32_t y = 0; y < frame.height(); ++y) {
        for (std::uint32_t x = 0; x < frame.width(); ++x) {
            const double w = frame.distanceView(x, y);
            if (std::isfinite(w)) {
                low = std::min(low, w);
                high = std::max(high, w);
            }
        }
    }
    const double span = std::max(std::log(high / low), 1e-12);
    return paint(frame, [&](auto x, auto y) -> image::Rgba8 {
        const double w = frame.distanceView(x, y);
        const std::uint8_t grey =
            std::isfinite(w) ? toByte(1.0 - 0.9 * std::log(w / low) / span) : std::uint8_t{0};
        return {grey, grey, grey, 255};
    });
}

/// What a float32 leaves out of a float64; 0 for infinity.
double restOf(double value) {
    return std::isfinite(value) ? value - static_cast<double>(static_cast<float>(value)) : 0.0;
}

image::ImageRgba8 normalPicture(const render::Frame& frame) {
    return paint(frame, [&](auto x, auto y) -> image::Rgba8 {
        const glm::dvec3 n(frame.normalView(x, y));
        return {toByte(0.5 + 0.5 * n.x), toByte(0.5 + 0.5 * n.y), toByte(0.5 + 0.5 * n.z), 255};
    });
}

image::ImageRgba8 cascadePicture(const render::Frame& frame) {
    return paint(frame, [&](auto x, auto y) -> image::Rgba8 {
        if (frame.id(x, y) == 0) {
            return {0, 0, 0, 255};
        }
        const image::Rgba8& color = frame.color.at(x, y);
        return cascadeTint(frame.cascade(x, y), std::max({color[0], color[1], color[2]}));
    });
}

image::ImageRgba8 wrongPicture(const render::Frame& frame, const measure::TruthImage* truth) {
    if (truth == nullptr) {
        throw base::RunError("the wrong-pixel picture needs the truth");
    }
    return measure::heatMap(frame.ids(), *truth, frame.color);
}

/// Translucent surfaces at a pixel; none if the scene has none, or they were not counted.
std::uint32_t coverageAt(const render::Frame& frame, std::uint32_t x, std::uint32_t y) {
    return frame.fragmentCounts.pixels.empty() ? 0 : frame.fragmentCounts.at(x, y);
}

std::string hashOfCoverage(const render::Frame& frame) {
    return frame.fragmentCounts.pixels.empty()
               ? program::sha256Of(std::vector<std::uint32_t>(std::size_t{frame.width()} * frame.height()))
               : program::sha256Of(frame.fragmentCounts.pixels);
}

image::ImageRgba8 coveragePicture(const render::Frame& frame) {
    return paint(frame, [&](auto x, auto y) -> image::Rgba8 {
        const auto grey = static_cast<std::uint8_t>(std::min(16u * coverageAt(frame, x, y), 255u));
        return {grey, grey, grey, 255};
    });
}

std::vector<image::ExrChannel> colorChannels(const render::Frame& frame, const image::ImageRgba8& picture) {
    std::vector<image::ExrChannel> channels;
    for (std::size_t c = 0; c < 3; ++c) {
        // EXR holds linear light.
        channels.push_back({std::string(1, "RGB"[c]), values(frame, [&](auto x, auto y) {
                                return image::linearOfSrgb()[picture.at(x, y)[c]];
                            })});
    }
    return channels;
}

std::vector<image::ExrChannel> linearChannels(const render::Frame& frame) {
    return {{"R", values(frame, [&](auto x, auto y) { return frame.linear.at(x, y).r; })},
            {"G", values(frame, [&](auto x, auto y) { return frame.linear.at(x, y).g; })},
            {"B", values(frame, [&](auto x, auto y) { return frame.linear.at(x, y).b; })}};
}

/// SHA-256 of one word of each pixel's surface.
std::string hashOfWords(const render::Frame& frame, std::uint32_t (*word)(const render::GBufferPixel&)) {
    std::vector<std::uint32_t> words(frame.gbuffer.pixels.size());
    std::transform(frame.gbuffer.pixels.begin(), frame.gbuffer.pixels.end(), words.begin(), word);
    return program::sha256Of(words);
}

} // namespace

std::string_view nameOf(Aov aov) {
    return kAovNames.nameOf(aov);
}

Aov parseAov(std::string_view name) {
    return kAovNames.parse(name);
}

image::Rgba8 cascadeTint(std::size_t cascade, std::uint8_t light) {
    const double share = 0.3 + 0.7 * light / 255.0;
    const auto& tint = kTints[cascade % kTints.size()];
    return {toByte(share * static_cast<double>(tint[0])), toByte(share * static_cast<double>(tint[1])),
            toByte(share * static_cast<double>(tint[2])), 255};
}

image::ImageRgba8 pictureOf(const render::Frame& frame, Aov aov, const measure::TruthImage* truth) {
    switch (aov) {
    case Aov::color:
        return frame.color;
    case Aov::linear:
        return linearPicture(frame);
    case Aov::id:
        return idPicture(frame);
    case Aov::distance:
        return distancePicture(frame);
    case Aov::normal:
        return normalPicture(frame);
    case Aov::cascade:
        return cascadePicture(frame);
    case Aov::wrong:
        return wrongPicture(frame, truth);
    case Aov::coverage:
        return coveragePicture(frame);
    }
    throw base::RunError("output out of range");
}

std::vector<image::ExrChannel> channelsOf(const render::Frame& frame, Aov aov,
                                          const measure::TruthImage* truth) {
    switch (aov) {
    case Aov::color:
    case Aov::wrong:
        return colorChannels(frame, pictureOf(frame, aov, truth));
    case Aov::linear:
        return linearChannels(frame);
    case Aov::id:
        return {{"id", values(frame, [&](auto x, auto y) { return frame.id(x, y); })}};
    case Aov::cascade:
        return {{"cascade", values(frame, [&](auto x, auto y) { return frame.cascade(x, y); })}};
    case Aov::distance:
        return {{"ahead", values(frame, [&](auto x, auto y) { return frame.gbuffer.at(x, y).ahead; })},
                {"distance", values(frame, [&](auto x, auto y) { return frame.distanceView(x, y); })},
                {"distanceRest",
                 values(frame, [&](auto x, auto y) { return restOf(frame.distanceView(x, y)); })}};
    case Aov::normal:
        return {{"X", values(frame, [&](auto x, auto y) { return frame.normalView(x, y).x; })},
                {"Y", values(frame, [&](auto x, auto y) { return frame.normalView(x, y).y; })},
                {"Z", values(frame, [&](auto x, auto y) { return frame.normalView(x, y).z; })}};
    case Aov::coverage:
        return {{"coverage", values(frame, [&](auto x, auto y) { return coverageAt(frame, x, y); })}};
    }
    throw base::RunError("output out of range");
}

std::string hashOf(const render::Frame& frame, Aov aov, const measure::TruthImage* truth) {
    switch (aov) {
    case Aov::color:
        return program::sha256Of(frame.color.pixels);
    case Aov::linear:
        return program::sha256Of(frame.linear.pixels);
    case Aov::wrong:
        return program::sha256Of(wrongPicture(frame, truth).pixels);
    case Aov::id:
        return program::sha256Of(frame.ids().pixels);
    case Aov::distance:
        return hashOfWords(frame, [](const render::GBufferPixel& pixel) {
            return std::bit_cast<std::uint32_t>(pixel.ahead);
        });
    case Aov::normal:
        return hashOfWords(frame, [](const render::GBufferPixel& pixel) { return pixel.normal; });
    case Aov::cascade:
        return hashOfWords(frame, [](const render::GBufferPixel& pixel) { return pixel.idAndCascade; });
    case Aov::coverage:
        return hashOfCoverage(frame);
    }
    throw base::RunError("output out of range");
}

std::string hashOf(const render::Frame& frame) {
    return program::sha256Of(program::sha256Of(frame.color.pixels) + program::sha256Of(frame.gbuffer.pixels));
}

} // namespace cdr::output
