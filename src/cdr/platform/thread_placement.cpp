#include <cdr/platform/process_cpus.h>
#include <cdr/platform/thread_placement.h>

namespace cdr::platform {

PinnedThread::PinnedThread(std::size_t number, const std::vector<std::size_t>& cpus)
    : m_before(allowedCpus()) {
    if (!cpus.empty()) {
        allowCpus({cpus[number % cpus.size()]});
    }
}

PinnedThread::~PinnedThread() {
    allowCpus(m_before);
}

} // namespace cdr::platform
