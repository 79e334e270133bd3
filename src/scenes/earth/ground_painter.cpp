#include <cdr/image/srgb.h>
#include <scenes/degree.h>
#include <scenes/earth/ground_painter.h>
#include <scenes/earth/noise.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace cdr::scenes {

namespace {

constexpr glm::dvec3 kSea(0.006, 0.02, 0.05);  ///< linear, deep
constexpr glm::dvec3 kShoal(0.02, 0.07, 0.09); ///< linear, along coasts
constexpr double kLandGain = 3.4;  ///< the marble is darker than what it shows, which air is to veil here
constexpr double kCoastBend = 9e3; ///< metres by which coasts wind where the marble has them smooth

/// Linear light as sRGB, from a table, since there are many texels.
class Encoder {
  public:
    Encoder() {
        for (std::size_t i = 0; i < m_steps.size(); ++i) {
            m_steps[i] = image::srgbOfLinear(static_cast<double>(i) / kLast);
        }
    }
    image::Rgba8 encode(const glm::dvec3& color) const {
        return {step(color.r), step(color.g), step(color.b), 255};
    }

  private:
    static constexpr std::size_t kLast = 8'191;
    std::uint8_t step(double value) const {
        return m_steps[static_cast<std::size_t>(std::lround(std::clamp(value, 0.0, 1.0) * kLast))];
    }
    std::array<std::uint8_t, kLast + 1> m_steps{};
};

/// Texels of a rectangle, ends exclusive.
struct TexelRange {
    glm::dvec2 begin{0.0};
    glm::dvec2 end{0.0};

    bool holds(std::uint32_t x, std::uint32_t y) const {
        return x >= begin.x && x < end.x && y >= begin.y && y < end.y;
    }
};

constexpr std::uint32_t kHiddenStep = 8; ///< of the texels of a row, one is worked out
constexpr double kRim = 16.0;            ///< texels that filters reach across the border

TexelRange hiddenTexels(const GroundPainter::Canvas& canvas) {
    if (!canvas.hidden) {
        return {};
    }
    const GeodeticFrame& frame = canvas.frame;
    const GeodeticFrame& hidden = *canvas.hidden;
    const glm::dvec2 perDegree(canvas.width / frame.width, canvas.height / frame.height);
    const glm::dvec2 first(hidden.west - frame.west, frame.north - hidden.north);
    return {.begin = first * perDegree + kRim,
            .end = (first + glm::dvec2(hidden.width, hidden.height)) * perDegree - kRim};
}

} // namespace

GroundPainter::GroundPainter(const image::ImageRgba8& marble, const Geodetic& airport,
                             const glm::dvec2& toShade)
    : m_marble(marble),
      m_map(airport),
      m_clouds(toShade) {}

GroundPainter::Slow GroundPainter::slowAt(const Geodetic& place, double texel) const {
    const glm::dvec2 onMap = m_map.at(place);
    // Coasts and colours wind, else they would show the marble's smooth blur.
    const Waves bends{.longest = 45e3, .shortest = 500.0, .gain = 0.55, .seed = 11};
    const double perMetre = 1.0 / (kEarthRadius * kDegree);
    const double south = kCoastBend * sumWaves(bends, onMap, texel);
    const double east = kCoastBend * sumWaves(bends, onMap + 2e6, texel);
    const double across = std::max(std::cos(place.latitude * kDegree), 0.05);
    return {.marble =
                m_marble.at({place.latitude - south * perMetre, place.longitude + east * perMetre / across}),
            .country = countryAt(onMap, texel),
            .weather = m_clouds.weatherAt(onMap, texel)};
}

GroundPainter::Slow GroundPainter::between(const Slow& a, const Slow& b, double share) {
    return {.marble = {.color = glm::mix(a.marble.color, b.marble.color, share),
                       .water = blend(a.marble.water, b.marble.water, share)},
            .country = cdr::scenes::between(a.country, b.country, share),
            .weather = {.wind = glm::mix(a.weather.wind, b.weather.wind, share),
                        .here = blend(a.weather.here, b.weather.here, share),
                        .sunwards = blend(a.weather.sunwards, b.weather.sunwards, share)}};
}

glm::dvec3 GroundPainter::colorOf(const Slow& slow, const glm::dvec2& place, double texel) const {
    double water = slow.marble.water;
    if (water > 0.0 && water < 1.0) {
        water += 1.2 * water * (1.0 - water) *
                 sumWaves({.longest = 24e3, .shortest = 20.0, .gain = 0.62, .seed = 12}, place, texel);
    }
    const double sea = smoothStep(0.47, 0.53, water);
    glm::dvec3 color = glm::mix(kShoal, kSea, smoothStep(0.5, 0.95, water));
    if (sea < 1.0) {
        color = glm::mix(countryColor(kLandGain * slow.marble.color, slow.country, place, texel), color, sea);
    }
    const Clouds::Cover clouds = m_clouds.coverAt(slow.weather, place, texel);
    color *= 1.0 - clouds.shade;
    return glm::mix(color, glm::dvec3(clouds.bright), clouds.share);
}

image::ImageRgba8 GroundPainter::paint(const Canvas& canvas, host::WorkerPool& workers) const {
    const GeodeticFrame& frame = canvas.frame;
    const double texel = frame.height / canvas.height * kDegree * kEarthRadius;
    const std::uint32_t columns = canvas.width / kGridTexels + 1;
    const std::uint32_t rows = canvas.height / kGridTexels + 1;
    const auto placeAt = [&](double x, double y) {
        return Geodetic{frame.north - frame.height * y / canvas.height,
                        frame.west + frame.width * x / canvas.width};
    };
    std::vector<Slow> grid(std::size_t{columns} * rows);
    workers.run(rows, [&](std::size_t row, std::size_t) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            grid[row * columns + column] =
                slowAt(placeAt(column * kGridTexels, static_cast<double>(row) * kGridTexels), texel);
        }
    });
    std::vector<SineCosine> longitudes;
    for (std::uint32_t x = 0; x < canvas.width; ++x) {
        longitudes.emplace_back(placeAt(x + 0.5, 0.0).longitude);
    }
    const TexelRange hidden = hiddenTexels(canvas);
    const Encoder encoder;
    image::ImageRgba8 picture(canvas.width, canvas.height);
    workers.run(canvas.height, [&](std::size_t row, std::size_t) {
        const auto y = static_cast<std::uint32_t>(row);
        const SineCosine latitude(placeAt(0.0, y + 0.5).latitude);
        const double down = (y + 0.5) / kGridTexels;
        const Slow* above = &grid[std::size_t{y / kGridTexels} * columns];
        std::vector<Slow> line;
        for (std::uint32_t column = 0; column < columns; ++column) {
            line.push_back(between(above[column], above[column + columns], down - std::floor(down)));
        }
        for (std::uint32_t x = 0; x < canvas.width; ++x) {
            if (hidden.holds(x, y) && x % kHiddenStep != 0) {
                picture.at(x, y) = picture.at(x - 1, y);
                continue;
            }
            const double across = (x + 0.5) / kGridTexels;
            const std::uint32_t left = x / kGridTexels;
            const Slow slow = between(line[left], line[left + 1], across - std::floor(across));
            picture.at(x, y) = encoder.encode(colorOf(slow, m_map.at(latitude, longitudes[x]), texel));
        }
    });
    return picture;
}

} // namespace cdr::scenes
