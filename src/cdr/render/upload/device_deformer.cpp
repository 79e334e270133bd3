#include <cdr/base/format_error.h>
#include <cdr/gpu/rounding.h>
#include <cdr/gpu/upload.h>
#include <cdr/render/materials/packed_vertex.h>
#include <cdr/render/render_options.h>
#include <cdr/render/upload/device_deformer.h>
#include <cdr/shaders/deform.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

namespace cdr::render {

namespace {

using Stage = vk::PipelineStageFlagBits2;
using Touch = vk::AccessFlagBits2;

constexpr std::uint32_t kDeformBuffers = 4;
/// As many submissions as frames may be in flight, and the one that is made.
constexpr std::size_t kMaxSlots = kMaxFramesInFlight + 1;

const gpu::Device& deforming(const gpu::Device& device) {
    const gpu::DeviceInfo& info = device.info();
    if (!info.deformMissing.empty()) {
        throw base::inputError("{} cannot deform meshes: it lacks {}", info.name,
                               fmt::join(info.deformMissing, ", "));
    }
    return device;
}

std::size_t roundedUp(std::size_t bytes, std::size_t step) {
    return (bytes + step - 1) / step * step;
}

/// A part of a buffer that may be bound: it begins at or before what is asked for.
vk::DescriptorBufferInfo boundPart(const gpu::Buffer& buffer, std::size_t first, std::size_t bytes,
                                   std::size_t alignment) {
    const std::size_t begin = first / alignment * alignment;
    return {.buffer = buffer.handle(), .offset = begin, .range = first + bytes - begin};
}

/// Where in it that begins, in words.
std::uint32_t firstWordIn(const vk::DescriptorBufferInfo& part, std::size_t first) {
    return static_cast<std::uint32_t>((first - part.offset) / sizeof(std::uint32_t));
}

std::uint64_t invocationsOf(const shaders::DeformPush& push) {
    return (push.flags & shaders::kDeformFlat) != 0 ? push.vertices / 3 : push.vertices;
}

std::uint64_t groupsOf(const shaders::DeformPush& push) {
    return (invocationsOf(push) + shaders::kDeformBlock - 1) / shaders::kDeformBlock;
}

} // namespace

DeviceDeformer::Slot::Slot(const gpu::Device& device)
    : commands(device, vk::CommandBufferLevel::ePrimary, "deform pool"),
      done(vk::Device(device.handle()).createFenceUnique({})) {}

DeviceDeformer::DeviceDeformer(const gpu::Device& device)
    : m_device(deforming(device)),
      m_alignment(std::max<std::size_t>(
          sizeof(double),
          vk::PhysicalDevice(device.physical()).getProperties().limits.minStorageBufferOffsetAlignment)),
      m_setLayout(gpu::makeSetLayout(device,
                                     {std::vector(kDeformBuffers, vk::DescriptorType::eStorageBuffer),
                                      vk::ShaderStageFlagBits::eCompute},
                                     "deform set")),
      m_layout(gpu::makePipelineLayout(
          device,
          {{m_setLayout},
           {{.stageFlags = vk::ShaderStageFlagBits::eCompute, .size = sizeof(shaders::DeformPush)}}},
          "deform layout")),
      m_pipeline(
          gpu::makeComputePipeline(device, {"deform", gpu::roundingToNearestEven(kDeformComp), m_layout})) {}

DeviceDeformer::~DeviceDeformer() {
    for (const std::unique_ptr<Slot>& slot : m_slots) {
        try {
            if (slot->isPending) {
                gpu::waitAndReset(m_device, *slot->done);
            }
        } catch (...) {
            // A lost device is reported where somebody waits for a frame.
        }
    }
}

void DeviceDeformer::provide(std::span<const DeformJob> jobs) {
    for (const DeformJob& job : jobs) {
        const std::shared_ptr<const scene::Deformer>& deformer = job.pose->deformer;
        const auto found = m_uploaded.find(job.mesh);
        if (found != m_uploaded.end() && found->second.deformer == deformer) {
            continue;
        }
        const std::uint64_t bytes = countWords(*deformer) * sizeof(std::uint32_t);
        const std::string what = fmt::format("mesh {}, which the device deforms,", job.mesh);
        if (bytes > m_device.info().maxStorageBufferBytes) {
            throw base::runError("{} needs a {} byte buffer, {} allows {}", what, bytes, m_device.info().name,
                                 m_device.info().maxStorageBufferBytes);
        }
        gpu::requireDeviceBytes(m_device, bytes, what);
        const DeformerWords made = wordsOf(*deformer);
        gpu::requireGroups(m_device, groupsOf(made.push), what);
        gpu::waitForQueue(m_device); // what is replaced may be in use
        m_uploaded[job.mesh] = {.deformer = deformer,
                                .words =
                                    gpu::uploadBuffer(m_device, std::as_bytes(std::span(made.words)),
                                                      vk::BufferUsageFlagBits::eStorageBuffer, "deformer"),
                                .push = made.push,
                                .isFaceted = staysFaceted(*deformer, job.indices)};
    }
}

void DeviceDeformer::forget(const std::optional<std::span<const std::uint32_t>>& meshes,
                            gpu::Retired& retired) {
    if (!meshes) {
        retired.add(std::exchange(m_uploaded, {}));
        return;
    }
    for (const std::uint32_t mesh : *meshes) {
        if (auto gone = m_uploaded.extract(mesh)) {
            retired.add(std::move(gone.mapped()));
        }
    }
}

DeviceDeformer::Slot& DeviceDeformer::takeSlot() {
    const auto isFree = [&](const std::unique_ptr<Slot>& slot) {
        return !slot->isPending ||
               vk::Device(m_device.handle()).getFenceStatus(*slot->done) == vk::Result::eSuccess;
    };
    const auto found = std::find_if(m_slots.begin(), m_slots.end(), isFree);
    if (found == m_slots.end() && m_slots.size() < kMaxSlots) {
        m_slots.push_back(std::make_unique<Slot>(m_device));
        return *m_slots.back();
    }
    Slot& slot = found != m_slots.end() ? **found : *m_slots.front();
    if (slot.isPending) {
        gpu::waitAndReset(m_device, *slot.done);
        slot.isPending = false;
    }
    return slot;
}

std::vector<std::size_t> DeviceDeformer::stage(Slot& slot, std::span<const DeformJob> jobs) const {
    std::vector<std::size_t> firsts;
    std::size_t bytes = 0;
    for (const DeformJob& job : jobs) {
        firsts.push_back(bytes);
        bytes += roundedUp(countNumbers(*job.pose) * sizeof(double), m_alignment);
    }
    if (slot.poses.size() < bytes) {
        slot.poses = gpu::Buffer(m_device, bytes, vk::BufferUsageFlagBits::eStorageBuffer,
                                 gpu::MemoryUse::hostWrites, "poses");
    }
    const std::span<double> numbers = slot.poses.as<double>(slot.poses.size() / sizeof(double));
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        writeNumbers(*jobs[i].pose, numbers.subspan(firsts[i] / sizeof(double), countNumbers(*jobs[i].pose)));
    }
    slot.poses.flush();
    return firsts;
}

