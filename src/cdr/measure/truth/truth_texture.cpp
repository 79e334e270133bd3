#include <cdr/image/compose.h>
#include <cdr/image/srgb.h>
#include <cdr/measure/truth/truth_texture.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace cdr::measure {

namespace {

/// Where a texel beyond an edge is found.
/// @param i a whole number of any size. What is not a number finds the first.
std::uint32_t wrapped(double i, double size, scene::WrapMode mode) {
    if (i >= 0.0 && i < size) {
        return static_cast<std::uint32_t>(i);
    }
    if (mode == scene::WrapMode::clampToEdge) {
        return i > 0.0 ? static_cast<std::uint32_t>(size - 1.0) : 0;
    }
    const double period = mode == scene::WrapMode::mirroredRepeat ? 2.0 * size : size;
    const double rest = std::fmod(i, period);
    const double inPeriod = rest < 0.0 ? rest + period : rest;
    const double texel = inPeriod < size ? inPeriod : period - 1.0 - inPeriod;
    return texel > 0.0 ? static_cast<std::uint32_t>(texel) : 0;
}

glm::dvec4 linearOf(const image::Rgba8& texel, scene::TextureContent content) {
    if (content == scene::TextureContent::data) {
        return glm::dvec4(texel[0], texel[1], texel[2], texel[3]) / 255.0;
    }
    const auto& linear = image::linearOfSrgb();
    return {linear[texel[0]], linear[texel[1]], linear[texel[2]], texel[3] / 255.0};
}

/// A picture of a texture, the first or a smaller one, at a place.
/// @param texelAt (x, y) inside of the picture.
template <typename TexelAt>
glm::dvec4 readAt(const scene::Texture& texture, const glm::dvec2& size, scene::Filter filter,
                  const glm::dvec2& uv, TexelAt texelAt) {
    const auto at = [&](double x, double y) -> glm::dvec4 {
        return texelAt(wrapped(x, size.x, texture.wrapU), wrapped(y, size.y, texture.wrapV));
    };
    if (filter == scene::Filter::nearest) {
        const glm::dvec2 texel = glm::floor(uv * size);
        return at(texel.x, texel.y);
    }
    const glm::dvec2 place = uv * size - 0.5;
    const glm::dvec2 corner = glm::floor(place);
    const glm::dvec2 share = place - corner;
    return glm::mix(glm::mix(at(corner.x, corner.y), at(corner.x + 1.0, corner.y), share.x),
                    glm::mix(at(corner.x, corner.y + 1.0), at(corner.x + 1.0, corner.y + 1.0), share.x),
                    share.y);
}

glm::dvec4 readFirst(const scene::Texture& texture, scene::Filter filter, const glm::dvec2& uv) {
    return readAt(
        texture, {texture.pixels.width, texture.pixels.height}, filter, uv,
        [&](std::uint32_t x, std::uint32_t y) { return linearOf(texture.pixels.at(x, y), texture.content); });
}

/// How much of the span [begin, end) of a side the texel i covers.
double overlap(double begin, double end, std::uint32_t i) {
    return std::max(0.0, std::min(end, i + 1.0) - std::max<double>(begin, i));
}

/// The average of a rectangle of a texture's picture; bounds in texels. Colours count by their alpha where the texture says
/// so, unless all is clear.
glm::vec4 average(const scene::Texture& texture, const glm::dvec2& begin, const glm::dvec2& end) {
    glm::dvec4 sum(0.0);
    glm::dvec3 seen(0.0);
    const auto lastX = static_cast<std::uint32_t>(std::ceil(end.x));
    const auto lastY = static_cast<std::uint32_t>(std::ceil(end.y));
    for (auto y = static_cast<std::uint32_t>(begin.y); y < std::min(lastY, texture.pixels.height); ++y) {
        const double share = overlap(begin.y, end.y, y);
        for (auto x = static_cast<std::uint32_t>(begin.x); x < std::min(lastX, texture.pixels.width); ++x) {
            const glm::dvec4 texel =
                share * overlap(begin.x, end.x, x) * linearOf(texture.pixels.at(x, y), texture.content);
            sum += texel;
            seen += glm::dvec3(texel) * (texture.pixels.at(x, y)[3] / 255.0);
        }
    }
    if (texture.alphaWeighs && sum.a > 0.0) {
        return {seen / sum.a, sum.a / ((end.x - begin.x) * (end.y - begin.y))};
    }
    return {sum / ((end.x - begin.x) * (end.y - begin.y))};
}

/// The alphas of a picture at four places of each texel, interpolated.
/// @param alphaAt of a texel (x, y).
template <typename AlphaAt>
std::vector<double> alphasOf(const glm::uvec2& size, AlphaAt alphaAt) {
    const auto at = [&](const glm::dvec2& place) {
        const glm::uvec2 texel(glm::clamp(place, glm::dvec2(0.0), glm::dvec2(size) - 1.0));
        return alphaAt(texel.x, texel.y);
    };
    std::vector<double> alphas;
    for (std::uint32_t y = 0; y < 2 * size.y; ++y) {
        for (std::uint32_t x = 0; x < 2 * size.x; ++x) {
            const glm::dvec2 place = 0.5 * glm::dvec2(x, y) - 0.25;
            const glm::dvec2 first = glm::floor(place);
            const glm::dvec2 share = place - first;
            const glm::dvec2 across(1.0, 0.0);
            const glm::dvec2 down(0.0, 1.0);
            const double alpha =
                glm::mix(glm::mix(at(first), at(first + across), share.x),
                         glm::mix(at(first + down), at(first + across + down), share.x), share.y);
            alphas.push_back(std::round(alpha * 1e9) * 1e-9); // equals stay equal
        }
    }
    return alphas;
}

/// How much of a picture a cutoff keeps.
double keptShare(const image::ImageRgba8& picture, double cutoff) {
    const std::vector<double> alphas =
        alphasOf({picture.width, picture.height},
                 [&](std::uint32_t x, std::uint32_t y) { return picture.at(x, y)[3] / 255.0; });
    const auto kept = std::ranges::count_if(alphas, [&](double alpha) { return alpha >= cutoff - 1e-6; });
    return static_cast<double>(kept) / static_cast<double>(alphas.size());
}

/// Multiplies the alpha of a level so that a cutoff keeps this share of it.
void keepShare(double share, double cutoff, image::Raster<glm::vec4>& level) {
    std::vector<double> alphas = alphasOf({level.width, level.height}, [&](std::uint32_t x, std::uint32_t y) {
        return double{level.at(x, y).a};
    });
    std::sort(alphas.begin(), alphas.end(), std::greater<>());
    auto wanted = static_cast<std::size_t>(std::lround(share * static_cast<double>(alphas.size())));
    if (wanted > 0 && wanted < alphas.size()) { // equals are kept together, or none of them
        const auto equals = std::equal_range(alphas.begin(), alphas.end(), alphas[wanted], std::greater<>());
        const auto fewer = static_cast<std::size_t>(equals.first - alphas.begin());
        const auto more = static_cast<std::size_t>(equals.second - alphas.begin());
        if (fewer < wanted) {
            wanted = wanted - fewer < more - wanted ? fewer : more;
        }
    }
    const double least = wanted == 0 ? 1.0 : alphas[wanted - 1]; // of those kept
    const double most = wanted == alphas.size() ? 0.0 : alphas[wanted];
    if (least >= cutoff && most < cutoff) {
        return;
    }
    const double scale = cutoff / (0.5 * (least + most));
    for (glm::vec4& texel : level.pixels) {
        texel.a = static_cast<float>(std::min(texel.a * scale, 1.0));
    }
}

/// Every level below the first, each averaged from the picture itself.
std::vector<image::Raster<glm::vec4>> filteredLevels(const scene::Texture& texture) {
    std::vector<image::Raster<glm::vec4>> levels;
    const glm::uvec2 whole(texture.pixels.width, texture.pixels.height);
    const auto cutoff = static_cast<double>(texture.cutoff.value_or(0.0f));
    const bool isMask = cutoff > 0.0 && cutoff <= 1.0;
    const double share = isMask ? keptShare(texture.pixels, cutoff) : 1.0;
    for (glm::uvec2 size = whole; size != glm::uvec2(1);) {
        size = glm::max(size / 2u, glm::uvec2(1));
        const glm::dvec2 texel = glm::dvec2(whole) / glm::dvec2(size);
        auto level = image::rasterOf<glm::vec4>(size.x, size.y, [&](auto x, auto y) {
            return average(texture, texel * glm::dvec2(x, y), texel * glm::dvec2(x + 1.0, y + 1.0));
        });
        if (isMask) {
            keepShare(share, cutoff, level);
        }
        levels.push_back(std::move(level));
    }
    return levels;
}

/// The level at which texels are as large as pixels; 0 and less where they are larger at the first.
double levelOf(const scene::Texture& texture, const UvSteps& steps) {
    const glm::dvec2 size(texture.pixels.width, texture.pixels.height);
    return std::log2(std::max(glm::length(steps.right * size), glm::length(steps.down * size)));
}

} // namespace

