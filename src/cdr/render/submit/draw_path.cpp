#include <cdr/render/submit/draw_path.h>
#include <cdr/render/targets/scope_commands.h>

#include <fmt/format.h>

#include <utility>

namespace cdr::render {

std::string labelOf(std::span<const std::size_t> cascades) {
    return cascades.size() == 1 ? fmt::format("cascade {}", cascades.front())
                                : fmt::format("cascades {} to {}", cascades.front(), cascades.back());
}

OnePrimaryPath::OnePrimaryPath(const gpu::Device& device, const std::string& name, vk::RenderingFlags flags)
    : m_device(device),
      m_pool(device, vk::CommandBufferLevel::ePrimary, name),
      m_flags(flags) {}

void OnePrimaryPath::beginPrimary(vk::CommandBuffer host) {
    m_isOwn = !host;
    m_primary = host;
    if (m_isOwn) {
        m_pool.reset();
        m_primary = gpu::beginOnce(m_pool);
    }
}

void OnePrimaryPath::drawScope(const GBufferScope& scope, std::span<const std::size_t> cascades) {
    m_device.beginLabel(m_primary, labelOf(cascades).c_str());
    beginGBufferScope(m_primary, scope, m_flags);
    for (const std::size_t cascade : cascades) {
        if (scope.depthClear != nullptr && cascade != cascades.front()) {
            scope.depthClear->putInto(m_primary, m_flags);
        }
        drawCascade(cascade);
    }
    m_primary.endRendering();
    m_device.endLabel(m_primary);
}

std::span<const vk::CommandBuffer> OnePrimaryPath::endDraws(const FrameView&) {
    if (!m_isOwn) {
        return {};
    }
    m_primary.end();
    m_endedDraws = std::exchange(m_primary, gpu::beginOnce(m_pool));
    return {&m_endedDraws, 1};
}

std::span<const vk::CommandBuffer> OnePrimaryPath::end(const FrameView&) {
    if (!m_isOwn) {
        return {};
    }
    m_primary.end();
    return {&m_primary, 1};
}

} // namespace cdr::render
