#include <cdr/base/error.h>
#include <cdr/scene/gltf/import.h>

#include <cstddef>
#include <cstdint>

/// Any bytes load, or are refused with base::InputError. Anything else that importGltf() throws is a bug.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    cdr::scene::GltfLimits limits;
    limits.maxFileBytes = 1u << 20;
    limits.maxTriangles = 10'000;
    limits.maxBytes = 64u << 20;
    try {
        // The folder does not exist, so no input can reach a real file.
        cdr::scene::gltf::importGltf({data, size}, "/nowhere/a.glb", limits);
    } catch (const cdr::base::InputError&) {
    }
    return 0;
}
