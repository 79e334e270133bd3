#include <cdr/render/submit/primary_path.h>

#include <utility>

namespace cdr::render {

PrimaryPath::PrimaryPath(const gpu::Device& device, std::unique_ptr<HostDraws> draws, const std::string& name)
    : m_device(device),
      m_draws(std::move(draws)),
      m_pools(device, vk::CommandBufferLevel::ePrimary, m_draws->workers().threads(), name),
      m_betweenPool(device, vk::CommandBufferLevel::ePrimary, name) {}

void PrimaryPath::begin(const FrameView&, const HostCommands&) {
    m_betweenPool.reset();
    m_pools.beginFrame();
    m_between = nullptr;
    m_parts.clear();
    m_commands.clear();
    m_ended = 0;
}

vk::CommandBuffer PrimaryPath::primary() {
    if (!m_between) {
        m_between = m_betweenPool.next();
        m_between.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    }
    return m_between;
}

void PrimaryPath::closeBetween() {
    if (m_between) {
        m_between.end();
        m_commands.push_back(std::exchange(m_between, nullptr));
    }
}

void PrimaryPath::drawScope(const GBufferScope& scope, std::span<const std::size_t> cascades) {
    closeBetween();
    const std::size_t perPart = scope.depthClear != nullptr ? 1 : cascades.size();
    for (std::size_t first = 0; first < cascades.size(); first += perPart) {
        const std::span<const std::size_t> drawn = cascades.subspan(first, perPart);
        m_parts.push_back(
            {.scope = scope, .cascades = {drawn.begin(), drawn.end()}, .slot = m_commands.size()});
        m_parts.back().scope.keepsColors = first > 0;
        m_commands.emplace_back();
    }
}

void PrimaryPath::recordPart(vk::CommandBuffer commands, const Part& part, const FrameView& view) const {
    commands.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    m_device.beginLabel(commands, labelOf(part.cascades).c_str());
    if (part.scope.keepsColors) {
        chainGBufferScopes(commands, part.scope);
    }
    beginGBufferScope(commands, part.scope, {});
    for (const std::size_t cascade : part.cascades) {
        m_draws->record(commands, {.cascade = cascade, .draws = m_draws->lists().range(cascade)}, view);
    }
    commands.endRendering();
    m_device.endLabel(commands);
    commands.end();
}

std::span<const vk::CommandBuffer> PrimaryPath::endDraws(const FrameView& view) {
    closeBetween();
    const visibility::DrawLists& lists = m_draws->lists();
    m_draws->workers().run(m_parts.size(), [&](std::size_t job, std::size_t worker) {
        const Part& part = m_parts[job];
        std::size_t draws = 0;
        for (const std::size_t cascade : part.cascades) {
            draws += lists.range(cascade).size();
        }
        const platform::JobSpan span(m_draws->trace(), worker, job, part.cascades.front(), draws);
        m_commands[part.slot] = m_pools.next(worker);
        recordPart(m_commands[part.slot], part, view);
    });
    m_draws->flush();
    m_parts.clear();
    return std::span(m_commands).subspan(std::exchange(m_ended, m_commands.size()));
}

} // namespace cdr::render