glm::dvec4 sampleTexture(const scene::Texture& texture, const glm::dvec2& uv) {
    return readFirst(texture, texture.magFilter, uv);
}

TruthTextures::TruthTextures(const scene::Scene& scene) {
    for (const scene::Texture& texture : scene.textures) {
        m_textures.emplace_back().texture = &texture;
    }
}

glm::dvec4 TruthTextures::sampleLevel(const Filtered& filtered, std::size_t level,
                                      const glm::dvec2& uv) const {
    const scene::Texture& texture = *filtered.texture;
    if (level == 0) {
        return readFirst(texture, texture.minFilter, uv);
    }
    const Level& picture = filtered.levels[level - 1];
    return readAt(texture, {picture.width, picture.height}, texture.minFilter, uv,
                  [&](std::uint32_t x, std::uint32_t y) { return glm::dvec4(picture.at(x, y)); });
}

glm::dvec4 TruthTextures::sample(std::uint32_t texture, const glm::dvec2& uv, const UvSteps& steps) const {
    Filtered& filtered = m_textures.at(texture);
    const double level = levelOf(*filtered.texture, steps);
    if (!(level > 0.0)) {
        return sampleTexture(*filtered.texture, uv);
    }
    if (filtered.texture->levels == scene::TextureLevels::none) {
        return sampleLevel(filtered, 0, uv);
    }
    std::call_once(filtered.once, [&] { filtered.levels = filteredLevels(*filtered.texture); });
    const auto last = static_cast<double>(filtered.levels.size());
    const double within = std::min(level, last);
    if (filtered.texture->levels == scene::TextureLevels::nearest) {
        return sampleLevel(filtered, static_cast<std::size_t>(std::max(std::ceil(within + 0.5) - 1.0, 0.0)),
                           uv);
    }
    const double larger = std::floor(within);
    return glm::mix(sampleLevel(filtered, static_cast<std::size_t>(larger), uv),
                    sampleLevel(filtered, static_cast<std::size_t>(std::min(larger + 1.0, last)), uv),
                    within - larger);
}

} // namespace cdr::measure
