#include <program/machine_state.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace cdr::program {

namespace {

template <typename T>
std::optional<T> firstWordOf(const char* path) {
    std::ifstream file(path);
    T word;
    return file >> word ? std::optional(word) : std::nullopt;
}

} // namespace

MachineState machineState() {
    return {.governor = firstWordOf<std::string>("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor"),
            .load = firstWordOf<double>("/proc/loadavg"),
            .cpus = static_cast<std::size_t>(std::max(1L, ::sysconf(_SC_NPROCESSORS_ONLN)))};
}

} // namespace cdr::program
