#include <cdr/base/error.h>
#include <cdr/host/worker_pool.h>
#include <cdr/scene/gltf/import.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace {

/// Shows animations before, within and after their keyframes.
void play(cdr::scene::GltfImport import) {
    constexpr std::size_t kMostAnimations = 4;
    if (import.animation == nullptr) {
        return;
    }
    cdr::host::WorkerPool workers(1);
    const std::size_t count = std::min(import.animation->animations.size(), kMostAnimations);
    for (std::size_t i = 0; i < count; ++i) {
        const double seconds = import.animation->animations[i].seconds;
        const cdr::scene::FrameClock clock{.start = 0.0, .framesPerSecond = 3.0 / std::max(seconds, 1e-6)};
        const cdr::scene::SceneMotion motion = cdr::scene::motionOf(import.animation, i, clock);
        for (const std::uint32_t frame : {0u, 1u, 2u, 5u}) {
            cdr::scene::show(import.scene, motion, frame, workers);
        }
    }
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
    try {
        // The folder does not exist, so no input can reach a real file.
        play(cdr::scene::gltf::importGltf({data, size}, "/nowhere/a.glb", limits));
    } catch (const cdr::base::InputError&) {
    }
    return 0;
}
