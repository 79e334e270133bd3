#include "frame_notes.h"

#include <cdr/base/error.h>

#include <fmt/format.h>

namespace cdr::output {

namespace {

/// @param lists what there was no room for
std::string noteOnLists(const render::ListRefusal& refusal, std::string_view device,
                        const std::string& lists) {
    using Cause = render::ListRefusal::Cause;
    switch (refusal.cause) {
    case Cause::noFragmentStores:
        return fmt::format("{} lacks fragmentStoresAndAtomics", device);
    case Cause::storageBuffers:
        return fmt::format("{} has too few storage buffers in a fragment shader", device);
    case Cause::bound:
        return fmt::format("{} need {} bytes before the first fragment, {} are allowed", lists,
                           refusal.neededBytes, refusal.allowedBytes);
    case Cause::bufferSize:
        return fmt::format("{} need a {} byte buffer, {} allows {}", lists, refusal.neededBytes, device,
                           refusal.allowedBytes);
    case Cause::memory:
        return fmt::format("{} need {} bytes, {} has {} free", lists, refusal.neededBytes, device,
                           refusal.allowedBytes);
    }
    throw base::RunError("refusal out of range");
}

} // namespace

std::string noteOn(const render::ListRefusal& refusal, std::string_view device, std::uint32_t width,
                   std::uint32_t height) {
    if (refusal.fragments == 0) {
        return noteOnLists(refusal, device, fmt::format("lists of a {}x{} picture", width, height));
    }
    const std::string fragments =
        fmt::format("{}{} translucent fragments", refusal.mayBeMore ? "at least " : "", refusal.fragments);
    if (refusal.cause == render::ListRefusal::Cause::bound) {
        return fmt::format("{} need {} MiB, {} are allowed", fragments, refusal.neededBytes >> 20u,
                           refusal.allowedBytes >> 20u);
    }
    return noteOnLists(refusal, device, fragments);
}

std::string_view noteOnLostEmission() {
    return "surfaces emit no light and occlusion textures are left out, since neither ambient occlusion per cascade nor a "
           "lens with a focus keeps them";
}

std::string_view noteOnLostMetallicRoughness() {
    return "surfaces are matt, since ambient occlusion per cascade takes the bits of metallic and roughness";
}

} // namespace cdr::output
