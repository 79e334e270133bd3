#include "flip_window.h"

#include "picture_parts.h"

#include <cdr/base/error.h>
#include <cdr/measure/compare/wrong_pixels.h>

#include <algorithm>
#include <utility>

namespace cdr::viewer {

namespace {

/// Before anything that counts.
constexpr float kNever = -1e9f;

void readIds(const render::Frame& frame, image::ImageU32& ids) {
    if (ids.width != frame.width() || ids.height != frame.height()) {
        ids = image::ImageU32(frame.width(), frame.height());
    }
    std::ranges::transform(frame.gbuffer.pixels, ids.pixels.begin(), &render::GBufferPixel::id);
}

} // namespace

void FlipWindow::clear() {
    *this = {};
}

void FlipWindow::add(const render::Frame& frame, const render::Frame& reference, double seconds) {
    if (frame.width() != reference.width() || frame.height() != reference.height()) {
        throw base::InputError("flips: the two frames differ in size");
    }
    readIds(frame, m_now.ids);
    readIds(reference, m_now.answer);
    measure::innerMask(m_now.answer, m_now.inner);
    m_flipsNow = 0;
    m_seconds = seconds;
    if (m_before.ids.width != m_now.ids.width || m_before.ids.height != m_now.ids.height) {
        m_flippedAt = image::ImageFloat(frame.width(), frame.height(), kNever);
        m_start = seconds;
    } else {
        const auto now = static_cast<float>(seconds - m_start);
        for (std::size_t i = 0; i < m_flippedAt.pixels.size(); ++i) {
            const bool isSteady = (m_before.inner.pixels[i] & m_now.inner.pixels[i]) != 0 &&
                                  m_before.answer.pixels[i] == m_now.answer.pixels[i];
            const bool flips = isSteady && m_before.ids.pixels[i] != m_now.ids.pixels[i];
            m_flippedAt.pixels[i] = flips ? now : m_flippedAt.pixels[i];
            m_flipsNow += flips;
        }
    }
    std::swap(m_before, m_now);
}

void FlipWindow::paint(const render::Frame& frame, image::ImageRgba8& picture) const {
    if (frame.width() != m_flippedAt.width || frame.height() != m_flippedAt.height) {
        throw base::InputError("flips: the frame is not of the window's size");
    }
    resize(picture, frame.width(), frame.height());
    const auto now = static_cast<float>(m_seconds - m_start);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const std::uint8_t grey = measure::dimmed(frame.color.pixels[i])[0];
        const float age = now - m_flippedAt.pixels[i];
        const float fresh = std::max(0.0f, 1.0f - age / static_cast<float>(kSeconds));
        const float rest = (1.0f - fresh) * static_cast<float>(grey);
        const auto dim = static_cast<std::uint8_t>(rest);
        picture.pixels[i] = {static_cast<std::uint8_t>(rest + 255.0f * fresh), dim, dim, 255};
    }
}

std::uint64_t FlipWindow::pixelsInWindow() const {
    const auto oldest = static_cast<float>(m_seconds - m_start - kSeconds);
    return static_cast<std::uint64_t>(std::count_if(m_flippedAt.pixels.begin(), m_flippedAt.pixels.end(),
                                                    [oldest](float at) { return at > oldest; }));
}

} // namespace cdr::viewer
