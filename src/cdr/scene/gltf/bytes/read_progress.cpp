#include "read_progress.h"

#include <algorithm>
#include <utility>

namespace cdr::scene::gltf {

namespace {

constexpr std::uint64_t kTold = 100; ///< times, about

} // namespace

ReadProgress::ReadProgress(ImportProgress tell, std::uint64_t all)
    : m_tell(std::move(tell)),
      m_all(std::max<std::uint64_t>(all, 1)) {}

void ReadProgress::begin(std::uint64_t bytes) {
    read(m_end - m_done);
    m_end = std::min(m_end + bytes, m_all);
}

void ReadProgress::read(std::uint64_t bytes) {
    m_done += std::min(bytes, m_end - m_done);
    if (m_done >= m_next) {
        tell();
    }
}

void ReadProgress::tell() {
    m_next = m_done + m_all / kTold + 1;
    if (m_tell && m_told != m_done) {
        m_told = m_done;
        m_tell(m_done, m_all);
    }
}

} // namespace cdr::scene::gltf
