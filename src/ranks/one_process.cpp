#include <ranks/one_process.h>

namespace cdr::ranks {

void OneProcess::requireSame(const std::string&, const std::string&) {}

void OneProcess::forEachUnit(std::size_t count, const Make& make, const Take& take) {
    for (std::size_t unit = 0; unit < count; ++unit) {
        take(unit, make(unit));
    }
}

void OneProcess::merge(const std::function<platform::Bytes()>&,
                       const std::function<void(const platform::Bytes&)>&) {}

} // namespace cdr::ranks
