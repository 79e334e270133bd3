// The viewer's views of a frame at 1280x720, each by itself. Target: 5 ms each on one thread.

#include <cdr/shaders/shared.h>
#include <viewer/state/flip_window.h>
#include <viewer/state/split_picture.h>
#include <viewer/state/view_picture.h>
#include <viewer/state/wrong_view.h>

#include <benchmark/benchmark.h>

#include <cstdint>
#include <random>

namespace {

using namespace cdr;

/// Objects of 40x40 pixels in four cascades; one pixel in `wrongEvery` shows another object.
render::Frame makeFrame(unsigned wrongEvery) {
    constexpr std::uint32_t kWidth = 1280;
    constexpr std::uint32_t kHeight = 720;
    render::Frame frame;
    frame.cascades = {{1.0, 10.0}, {10.0, 1e3}, {1e3, 1e5}, {1e5, 1e7}};
    frame.anchorsView = {1.0, 10.0, 1e3, 1e5};
    frame.color = image::ImageRgba8(kWidth, kHeight);
    frame.gbuffer = image::Raster<render::GBufferPixel>(kWidth, kHeight);
    std::mt19937 random(wrongEvery);
    for (std::uint32_t y = 0; y < kHeight; ++y) {
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            const auto bits = static_cast<std::uint32_t>(random());
            const std::uint32_t id = 1 + (x / 40) + 32 * (y / 40) + (bits % wrongEvery == 0 ? 1000u : 0u);
            frame.gbuffer.at(x, y) = {.albedo = bits,
                                      .normal = bits,
                                      .ahead = static_cast<float>(bits) * 1e-4f,
                                      .idAndCascade = id | (id % 4) << shaders::kIdBits};
            frame.color.at(x, y) = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
                                    static_cast<std::uint8_t>(bits >> 16), 255};
        }
    }
    return frame;
}

const render::Frame& shown() {
    static const render::Frame kFrame = makeFrame(7);
    return kFrame;
}
const render::Frame& reference() {
    static const render::Frame kFrame = makeFrame(1u << 30);
    return kFrame;
}

void viewOf(benchmark::State& state) {
    const auto view = static_cast<viewer::ViewKind>(state.range(0));
    image::ImageRgba8 picture;
    for (auto step : state) {
        viewer::paintView(shown(), view, picture);
        benchmark::DoNotOptimize(picture.pixels.data());
    }
    state.SetLabel(std::string(viewer::nameOf(view)));
}
BENCHMARK(viewOf)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

void wrong(benchmark::State& state) {
    image::ImageRgba8 picture;
    for (auto step : state) {
        benchmark::DoNotOptimize(viewer::paintWrong(shown(), reference(), picture));
    }
}
BENCHMARK(wrong)->Unit(benchmark::kMillisecond);

void flips(benchmark::State& state) {
    viewer::FlipWindow window;
    image::ImageRgba8 picture;
    double seconds = 0.0;
    bool odd = false;
    for (auto step : state) {
        window.add(odd ? shown() : reference(), reference(), seconds += 0.03);
        window.paint(shown(), picture);
        odd = !odd;
        benchmark::DoNotOptimize(picture.pixels.data());
    }
}
BENCHMARK(flips)->Unit(benchmark::kMillisecond);

void split(benchmark::State& state) {
    image::ImageRgba8 picture;
    for (auto step : state) {
        viewer::composeSplit(shown().color, reference().color, 0.4, picture);
        benchmark::DoNotOptimize(picture.pixels.data());
    }
}
BENCHMARK(split)->Unit(benchmark::kMillisecond);

} // namespace
