#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <random>

namespace cdr::scenes {

/// Uniform doubles that are the same on every standard library, unlike std::uniform_real_distribution's.
class Random {
  public:
    explicit Random(std::uint64_t seed) : m_engine(seed) {}

    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(m_engine() >> 11) * 0x1p-53;
    }
    glm::dvec3 inCube(double halfSide) {
        const double x = uniform(-halfSide, halfSide);
        const double y = uniform(-halfSide, halfSide);
        const double z = uniform(-halfSide, halfSide);
        return {x, y, z};
    }

  private:
    std::mt19937_64 m_engine;
};

} // namespace cdr::scenes
