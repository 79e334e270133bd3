#include <cdr/measure/statistics/scaling_law.h>

#include <algorithm>
#include <cstddef>

namespace cdr::measure {

namespace {

constexpr std::size_t kMinUniversalPoints = 4;

} // namespace

std::optional<double> fitAmdahl(const std::vector<SpeedUp>& points) {
    // 1 / factor - 1 / p = s (1 - 1 / p): a line through the origin.
    double xx = 0.0;
    double xy = 0.0;
    for (const SpeedUp& point : points) {
        const double x = 1.0 - 1.0 / point.threads;
        xx += x * x;
        xy += x * (1.0 / point.factor - 1.0 / point.threads);
    }
    return xx > 0.0 ? std::optional(std::clamp(xy / xx, 0.0, 1.0)) : std::nullopt;
}

std::optional<UniversalScalability> fitUniversalScalability(const std::vector<SpeedUp>& points) {
    if (points.size() < kMinUniversalPoints) {
        return std::nullopt;
    }
    // Normal equations of z = contention x + coherence y with x = p - 1 and y = p (p - 1).
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    double xz = 0.0;
    double yz = 0.0;
    for (const SpeedUp& point : points) {
        const double x = point.threads - 1.0;
        const double y = point.threads * x;
        const double z = point.threads / point.factor - 1.0;
        xx += x * x;
        xy += x * y;
        yy += y * y;
        xz += x * z;
        yz += y * z;
    }
    const double determinant = xx * yy - xy * xy;
    // Rounding alone leaves about 1e-16 of the product where all points share one number of threads.
    if (determinant <= 1e-12 * xx * yy) {
        return std::nullopt;
    }
    return UniversalScalability{.contention = (xz * yy - yz * xy) / determinant,
                                .coherence = (yz * xx - xz * xy) / determinant};
}

} // namespace cdr::measure
