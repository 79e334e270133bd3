#include <cdr/base/format_error.h>
#include <cdr/image/same_size.h>
#include <cdr/measure/compare/flip_color.h>
#include <cdr/measure/compare/flip_difference.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

namespace cdr::measure {

namespace {

using Taps = FlipDifference::Taps;

constexpr std::uint32_t kTileSide = 64;

/// One Gaussian of a contrast sensitivity, given in cycles per degree: a sqrt(pi / b) exp(-pi^2 x^2 / b)
/// (section 4.1, Table 1).
struct Sensitivity {
    double a;
    double b;
};
constexpr Sensitivity kLightness{1.0, 0.0047};
constexpr Sensitivity kRedGreen{1.0, 0.0053};
constexpr std::array<Sensitivity, 2> kBlueYellow{{{34.1, 0.04}, {13.5, 0.025}}};

/// Width of the eye's edge detector in degrees (section 4.2).
constexpr double kFeatureDegrees = 0.082;

std::vector<double> sample(std::uint32_t radius, const std::function<double(double)>& curve) {
    std::vector<double> samples;
    for (std::uint32_t i = 0; i <= 2 * radius; ++i) {
        samples.push_back(curve(static_cast<double>(i) - static_cast<double>(radius)));
    }
    return samples;
}

/// Positive taps that sum up to 1, negative ones to -1.
Taps normalized(const std::vector<double>& samples) {
    double positive = 0.0;
    double negative = 0.0;
    for (const double s : samples) {
        (s > 0.0 ? positive : negative) += std::abs(s);
    }
    Taps taps;
    for (const double s : samples) {
        taps.push_back(static_cast<float>(s > 0.0 ? s / positive : s < 0.0 ? s / negative : 0.0));
    }
    return taps;
}

std::vector<double> sensitivitySamples(const Sensitivity& s, std::uint32_t radius, double pixelsPerDegree) {
    return sample(radius, [&](double pixels) {
        const double degrees = pixels / pixelsPerDegree;
        return std::exp(-std::numbers::pi * std::numbers::pi * degrees * degrees / s.b);
    });
}

/// Weight of a Gaussian in the sum of the two-dimensional ones.
double weightOf(const Sensitivity& s, const std::vector<double>& samples) {
    const double sum = std::accumulate(samples.begin(), samples.end(), 0.0);
    return s.a * std::sqrt(std::numbers::pi / s.b) * sum * sum;
}

/// out[i] is the sum of taps[k] * in[i + k * stride].
void convolve(const float* in, std::size_t stride, const Taps& taps, float* out, std::size_t count) {
    std::fill_n(out, count, 0.0f);
    for (std::size_t k = 0; k < taps.size(); ++k) {
        const float tap = taps[k];
        const float* shifted = in + k * stride;
        for (std::size_t i = 0; i < count; ++i) {
            out[i] += tap * shifted[i];
        }
    }
}

float length(float x, float y) {
    return std::sqrt(x * x + y * y);
}

} // namespace

/// One tile of one picture, filtered.
class FlipDifference::Tile {
  public:
    /// @param left, top the tile's first pixel; it is kTileSide wide and high, its pixels outside the picture
    /// repeat the border's.
    Tile(const Filters& filters, std::uint32_t reach, const image::ImageRgba8& picture, std::uint32_t left,
         std::uint32_t top)
        : m_filters(filters),
          m_reach(reach),
          m_side(kTileSide + 2 * std::size_t{reach}) {
        load(picture, left, top);
        filterColors();
        filterFeatures();
    }

    HuntLab color(std::size_t i) const { return huntLabOf({m_colors[0][i], m_colors[1][i], m_colors[2][i]}); }
    bool sameColor(const Tile& other, std::size_t i) const {
        return m_colors[0][i] == other.m_colors[0][i] && m_colors[1][i] == other.m_colors[1][i] &&
               m_colors[2][i] == other.m_colors[2][i];
    }
    float edge(std::size_t i) const { return m_edges[i]; }
    float point(std::size_t i) const { return m_points[i]; }

  private:
    using Plane = std::vector<float>;

