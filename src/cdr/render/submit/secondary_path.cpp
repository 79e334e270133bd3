#include <cdr/render/submit/secondary_path.h>

#include <algorithm>
#include <utility>

namespace cdr::render {

namespace {

/// Jobs per thread: enough to even out, few enough that secondaries stay long.
constexpr std::size_t kJobsPerThread = 4;
/// A secondary costs about as much to begin and execute as this many draws to record.
constexpr std::size_t kMinDrawsPerJob = 256;

} // namespace

std::vector<DrawJob> makeJobs(const visibility::DrawLists& lists, std::size_t threads) {
    const std::size_t wanted = threads == 1 ? 1 : threads * kJobsPerThread;
    const std::size_t grain = std::max((lists.draws() + wanted - 1) / wanted, kMinDrawsPerJob);
    std::vector<DrawJob> jobs;
    for (std::size_t cascade = 0; cascade < lists.cascades(); ++cascade) {
        const platform::IndexRange all = lists.range(cascade);
        const std::size_t parts =
            threads == 1 ? std::min<std::size_t>(all.size(), 1) : (all.size() + grain - 1) / grain;
        for (std::size_t part = 0; part < parts; ++part) {
            const platform::IndexRange range = platform::evenRange(all.size(), part, parts);
            jobs.push_back({.cascade = cascade, .draws = {all.begin + range.begin, all.begin + range.end}});
        }
    }
    return jobs;
}

SecondaryPath::SecondaryPath(const gpu::Device& device, std::unique_ptr<HostDraws> draws,
                             const std::string& name)
    : OnePrimaryPath(device, name, vk::RenderingFlagBits::eContentsSecondaryCommandBuffers),
      m_draws(std::move(draws)),
      m_pools(device, vk::CommandBufferLevel::eSecondary, m_draws->workers().threads(), name),
      m_hostPool(device, vk::CommandBufferLevel::eSecondary, name + " host") {}

void SecondaryPath::begin(const FrameView& view, const HostCommands& host) {
    recordJobs(view);
    m_draws->flush();
    recordHost(view.drawn, host);
    beginPrimary(host.into);
}

void SecondaryPath::recordHost(platform::IndexRange cascades, const HostCommands& host) {
    m_hostCommands.clear();
    if (!host.draw) {
        return;
    }
    const ScopeFormats formats = m_draws->formats();
    m_hostPool.reset();
    m_hostCommands.resize(cascades.end);
    for (std::size_t cascade = cascades.begin; cascade < cascades.end; ++cascade) {
        const vk::CommandBuffer commands = m_hostPool.next();
        beginSecondary(commands, formats, vk::CommandBufferUsageFlagBits::eOneTimeSubmit);
        host.draw(commands, cascade);
        commands.end();
        m_hostCommands[cascade] = commands;
    }
}

void SecondaryPath::recordJobs(const FrameView& view) {
    const visibility::DrawLists& lists = m_draws->lists();
    m_pools.beginFrame();
    m_jobs = makeJobs(lists, m_pools.workers());
    m_commands.assign(m_jobs.size(), nullptr);
    m_cascadeBegins.assign(lists.cascades() + 1, m_jobs.size());
    for (std::size_t job = m_jobs.size(); job-- > 0;) {
        std::fill_n(m_cascadeBegins.begin(), m_jobs[job].cascade + 1, job);
    }
    const ScopeFormats formats = m_draws->formats();
    m_draws->workers().run(m_jobs.size(), [&](std::size_t job, std::size_t worker) {
        const DrawJob& work = m_jobs[job];
        const platform::JobSpan span(m_draws->trace(), worker, job, work.cascade, work.draws.size());
        const vk::CommandBuffer commands = m_pools.next(worker);
        beginSecondary(commands, formats, vk::CommandBufferUsageFlagBits::eOneTimeSubmit);
        m_draws->record(commands, work, view);
        commands.end();
        m_commands[job] = commands;
    });
}

void SecondaryPath::drawInside(platform::IndexRange cascades) {
    const auto execute = [&](std::size_t begin, std::size_t end) {
        if (end > begin) {
            primary().executeCommands(static_cast<std::uint32_t>(end - begin), &m_commands[begin]);
        }
    };
    if (m_hostCommands.empty()) {
        execute(m_cascadeBegins[cascades.begin], m_cascadeBegins[cascades.end]);
    } else {
        for (std::size_t cascade = cascades.begin; cascade < cascades.end; ++cascade) {
            execute(m_cascadeBegins[cascade], m_cascadeBegins[cascade + 1]);
            if (const vk::CommandBuffer commands = hostCommandsOf(cascade)) {
                primary().executeCommands(commands);
            }
        }
    }
}

} // namespace cdr::render
