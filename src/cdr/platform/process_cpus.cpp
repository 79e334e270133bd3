#include <cdr/platform/process_cpus.h>
#include <cdr/platform/thread_placement.h>

#if defined(__linux__)
#include <sched.h>
#include <unistd.h>
#endif

namespace cdr::platform {

#if defined(__linux__)

namespace {

/// @param process 0 for the calling thread.
std::vector<std::size_t> cpusOf(pid_t process) {
    std::vector<std::size_t> cpus;
    cpu_set_t set;
    if (sched_getaffinity(process, sizeof(set), &set) == 0) {
        for (std::size_t cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
            if (CPU_ISSET(cpu, &set)) {
                cpus.push_back(cpu);
            }
        }
    }
    return cpus;
}

} // namespace

std::vector<std::size_t> allowedCpus() {
    return cpusOf(0);
}

std::vector<std::size_t> cpusOfParent() {
    return cpusOf(getppid());
}

void allowCpus(const std::vector<std::size_t>& cpus) {
    if (cpus.empty()) {
        return;
    }
    cpu_set_t set;
    CPU_ZERO(&set);
    for (const std::size_t cpu : cpus) {
        CPU_SET(cpu, &set);
    }
    // Fails if the CPU went offline; the thread then keeps its CPUs.
    static_cast<void>(sched_setaffinity(0, sizeof(set), &set));
}

#else

std::vector<std::size_t> allowedCpus() {
    return {};
}

std::vector<std::size_t> cpusOfParent() {
    return {};
}

void allowCpus(const std::vector<std::size_t>&) {}

#endif

} // namespace cdr::platform
