#include <ranks/one_process.h>

namespace cdr::ranks {

void OneProcess::requireSame(const std::string&, const std::string&) {}

void OneProcess::forEachUnit(std::size_t count, const Make& make, const Take& take) {
    for (std::size_t unit = 0; unit < count; ++unit) {
        take(unit, make(unit));
    }
}

host::Bytes OneProcess::share(host::Bytes ofFirst) {
    return ofFirst;
}

void OneProcess::merge(const std::function<host::Bytes()>&, const std::function<void(const host::Bytes&)>&) {}

Ending OneProcess::end(const Ending& mine) {
    return mine;
}

} // namespace cdr::ranks
