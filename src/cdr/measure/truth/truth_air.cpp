#include <cdr/measure/truth/truth_air.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cdr::measure {

namespace {

/// Heights of e-folding up to which there is air.
constexpr double kTop = 14.0;
/// Steps on each side of a ray's lowest place: to the camera, and from there to the Sun.
constexpr int kSeenSteps = 64;
constexpr int kSunSteps = 32;

/// A straight way about the planet's centre, in radii of the planet and stretched so that it is a sphere. `t` is in scene units.
struct Way {
    glm::dvec3 from;
    glm::dvec3 perUnit;

    double heightAt(double t) const { return glm::length(from + t * perUnit) - 1.0; }
    double lowestAt() const { return -glm::dot(from, perUnit) / glm::dot(perUnit, perUnit); }
    /// From lowestAt() to where the way is `radius` from the centre; below 0 if it never is.
    double reach(double radius) const {
        const glm::dvec3 lowest = from + lowestAt() * perUnit;
        const double rest = radius * radius - glm::dot(lowest, lowest);
        return rest < 0.0 ? -1.0 : std::sqrt(rest / glm::dot(perUnit, perUnit));
    }
    bool meetsPlanet() const { return lowestAt() > 0.0 && heightAt(0.0) > 0.0 && heightAt(lowestAt()) < 0.0; }
};

class AirSum {
  public:
    explicit AirSum(const scene::Air& air)
        : m_air(air),
          m_top(1.0 + kTop * std::max(air.molecules.height, air.haze.height) / air.radius) {}

    Way wayOf(const glm::dvec3& fromCentre, const glm::dvec3& direction) const {
        return {stretched(fromCentre) / m_air.radius, stretched(direction) / m_air.radius};
    }

    /// From the start of a way to `end` at most, in steps that are short where the way is low.
    /// @param take a place along the way, and the step's length; in scene units.
    template <typename Take>
    void walk(const Way& way, double end, int steps, const Take& take) const {
        const double reach = way.reach(m_top);
        const double begin = std::max(way.lowestAt() - reach, 0.0);
        end = std::min(way.lowestAt() + reach, end);
        if (reach <= 0.0 || end <= begin) {
            return;
        }
        const double middle = std::clamp(way.lowestAt(), begin, end);
        const auto cubed = [](double share) { return share * share * share; };
        const auto side = [&](double rim, int step) {
            const double near = cubed(static_cast<double>(step) / steps);
            const double far = cubed((step + 1.0) / steps);
            take(middle + 0.5 * (near + far) * (rim - middle), (far - near) * std::abs(rim - middle));
        };
        for (int step = steps - 1; step >= 0 && middle > begin; --step) {
            side(begin, step);
        }
        for (int step = 0; step < steps && middle < end; ++step) {
            side(end, step);
        }
    }

    /// Of molecules and of haze, 1 on the ground.
    glm::dvec2 densityAt(double height) const {
        const double metric = std::max(height, 0.0) * m_air.radius;
        return {std::exp(-metric / m_air.molecules.height), std::exp(-metric / m_air.haze.height)};
    }

    glm::dvec3 lost(const glm::dvec2& amounts) const {
        return amounts.x * glm::dvec3(m_air.molecules.scattering) +
               amounts.y * glm::dvec3(m_air.haze.scattering);
    }

    /// The share of sunlight that reaches a place about the centre, stretched and in radii.
    glm::dvec3 sunAt(const glm::dvec3& place) const {
        const Way way{place, stretched(m_air.toSun) / m_air.radius};
        if (way.meetsPlanet()) {
            return glm::dvec3(0.0);
        }
        glm::dvec2 amounts(0.0);
        walk(way, std::numeric_limits<double>::infinity(), kSunSteps,
             [&](double t, double step) { amounts += step * densityAt(way.heightAt(t)); });
        return glm::exp(-lost(amounts));
    }

    glm::dvec3 seen(const Way& way, double cosine, double end, const glm::dvec3& color) const {
        const double ahead = m_air.hazeAhead;
        const double moleculePhase = 3.0 / 16.0 * (1.0 + cosine * cosine);
        const double hazePhase =
            0.25 * (1.0 - ahead * ahead) / std::pow(1.0 + ahead * ahead - 2.0 * ahead * cosine, 1.5);
        glm::dvec2 before(0.0);
        glm::dvec3 light(0.0);
        walk(way, end, kSeenSteps, [&](double t, double step) {
            const glm::dvec2 amounts = step * densityAt(way.heightAt(t));
            const glm::dvec3 sent = lost({amounts.x * moleculePhase, amounts.y * hazePhase});
            light += sent * glm::exp(-lost(before + 0.5 * amounts)) * sunAt(way.from + t * way.perUnit);
            before += amounts;
        });
        return color * glm::exp(-lost(before)) + light * glm::dvec3(m_air.sunlight);
    }

  private:
    glm::dvec3 stretched(const glm::dvec3& way) const {
        return way + (1.0 / (1.0 - m_air.flattening) - 1.0) * glm::dot(m_air.axis, way) * m_air.axis;
    }

    const scene::Air& m_air;
    double m_top; ///< radii from the centre
};

} // namespace

glm::dvec3 throughAir(const scene::Scene& scene, const glm::dvec3& eye, const glm::dvec3& fromEye,
                      const glm::dvec3& color) {
    if (!scene.air) {
        return color;
    }
    const AirSum sum(*scene.air);
    const double distance = glm::length(fromEye);
    const glm::dvec3 direction = fromEye / distance;
    return sum.seen(sum.wayOf(eye - scene.air->centre, direction), glm::dot(direction, scene.air->toSun),
                    distance, color);
}

glm::dvec3 backgroundAlong(const scene::Scene& scene, const glm::dvec3& eye, const glm::dvec3& direction) {
    const glm::dvec3 color(scene.background);
    if (!scene.air) {
        return color;
    }
    const AirSum sum(*scene.air);
    const glm::dvec3 unit = glm::normalize(direction);
    const Way way = sum.wayOf(eye - scene.air->centre, unit);
    const double end =
        way.meetsPlanet() ? way.lowestAt() - way.reach(1.0) : std::numeric_limits<double>::infinity();
    return sum.seen(way, glm::dot(unit, scene.air->toSun), end, color);
}

} // namespace cdr::measure
