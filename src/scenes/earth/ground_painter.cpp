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
/// Bluish: real clouds have less air above them, and these are to look white.
constexpr glm::dvec3 kCloud(0.79, 0.86, 1.12);
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

TexelRange texelsOf(const GroundPainter::Canvas& canvas, const GeodeticFrame& part) {
    const GeodeticFrame& frame = canvas.frame;
    const glm::dvec2 perDegree(canvas.width / frame.width, canvas.height / frame.height);
    const glm::dvec2 first(part.west - frame.west, frame.north - part.north);
    return {.begin = first * perDegree, .end = (first + glm::dvec2(part.width, part.height)) * perDegree};
}

TexelRange hiddenTexels(const GroundPainter::Canvas& canvas) {
    if (!canvas.hidden) {
        return {};
    }
    const TexelRange hidden = texelsOf(canvas, *canvas.hidden);
    return {.begin = hidden.begin + kRim, .end = hidden.end - kRim};
}

/// How far out of the fine part of a canvas a texel is: 0 within, 1 at the edge.
class Margins {
  public:
    explicit Margins(const GroundPainter::Canvas& canvas)
        : m_size(canvas.width, canvas.height),
          m_fine(texelsOf(canvas, canvas.fine.value_or(canvas.frame))) {}

    double across(double x) const { return marginOf(x, m_fine.begin.x, m_fine.end.x, m_size.x); }
    double down(double y) const { return marginOf(y, m_fine.begin.y, m_fine.end.y, m_size.y); }

  private:
    static double marginOf(double position, double begin, double end, double size) {
        const double before = (begin - position) / std::max(begin, 1e-6);
        const double behind = (position - end) / std::max(size - end, 1e-6);
        return std::clamp(std::max(before, behind), 0.0, 1.0);
    }

    glm::dvec2 m_size;
    TexelRange m_fine;
};

struct Column {
    SineCosine longitude;
    double margin = 0.0;
};

} // namespace

GroundPainter::GroundPainter(const image::ImageRgba8& marble, const Geodetic& airport,
                             const glm::dvec2& toShade)
    : m_marble(marble),
      m_map(airport),
      m_clouds(toShade) {}

GroundPainter::Slow GroundPainter::slowAt(const Geodetic& place, const Fineness& fineness) const {
    const glm::dvec2 onMap = m_map.at(place);
    // Coasts and colours wind, else they would show the marble's smooth blur.
    const Waves bends{.longest = 45e3, .shortest = 500.0, .gain = 0.55, .seed = 11};
    const double perMetre = 1.0 / (kEarthRadius * kDegree);
    const double south = kCoastBend * sumWaves(bends, onMap, fineness.texel);
    const double east = kCoastBend * sumWaves(bends, onMap + 2e6, fineness.texel);
    const double across = std::max(std::cos(place.latitude * kDegree), 0.05);
    return {.marble =
                m_marble.at({place.latitude - south * perMetre, place.longitude + east * perMetre / across}),
            .country = countryAt(onMap, fineness),
            .weather = m_clouds.weatherAt(onMap, fineness)};
}

GroundPainter::Slow GroundPainter::between(const Slow& a, const Slow& b, double share) {
    return {.marble = {.color = glm::mix(a.marble.color, b.marble.color, share),
                       .water = blend(a.marble.water, b.marble.water, share)},
            .country = cdr::scenes::between(a.country, b.country, share),
            .weather = {.wind = glm::mix(a.weather.wind, b.weather.wind, share),
                        .here = blend(a.weather.here, b.weather.here, share),
                        .sunwards = blend(a.weather.sunwards, b.weather.sunwards, share)}};
}

glm::dvec3 GroundPainter::colorOf(const Slow& slow, const glm::dvec2& place, const Fineness& fineness) const {
    const Clouds::Cover clouds = m_clouds.coverAt(slow.weather, place, fineness);
    const glm::dvec3 cloud = clouds.bright * kCloud;
    if (clouds.share >= 1.0) {
        return cloud;
    }
    double water = slow.marble.water;
    if (water > 0.0 && water < 1.0) {
        water +=
            1.2 * water * (1.0 - water) *
            sumWaves({.longest = 24e3, .shortest = 20.0, .gain = 0.62, .seed = 12}, place, fineness.texel);
    }
    const double sea = smoothStep(0.47, 0.53, water);
    glm::dvec3 color = glm::mix(kShoal, kSea, smoothStep(0.5, 0.95, water));
    if (sea < 1.0) {
        color =
            glm::mix(countryColor(kLandGain * slow.marble.color, slow.country, place, fineness), color, sea);
    }
    return glm::mix(color * (1.0 - clouds.shade), cloud, clouds.share);
}

image::ImageRgba8 GroundPainter::paint(const Canvas& canvas, platform::WorkerPool& workers) const {
    const GeodeticFrame& frame = canvas.frame;
    const double texel = frame.height / canvas.height * kDegree * kEarthRadius;
    const std::uint32_t columns = canvas.width / kGridTexels + 1;
    const std::uint32_t rows = canvas.height / kGridTexels + 1;
    const auto placeAt = [&](double x, double y) {
        return Geodetic{frame.north - frame.height * y / canvas.height,
                        frame.west + frame.width * x / canvas.width};
    };
    const Margins margins(canvas);
    const auto finenessAt = [&](double across, double down) {
        const double margin = std::max(across, down);
        return Fineness{.texel = texel * (1.0 + (canvas.growth - 1.0) * margin), .picture = texel};
    };
    std::vector<Slow> grid(std::size_t{columns} * rows);
    workers.run(rows, [&](std::size_t row, std::size_t) {
        const double y = static_cast<double>(row) * kGridTexels;
        for (std::uint32_t column = 0; column < columns; ++column) {
            const double x = column * kGridTexels;
            grid[row * columns + column] =
                slowAt(placeAt(x, y), finenessAt(margins.across(x), margins.down(y)));
        }
    });
    std::vector<Column> across;
    for (std::uint32_t x = 0; x < canvas.width; ++x) {
        across.push_back({SineCosine(placeAt(x + 0.5, 0.0).longitude), margins.across(x + 0.5)});
    }
    const TexelRange hidden = hiddenTexels(canvas);
    const Encoder encoder;
    image::ImageRgba8 picture(canvas.width, canvas.height);
    workers.run(canvas.height, [&](std::size_t row, std::size_t) {
        const auto y = static_cast<std::uint32_t>(row);
        const SineCosine latitude(placeAt(0.0, y + 0.5).latitude);
        const double margin = margins.down(y + 0.5);
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
            const double cell = (x + 0.5) / kGridTexels;
            const std::uint32_t left = x / kGridTexels;
            const Slow slow = between(line[left], line[left + 1], cell - std::floor(cell));
            const glm::dvec2 place = m_map.at(latitude, across[x].longitude);
            picture.at(x, y) = encoder.encode(colorOf(slow, place, finenessAt(across[x].margin, margin)));
        }
    });
    return picture;
}

} // namespace cdr::scenes
