#include <cdr/base/error.h>
#include <cdr/measure/statistics/choice_statistics.h>

#include <algorithm>
#include <cmath>

namespace cdr::measure {

namespace {

constexpr unsigned kMaxTrials = 1'000'000;

void requireTrials(const ChoiceCounts& counts) {
    if (counts.left > kMaxTrials || counts.right > kMaxTrials || counts.all() == 0) {
        throw base::InputError("choices: there must be at least one, and at most a million for each side");
    }
}

} // namespace

double chiSquared(const ChoiceCounts& counts) {
    requireTrials(counts);
    const double difference = static_cast<double>(counts.left) - static_cast<double>(counts.right);
    return difference * difference / static_cast<double>(counts.all());
}

double chiSquaredTail(double chiSquared) {
    return std::erfc(std::sqrt(0.5 * chiSquared));
}

double binomialTail(const ChoiceCounts& counts) {
    requireTrials(counts);
    const unsigned trials = counts.all();
    const unsigned fewer = std::min(counts.left, counts.right);
    // Both tails of the symmetric distribution; an even split is their middle and counted in each.
    double tail = 0.0;
    for (unsigned k = 0; k <= fewer; ++k) {
        tail += std::exp(std::lgamma(trials + 1.0) - std::lgamma(k + 1.0) - std::lgamma(trials - k + 1.0) -
                         trials * std::log(2.0));
    }
    return std::min(1.0, 2.0 * tail);
}

} // namespace cdr::measure