void DeviceDeformer::provideSets(Slot& slot, std::size_t jobs) const {
    if (slot.sets.size() >= jobs) {
        return;
    }
    slot.sets.clear();
    slot.pool = gpu::makeDescriptorPool(m_device, m_setLayout, static_cast<std::uint32_t>(jobs));
    while (slot.sets.size() < jobs) {
        slot.sets.push_back(gpu::allocateSet(m_device, *slot.pool, m_setLayout));
    }
}

void DeviceDeformer::record(vk::CommandBuffer commands, vk::DescriptorSet set, const StagedPose& staged,
                            const DeformJob& job, const Into& into) const {
    const Uploaded& uploaded = m_uploaded.at(job.mesh);
    const std::size_t count = uploaded.push.vertices;
    const bool writesDetails = into.details.size() != 0 && !uploaded.deformer->details.empty();
    const auto vertices = boundPart(into.vertices, job.firstVertex * sizeof(PackedVertex),
                                    count * sizeof(PackedVertex), m_alignment);
    const auto details = writesDetails ? boundPart(into.details, job.firstVertex * sizeof(PackedDetail),
                                                   count * sizeof(PackedDetail), m_alignment)
                                       : vertices; // something must be bound
    const std::array<vk::DescriptorBufferInfo, kDeformBuffers> buffers{
        {{.buffer = uploaded.words.handle(), .range = VK_WHOLE_SIZE},
         {.buffer = staged.buffer,
          .offset = staged.firstByte,
          .range = countNumbers(*job.pose) * sizeof(double)},
         vertices,
         details}};
    vk::Device(m_device.handle())
        .updateDescriptorSets(vk::WriteDescriptorSet{.dstSet = set,
                                                     .descriptorCount = kDeformBuffers,
                                                     .descriptorType = vk::DescriptorType::eStorageBuffer,
                                                     .pBufferInfo = buffers.data()},
                              {});
    shaders::DeformPush push = uploaded.push;
    push.weights =
        static_cast<std::uint32_t>(std::min(job.pose->weights.size(), uploaded.deformer->targets.size()));
    push.firstVertexWord = firstWordIn(vertices, job.firstVertex * sizeof(PackedVertex));
    push.firstDetailWord = writesDetails ? firstWordIn(details, job.firstVertex * sizeof(PackedDetail)) : 0;
    push.flags |= writesDetails ? shaders::kDeformDetails : 0u;
    push.flags |= job.pose->joints.empty() ? 0u : shaders::kDeformSkin;
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *m_layout, 0, set, {});
    commands.pushConstants<shaders::DeformPush>(*m_layout, vk::ShaderStageFlagBits::eCompute, 0, push);
    commands.dispatch(static_cast<std::uint32_t>(groupsOf(push)), 1, 1);
}

void DeviceDeformer::run(std::span<const DeformJob> jobs, const Into& into,
                         const std::function<void(vk::CommandBuffer)>& before) {
    Slot& slot = takeSlot();
    const std::vector<std::size_t> firsts = stage(slot, jobs);
    provideSets(slot, jobs.size());
    slot.commands.reset();
    const vk::CommandBuffer commands = gpu::beginOnce(slot.commands);
    before(commands);
    // What earlier frames read, and what was written before.
    gpu::memoryBarrier(commands, Stage::eVertexAttributeInput | Stage::eComputeShader | Stage::eAllTransfer,
                       Touch::eShaderStorageWrite | Touch::eTransferWrite, Stage::eComputeShader,
                       Touch::eShaderStorageRead | Touch::eShaderStorageWrite);
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, *m_pipeline);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        if (m_uploaded.at(jobs[i].mesh).push.vertices > 0) {
            record(commands, slot.sets[i], {slot.poses.handle(), firsts[i]}, jobs[i], into);
        }
    }
    gpu::memoryBarrier(commands, Stage::eComputeShader, Touch::eShaderStorageWrite,
                       Stage::eVertexAttributeInput | Stage::eAllTransfer,
                       Touch::eVertexAttributeRead | Touch::eTransferRead | Touch::eTransferWrite);
    commands.end();
    gpu::submit(m_device, {&commands, 1}, *slot.done);
    slot.isPending = true;
}

} // namespace cdr::render
