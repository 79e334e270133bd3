#include <cdr/render/cascade_recorder.h>
#include <cdr/render/gbuffer.h>

#include <algorithm>

namespace cdr::render {

namespace {

/// Jobs per thread: enough to even out, few enough that secondaries stay long.
constexpr std::size_t kJobsPerThread = 4;
/// A secondary costs about as much to begin and execute as this many draws to record.
constexpr std::size_t kMinDrawsPerJob = 256;

} // namespace

std::vector<DrawJob> makeJobs(const scene::DrawLists& lists, std::size_t threads) {
    const std::size_t wanted = threads == 1 ? 1 : threads * kJobsPerThread;
    const std::size_t grain = std::max((lists.draws() + wanted - 1) / wanted, kMinDrawsPerJob);
    std::vector<DrawJob> jobs;
    for (std::size_t cascade = 0; cascade < lists.cascades(); ++cascade) {
        const base::IndexRange all = lists.range(cascade);
        const std::size_t parts =
            threads == 1 ? std::min<std::size_t>(all.size(), 1) : (all.size() + grain - 1) / grain;
        for (std::size_t part = 0; part < parts; ++part) {
            const base::IndexRange range = base::evenRange(all.size(), part, parts);
            jobs.push_back({.cascade = cascade, .draws = {all.begin + range.begin, all.begin + range.end}});
        }
    }
    return jobs;
}

CascadeRecorder::CascadeRecorder(const gpu::Device& device, std::size_t threads, const std::string& name) {
    for (std::size_t worker = 0; worker < threads; ++worker) {
        m_pools.emplace_back(device, vk::CommandBufferLevel::eSecondary,
                             name + " worker " + std::to_string(worker));
    }
}

void CascadeRecorder::record(base::WorkerPool& workers, const GeometryPass& pass,
                             const GeometryPass::Recording& recording) {
    for (gpu::CommandPool& pool : m_pools) {
        pool.reset();
    }
    m_jobs = makeJobs(recording.lists, workers.threads());
    m_commands.assign(m_jobs.size(), nullptr);
    m_cascadeBegins.assign(recording.lists.cascades() + 1, m_jobs.size());
    for (std::size_t job = m_jobs.size(); job-- > 0;) {
        std::fill_n(m_cascadeBegins.begin(), m_jobs[job].cascade + 1, job);
    }
    const vk::CommandBufferInheritanceRenderingInfo rendering{.colorAttachmentCount = 1,
                                                              .pColorAttachmentFormats = &kGBufferFormat,
                                                              .depthAttachmentFormat = pass.depthFormat(),
                                                              .rasterizationSamples =
                                                                  vk::SampleCountFlagBits::e1};
    const vk::CommandBufferInheritanceInfo inheritance{.pNext = &rendering};
    const vk::CommandBufferBeginInfo begin{.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit |
                                                    vk::CommandBufferUsageFlagBits::eRenderPassContinue,
                                           .pInheritanceInfo = &inheritance};
    workers.run(m_jobs.size(), [&](std::size_t job, std::size_t worker) {
        const DrawJob& work = m_jobs[job];
        const base::JobSpan span(recording.trace, worker, job, work.cascade, work.draws.size());
        const vk::CommandBuffer commands = m_pools[worker].next();
        commands.begin(begin);
        pass.record(commands, work, recording);
        commands.end();
        m_commands[job] = commands;
    });
}

std::span<const vk::CommandBuffer> CascadeRecorder::commands(std::size_t cascade) const {
    const std::size_t begin = m_cascadeBegins[cascade];
    return std::span(m_commands).subspan(begin, m_cascadeBegins[cascade + 1] - begin);
}

} // namespace cdr::render