    void load(const image::ImageRgba8& picture, std::uint32_t left, std::uint32_t top) {
        for (Plane& plane : m_window) {
            plane.resize(m_side * m_side);
        }
        const auto clamped = [](std::size_t place, std::uint32_t reach, std::uint32_t size) {
            return static_cast<std::uint32_t>(std::clamp<std::ptrdiff_t>(
                static_cast<std::ptrdiff_t>(place) - reach, 0, std::ptrdiff_t{size} - 1));
        };
        for (std::size_t y = 0; y < m_side; ++y) {
            const std::uint32_t row = clamped(top + y, m_reach, picture.height);
            for (std::size_t x = 0; x < m_side; ++x) {
                const Opponent color = opponentOf(picture.at(clamped(left + x, m_reach, picture.width), row));
                m_window[0][y * m_side + x] = color.y;
                m_window[1][y * m_side + x] = color.cx;
                m_window[2][y * m_side + x] = color.cz;
            }
        }
    }

    /// The window filtered along its rows: kTileSide wide, m_side high.
    Plane alongRows(const Plane& window, const Taps& taps) const {
        const std::size_t inset = m_reach - taps.size() / 2;
        Plane out(kTileSide * m_side);
        for (std::size_t y = 0; y < m_side; ++y) {
            convolve(&window[y * m_side + inset], 1, taps, &out[y * kTileSide], kTileSide);
        }
        return out;
    }

    /// What alongRows() gave, filtered along columns: the tile.
    Plane alongColumns(const Plane& rows, const Taps& taps) const {
        const std::size_t inset = m_reach - taps.size() / 2;
        Plane out(std::size_t{kTileSide} * kTileSide);
        for (std::size_t y = 0; y < kTileSide; ++y) {
            convolve(&rows[(y + inset) * kTileSide], kTileSide, taps, &out[y * kTileSide], kTileSide);
        }
        return out;
    }

    Plane blurred(const Plane& window, const Taps& taps) const {
        return alongColumns(alongRows(window, taps), taps);
    }

    void filterColors() {
        m_colors[0] = blurred(m_window[0], m_filters.lightness);
        m_colors[1] = blurred(m_window[1], m_filters.redGreen);
        m_colors[2] = blurred(m_window[2], m_filters.blueYellow[0]);
        const Plane second = blurred(m_window[2], m_filters.blueYellow[1]);
        for (std::size_t i = 0; i < second.size(); ++i) {
            m_colors[2][i] =
                m_filters.blueYellowShares[0] * m_colors[2][i] + m_filters.blueYellowShares[1] * second[i];
        }
    }

    void filterFeatures() {
        // Of Y from 0 to 1; adding a constant changes neither derivative.
        const Plane smooth = alongRows(m_window[0], m_filters.smooth);
        const Plane edgeX = alongColumns(alongRows(m_window[0], m_filters.edge), m_filters.smooth);
        const Plane edgeY = alongColumns(smooth, m_filters.edge);
        const Plane pointX = alongColumns(alongRows(m_window[0], m_filters.point), m_filters.smooth);
        const Plane pointY = alongColumns(smooth, m_filters.point);
        m_edges.resize(edgeX.size());
        m_points.resize(edgeX.size());
        for (std::size_t i = 0; i < edgeX.size(); ++i) {
            m_edges[i] = length(edgeX[i], edgeY[i]) / 116.0f;
            m_points[i] = length(pointX[i], pointY[i]) / 116.0f;
        }
    }

    const Filters& m_filters;
    std::uint32_t m_reach;
    std::size_t m_side;
    std::array<Plane, 3> m_window; ///< the opponents of the tile and m_reach pixels around it
    std::array<Plane, 3> m_colors; ///< the opponents as the eye filters them
    Plane m_edges;
    Plane m_points;
};

FlipDifference::FlipDifference(const Viewing& viewing) : m_reach(0) {
    const double scale = viewing.pixelsPerDegree;
    if (!(scale >= 1.0 && scale <= 1000.0)) {
        throw base::inputError("FLIP: a degree must span 1 to 1000 pixels, not {}", viewing.pixelsPerDegree);
    }
    const auto radius = static_cast<std::uint32_t>(
        std::ceil(3.0 * std::sqrt(kBlueYellow[0].b / (2.0 * std::numbers::pi * std::numbers::pi)) * scale));
    m_filters.lightness = normalized(sensitivitySamples(kLightness, radius, scale));
    m_filters.redGreen = normalized(sensitivitySamples(kRedGreen, radius, scale));
    std::array<double, 2> weights{};
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const auto samples = sensitivitySamples(kBlueYellow[i], radius, scale);
        m_filters.blueYellow[i] = normalized(samples);
        weights[i] = weightOf(kBlueYellow[i], samples);
    }
    for (std::size_t i = 0; i < weights.size(); ++i) {
        m_filters.blueYellowShares[i] = static_cast<float>(weights[i] / (weights[0] + weights[1]));
    }

