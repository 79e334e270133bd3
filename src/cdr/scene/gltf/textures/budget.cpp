#include "budget.h"

#include <cdr/image/levels.h>

#include <cstddef>
#include <queue>
#include <utility>

namespace cdr::scene::gltf {

namespace {

constexpr std::uint64_t kBytesPerPixel = sizeof(image::Rgba8);

std::uint64_t bytesOf(const TextureNeed& texture, std::uint32_t dropped) {
    const std::uint32_t levels = image::levelCount(texture.size.width, texture.size.height);
    const std::uint32_t end = texture.hasLevels ? levels : dropped + 1;
    return kBytesPerPixel * (image::levelPixels(texture.size.width, texture.size.height, end) -
                             image::levelPixels(texture.size.width, texture.size.height, dropped));
}

} // namespace

std::uint64_t textureBytes(std::span<const TextureNeed> textures, std::span<const std::uint32_t> dropped) {
    std::uint64_t bytes = 0;
    for (std::size_t i = 0; i < textures.size(); ++i) {
        bytes += bytesOf(textures[i], dropped[i]);
    }
    return bytes;
}

std::vector<std::uint32_t> levelsToDrop(std::span<const TextureNeed> textures, std::uint64_t bytes) {
    std::vector<std::uint32_t> dropped(textures.size(), 0);
    std::uint64_t total = textureBytes(textures, dropped);
    // Largest first, then by index.
    using Candidate = std::pair<std::uint64_t, std::size_t>;
    std::priority_queue<Candidate> largest;
    const auto push = [&](std::size_t i) {
        if (dropped[i] + 1 < image::levelCount(textures[i].size.width, textures[i].size.height)) {
            largest.emplace(bytesOf(textures[i], dropped[i]), textures.size() - i);
        }
    };
    for (std::size_t i = 0; i < textures.size(); ++i) {
        push(i);
    }
    while (total > bytes && !largest.empty()) {
        const auto [before, fromEnd] = largest.top();
        largest.pop();
        const std::size_t i = textures.size() - fromEnd;
        total -= before - bytesOf(textures[i], ++dropped[i]);
        push(i);
    }
    return dropped;
}

} // namespace cdr::scene::gltf
