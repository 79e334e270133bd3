#include <cdr/base/format_error.h>
#include <cdr/platform/host_memory.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

namespace cdr::platform {

namespace {

/// Empty where there is no such file.
std::optional<std::uint64_t> availableOnSystem() {
    std::ifstream file("/proc/meminfo");
    std::optional<std::uint64_t> bytes;
    std::string name;
    std::uint64_t kibibytes = 0;
    for (std::string unit; file >> name >> kibibytes && std::getline(file, unit);) {
        if (name == "MemAvailable:" || name == "SwapFree:") {
            bytes = bytes.value_or(0) + kibibytes * 1024;
        }
    }
    return bytes;
}

/// Empty where nothing limits the process.
std::optional<std::uint64_t> availableToProcess() {
    rlimit limit{};
    std::uint64_t pages = 0;
    if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY ||
        !(std::ifstream("/proc/self/statm") >> pages)) {
        return std::nullopt;
    }
    const std::uint64_t taken = pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    return limit.rlim_cur - std::min<std::uint64_t>(taken, limit.rlim_cur);
}

} // namespace

std::optional<std::uint64_t> freeHostBytes() {
    const auto system = availableOnSystem();
    const auto process = availableToProcess();
    return system && process ? std::min(*system, *process) : (system ? system : process);
}

std::uint64_t saturatingProduct(std::initializer_list<std::uint64_t> factors) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t product = 1;
    for (const std::uint64_t factor : factors) {
        product = factor != 0 && product > kMost / factor ? kMost : product * factor;
    }
    return product;
}

void requireHostBytes(std::uint64_t bytes, const std::string& what) {
    if (const auto available = freeHostBytes(); available && bytes > *available) {
        throw base::runError("{} needs {:.1f} MiB of memory, {:.1f} MiB are free", what,
                             static_cast<double>(bytes) / 0x1p20, static_cast<double>(*available) / 0x1p20);
    }
}

} // namespace cdr::platform
