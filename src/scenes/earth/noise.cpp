#include <scenes/earth/noise.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cdr::scenes {

namespace {

/// A part of a cell's number: the same for a whole column or row.
std::uint64_t columnPart(std::int64_t column) {
    return static_cast<std::uint64_t>(column) * 0x8da6b343d8163841u;
}
std::uint64_t rowPart(std::int64_t row, std::uint32_t seed) {
    return (static_cast<std::uint64_t>(row) + seed * std::uint64_t{0x9e3779b9}) * 0xcb1ab31f5bd1e995u;
}

/// 32 even bits of two parts (a step of SplitMix, Steele and others 2014).
double numberOf(std::uint64_t column, std::uint64_t row) {
    std::uint64_t x = column ^ row;
    x = (x ^ (x >> 29)) * 0xbf58476d1ce4e5b9u;
    return static_cast<double>(static_cast<std::int64_t>(x >> 32)) * 0x1p-32;
}

/// The numbers of the corners of a cell as a twisted plane, a + b s + c t + d s t: -1 to 1.
struct CellSurface {
    double a;
    double b;
    double c;
    double d;
};

CellSurface surfaceOf(std::int64_t x, std::int64_t y, std::uint32_t seed) {
    const std::uint64_t left = columnPart(x);
    const std::uint64_t right = columnPart(x + 1);
    const std::uint64_t top = rowPart(y, seed);
    const std::uint64_t bottom = rowPart(y + 1, seed);
    const double a = 2.0 * numberOf(left, top) - 1.0;
    const double b = 2.0 * numberOf(right, top) - 1.0 - a;
    const double c = 2.0 * numberOf(left, bottom) - 1.0 - a;
    return {a, b, c, 2.0 * numberOf(right, bottom) - 1.0 - a - b - c};
}

/// Rises from 0 to 1 with level ends.
double eased(double t) {
    return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

double heightAt(double x, double y, std::uint32_t seed) {
    const std::int64_t column = cellOf(x);
    const std::int64_t row = cellOf(y);
    const CellSurface surface = surfaceOf(column, row, seed);
    const double s = eased(x - static_cast<double>(column));
    const double t = eased(y - static_cast<double>(row));
    return surface.a + surface.b * s + (surface.c + surface.d * s) * t;
}

} // namespace

double cellNumber(std::int64_t column, std::int64_t row, std::uint32_t seed) {
    return numberOf(columnPart(column), rowPart(row, seed));
}

Wave waveAt(const glm::dvec2& place, double length, std::uint32_t seed) {
    const double perUnit = 1.0 / length;
    const glm::dvec2 cells = place * perUnit;
    const std::int64_t x = cellOf(cells.x);
    const std::int64_t y = cellOf(cells.y);
    const CellSurface surface = surfaceOf(x, y, seed);
    const glm::dvec2 t = cells - glm::dvec2(static_cast<double>(x), static_cast<double>(y));
    const glm::dvec2 s(eased(t.x), eased(t.y));
    const glm::dvec2 rise = 30.0 * perUnit * t * t * (t - 1.0) * (t - 1.0);
    return {.value = surface.a + surface.b * s.x + (surface.c + surface.d * s.x) * s.y,
            .slope = {(surface.b + surface.d * s.y) * rise.x, (surface.c + surface.d * s.x) * rise.y}};
}

double shownBy(double texel, double length) {
    return std::clamp(0.5 * length / texel - 1.0, 0.0, 1.0);
}

double sumWaves(const Waves& waves, const glm::dvec2& place, double texel) {
    return sumWaves(waves, place, {texel, texel}, WavePart::all);
}

double sumWaves(const Waves& waves, const glm::dvec2& place, const Fineness& fineness, WavePart part) {
    // Each wave is turned against the last, so that their cells do not show.
    constexpr glm::dvec2 kTurn(0.8, 0.6);
    const double texel = fineness.texel;
    const double shortestOfGrid = 8.0 * kGridTexels * fineness.picture;
    const double first =
        part == WavePart::beyondGrid ? shortestOfGrid : std::numeric_limits<double>::infinity();
    const double last = std::max(waves.shortest, part == WavePart::ofGrid ? shortestOfGrid : 2.0 * texel);
    double sum = 0.0;
    double height = 1.0;
    std::uint32_t seed = waves.seed;
    glm::dvec2 turned = place;
    const double perTexel = 1.0 / texel;
    double perUnit = 1.0 / waves.longest;
    for (double length = waves.longest; length >= last; length *= 0.5, perUnit *= 2.0) {
        if (length < first) {
            const double shown = std::min(0.5 * length * perTexel - 1.0, 1.0); // shownBy()
            sum += shown * height * heightAt(turned.x * perUnit, turned.y * perUnit, seed);
        }
        height *= waves.gain;
        seed += 0x51ed27u;
        turned = {kTurn.x * turned.x - kTurn.y * turned.y, kTurn.y * turned.x + kTurn.x * turned.y};
    }
    return sum;
}

double leftOut(const Waves& waves, double texel) {
    double squares = 0.0;
    double height = 1.0;
    for (double length = waves.longest; length >= waves.shortest; length *= 0.5) {
        const double hidden = 1.0 - shownBy(texel, length);
        squares += hidden * hidden * height * height;
        height *= waves.gain;
    }
    return std::sqrt(squares);
}

} // namespace cdr::scenes
