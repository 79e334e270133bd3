#pragma once

#include <cdr/gpu/commands.h>
#include <cdr/gpu/memory.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/retired.h>
#include <cdr/render/upload/deformer_words.h>
#include <cdr/scene/animation/mesh_pose.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace cdr::render {

/// A mesh that the device is to deform.
struct DeformJob {
    std::uint32_t mesh = 0;                 ///< of the scene
    const scene::MeshPose* pose = nullptr;  ///< never null
    std::span<const std::uint32_t> indices; ///< of its triangles
    std::size_t firstVertex = 0;            ///< in the buffers that are written
};

/// Deforms meshes by a compute pass (shaders/deform/deform.comp), into the buffers that all passes read. Deformers are
/// uploaded once, and poses each time. It does not wait: what is submitted later reads the new vertices, and what was
/// submitted before the old ones.
class DeviceDeformer {
  public:
    /// base::InputError when the device cannot do it, naming what it lacks.
    explicit DeviceDeformer(const gpu::Device& device);
    /// Waits for what is in flight.
    ~DeviceDeformer();
    DeviceDeformer(const DeviceDeformer&) = delete;
    DeviceDeformer& operator=(const DeviceDeformer&) = delete;

    /// What is written.
    struct Into {
        const gpu::Buffer& vertices; ///< PackedVertices, with their colours and places in textures
        const gpu::Buffer& details;  ///< PackedDetails, or empty
    };
    /// Uploads the deformers of jobs that are not there yet, which waits. base::RunError with both figures where one is too
    /// large for the device.
    void provide(std::span<const DeformJob> jobs);
    /// staysFaceted() of a mesh whose deformer provide() knows.
    bool isFaceted(std::uint32_t mesh) const { return m_uploaded.at(mesh).isFaceted; }
    /// Drops the deformers of meshes; nothing: of all.
    void forget(const std::optional<std::span<const std::uint32_t>>& meshes, gpu::Retired& retired);
    /// Submits the work, of which provide() knows the deformers.
    /// @param before records what is to come before it
    void run(std::span<const DeformJob> jobs, const Into& into,
             const std::function<void(vk::CommandBuffer)>& before);

  private:
    /// A deformer on the device.
    struct Uploaded {
        std::shared_ptr<const scene::Deformer> deformer; ///< that it was made of, which stays as it is
        gpu::Buffer words;
        shaders::DeformPush push{};
        bool isFaceted = false; ///< asked once, since it takes time by triangles
    };
    /// What one submission uses.
    struct Slot {
        explicit Slot(const gpu::Device& device);

        gpu::CommandPool commands;
        vk::UniqueFence done;
        bool isPending = false;
        gpu::Buffer poses;
        vk::UniqueDescriptorPool pool;
        std::vector<vk::DescriptorSet> sets; ///< one for each job, at least
    };
    Slot& takeSlot();
    /// Where the numbers of each job begin, in bytes.
    std::vector<std::size_t> stage(Slot& slot, std::span<const DeformJob> jobs) const;
    void provideSets(Slot& slot, std::size_t jobs) const;
    /// Where the numbers of a pose are.
    struct StagedPose {
        vk::Buffer buffer;
        std::size_t firstByte = 0;
    };
    void record(vk::CommandBuffer commands, vk::DescriptorSet set, const StagedPose& staged,
                const DeformJob& job, const Into& into) const;

    const gpu::Device& m_device;
    std::size_t m_alignment; ///< of what is bound, in bytes
    gpu::SetLayout m_setLayout;
    gpu::PipelineLayout m_layout;
    gpu::Pipeline m_pipeline;
    std::map<std::uint32_t, Uploaded> m_uploaded; ///< by mesh
    std::vector<std::unique_ptr<Slot>> m_slots;
};

} // namespace cdr::render
