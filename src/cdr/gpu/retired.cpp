#include <cdr/gpu/commands.h>
#include <cdr/gpu/retired.h>

#include <algorithm>

namespace cdr::gpu {

Retired::~Retired() {
    try {
        for (const Batch& batch : m_batches) {
            waitAndReset(m_device, *batch.done);
        }
        if (!m_open.empty()) {
            finishQueue(m_device); // there may be no memory to wait with
        }
    } catch (...) {
        // A lost device runs nothing any more; it is reported where somebody waits for a frame.
    }
}

void Retired::free() {
    const auto running = std::find_if(m_batches.begin(), m_batches.end(), [&](const Batch& batch) {
        return vk::Device(m_device.handle()).getFenceStatus(*batch.done) != vk::Result::eSuccess;
    });
    m_batches.erase(m_batches.begin(), running);
}

void Retired::close() {
    if (m_open.empty()) {
        return;
    }
    std::list<Batch> made(1);
    Batch& batch = made.front();
    batch.done = vk::Device(m_device.handle()).createFenceUnique({});
    submit(m_device, {}, *batch.done); // signalled after all that was submitted before it
    // From here on nothing may throw, as the fence is in use.
    batch.objects.swap(m_open);
    m_batches.splice(m_batches.end(), made);
}

} // namespace cdr::gpu
