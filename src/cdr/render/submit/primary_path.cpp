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
    m_scopes.clear();
    m_commands.clear();
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

void PrimaryPath::drawScope(const GBufferScope& scope, host::IndexRange cascades) {
    closeBetween();
    m_scopes.push_back({.scope = scope, .cascades = cascades, .slot = m_commands.size()});
    m_commands.emplace_back();
}

void PrimaryPath::recordScope(vk::CommandBuffer commands, const Scope& scope, const FrameView& view) const {
    commands.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    m_device.beginLabel(commands, labelOf(scope.cascades).c_str());
    beginGBufferScope(commands, scope.scope, {});
    for (std::size_t cascade = scope.cascades.begin; cascade < scope.cascades.end; ++cascade) {
        m_draws->record(commands, {.cascade = cascade, .draws = m_draws->lists().range(cascade)}, view);
    }
    commands.endRendering();
    m_device.endLabel(commands);
    commands.end();
}

std::span<const vk::CommandBuffer> PrimaryPath::end(const FrameView& view) {
    closeBetween();
    const visibility::DrawLists& lists = m_draws->lists();
    m_draws->workers().run(m_scopes.size(), [&](std::size_t job, std::size_t worker) {
        const Scope& scope = m_scopes[job];
        const host::IndexRange draws{lists.range(scope.cascades.begin).begin,
                                     lists.range(scope.cascades.end - 1).end};
        const host::JobSpan span(m_draws->trace(), worker, job, scope.cascades.begin, draws.size());
        m_commands[scope.slot] = m_pools.next(worker);
        recordScope(m_commands[scope.slot], scope, view);
    });
    m_draws->flush();
    return m_commands;
}

} // namespace cdr::render
