#pragma once

#include <cdr/gpu/device.h>
#include <report/plan.h>

#include <cstddef>
#include <vector>

namespace cdr::cli {

/// How many times as long this machine takes as the one that the plan's seconds are of. It is measured by a piece of work
/// of a second or so: frames on the device, and rays cast on the processors.
double measuredPace(const gpu::Device& device, std::size_t threads);

/// How long a plan takes: told by the pace measured before, and then by what is done of the plan.
class Forecast {
  public:
    Forecast(const std::vector<report::Section>& plan, double pace);

    void done(const report::Section& section, double seconds);
    double secondsLeft() const;

  private:
    double m_pace;
    double m_left = 0.0;
    double m_expected = 0.0;
    double m_taken = 0.0;
};

} // namespace cdr::cli