    const double deviation = 0.5 * kFeatureDegrees * scale;
    const auto featureRadius = static_cast<std::uint32_t>(std::ceil(3.0 * deviation));
    const auto gaussian = [&](double x) { return std::exp(-x * x / (2.0 * deviation * deviation)); };
    m_filters.smooth = normalized(sample(featureRadius, gaussian));
    m_filters.edge = normalized(sample(featureRadius, [&](double x) { return -x * gaussian(x); }));
    m_filters.point = normalized(sample(
        featureRadius, [&](double x) { return (x * x / (deviation * deviation) - 1.0) * gaussian(x); }));
    m_reach = std::max(radius, featureRadius);
}

namespace {

/// Whether any pixel of the tile or within `reach` of it differs.
bool differs(const image::ImageRgba8& a, const image::ImageRgba8& b, std::uint32_t left, std::uint32_t top,
             std::uint32_t reach) {
    const std::uint32_t x0 = left - std::min(left, reach);
    const std::uint32_t y0 = top - std::min(top, reach);
    const std::uint32_t x1 = std::min(left + kTileSide + reach, a.width);
    const std::uint32_t y1 = std::min(top + kTileSide + reach, a.height);
    for (std::uint32_t y = y0; y < y1; ++y) {
        const auto* row = &a.at(x0, y);
        if (!std::equal(row, row + (x1 - x0), &b.at(x0, y))) {
            return true;
        }
    }
    return false;
}

/// The colour difference, raised by features that appear or vanish (section 4.3).
float combine(float colorDifference, float edgeDifference, float pointDifference) {
    const float feature = std::sqrt(std::max(edgeDifference, pointDifference) / std::numbers::sqrt2_v<float>);
    return std::pow(colorDifference, 1.0f - std::min(feature, 1.0f));
}

} // namespace

image::ImageFloat FlipDifference::map(const image::ImageRgba8& reference, const image::ImageRgba8& test,
                                      platform::WorkerPool& workers) const {
    image::requireSameSize(reference, test, "FLIP");
    image::ImageFloat map(test.width, test.height);
    const std::uint32_t columns = (test.width + kTileSide - 1) / kTileSide;
    const std::uint32_t rows = (test.height + kTileSide - 1) / kTileSide;
    workers.run(std::size_t{columns} * rows, [&](std::size_t tile, std::size_t) {
        const std::uint32_t left = static_cast<std::uint32_t>(tile % columns) * kTileSide;
        const std::uint32_t top = static_cast<std::uint32_t>(tile / columns) * kTileSide;
        if (!differs(reference, test, left, top, m_reach)) {
            return;
        }
        const Tile a(m_filters, m_reach, reference, left, top);
        const Tile b(m_filters, m_reach, test, left, top);
        for (std::uint32_t y = top; y < std::min(top + kTileSide, test.height); ++y) {
            for (std::uint32_t x = left; x < std::min(left + kTileSide, test.width); ++x) {
                const std::size_t i = std::size_t{y - top} * kTileSide + (x - left);
                if (!a.sameColor(b, i)) { // else no difference that features could raise
                    map.at(x, y) =
                        combine(redistribute(hyab(a.color(i), b.color(i))), std::abs(a.edge(i) - b.edge(i)),
                                std::abs(a.point(i) - b.point(i)));
                }
            }
        }
    });
    return map;
}

double FlipDifference::mean(const image::ImageRgba8& reference, const image::ImageRgba8& test,
                            platform::WorkerPool& workers) const {
    const image::ImageFloat differences = map(reference, test, workers);
    const double sum = std::accumulate(differences.pixels.begin(), differences.pixels.end(), 0.0);
    return differences.pixels.empty() ? 0.0 : sum / static_cast<double>(differences.pixels.size());
}

} // namespace cdr::measure
