#include <cdr/host/machine_state.h>

#include <fstream>

namespace cdr::host {

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
            .load = firstWordOf<double>("/proc/loadavg")};
}

} // namespace cdr::host
