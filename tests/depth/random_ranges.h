#pragma once

#include <cdr/depth/occupancy.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace cdr::test {

/// Numbers, and where objects lie, that are the same in each run.
class RandomRanges {
  public:
    explicit RandomRanges(std::uint64_t seed) : m_engine(seed) {}
    double uniform(double low, double high) { return std::uniform_real_distribution<>(low, high)(m_engine); }
    double logUniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
    /// Objects of one to ten percent of their distance.
    std::vector<depth::Interval> objects(int count, double low, double high) {
        std::vector<depth::Interval> intervals;
        for (int i = 0; i < count; ++i) {
            const double w = logUniform(low, high);
            const double r = w * logUniform(0.001, 0.1);
            intervals.push_back({w - r, w + r});
        }
        return intervals;
    }

  private:
    std::mt19937_64 m_engine;
};

} // namespace cdr::test
