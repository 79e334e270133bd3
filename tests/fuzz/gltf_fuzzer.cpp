#include <cdr/base/error.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/scene/gltf/import.h>
#include <cdr/scene/gltf/nodes/lights.h>
#include <cdr/scene/gltf/nodes/moving_lights.h>
#include <cdr/scene/world/check.h>

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace {

/// Lights that the importer lets through are usable, or refused in words.
void light(const std::vector<cdr::scene::GltfLight>& lights) {
    for (const cdr::scene::GltfLight& each : lights) {
        cdr::scene::requireUsable(cdr::scene::gltf::pointLightOf(each, glm::dvec3(0.0), 1.0), "light");
    }
}

/// Shows animations before, within and after their keyframes.
void play(cdr::scene::GltfImport import) {
    constexpr std::size_t kMaxAnimations = 4;
    light(import.lights);
    if (import.animation == nullptr) {
        return;
    }
    cdr::platform::WorkerPool workers(1);
    const std::size_t count = std::min(import.animation->animations.size(), kMaxAnimations);
    for (std::size_t i = 0; i < count; ++i) {
        const double seconds = import.animation->animations[i].seconds;
        const cdr::scene::FrameClock clock{.start = 0.0, .framesPerSecond = 3.0 / std::max(seconds, 1e-6)};
        const cdr::scene::SceneMotion motion = cdr::scene::motionOf(import.animation, i, clock);
        const cdr::scene::gltf::MovingLights lights(import, i, clock);
        for (const std::uint32_t frame : {0u, 1u, 2u, 5u}) {
            cdr::scene::show(import.scene, motion, frame, workers);
            lights.place(import.lights, frame);
            light(import.lights);
        }
    }
}

/// The bytes in a file that has no name, so that they are read block by block.
cdr::scene::gltf::ByteSource inFile(std::span<const std::uint8_t> bytes) {
    static const int kFile = memfd_create("gltf_fuzzer", MFD_CLOEXEC);
    if (ftruncate(kFile, 0) != 0 ||
        pwrite(kFile, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
        std::abort();
    }
    return cdr::scene::gltf::ByteSource(std::make_shared<const cdr::scene::gltf::OpenFile>(
        "/proc/self/fd/" + std::to_string(kFile), bytes.size(), ""));
}

} // namespace

/// Any bytes load and play, or are refused with base::InputError. Anything else that importGltf() throws is a bug.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    cdr::scene::GltfLimits limits;
    limits.maxFileBytes = 1u << 20;
    limits.maxTriangles = 10'000;
    limits.maxBytes = 64u << 20;
    limits.threads = 1;
    if (size % 2 != 0) {
        limits.textureMemory = 1u << 12;
    }
    if (size % 3 != 0) {
        limits.pointRadius = 0.25;
    }
    try {
        // The folder does not exist, so no input can reach a real file.
        const std::span bytes(data, size);
        play(cdr::scene::gltf::importGltf(size % 4 < 2 ? cdr::scene::gltf::ByteSource(bytes) : inFile(bytes),
                                          "/nowhere/a.glb", limits));
    } catch (const cdr::base::InputError&) {
    }
    return 0;
}
