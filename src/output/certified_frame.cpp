#include "certified_frame.h"

#include <cdr/base/error.h>
#include <cdr/image/compose.h>
#include <cdr/render/octahedral.h>

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>

namespace cdr::output {

namespace {

/// The cascade whose interval is nearest to a distance.
std::uint32_t cascadeAt(const depth::Cascades& cascades, double distanceView) {
    const auto beyond = [&](const depth::Cascade& cascade) {
        return std::max({cascade.nearView - distanceView, distanceView - cascade.farView, 0.0});
    };
    const auto nearest = std::ranges::min_element(
        cascades, [&](const depth::Cascade& a, const depth::Cascade& b) { return beyond(a) < beyond(b); });
    return static_cast<std::uint32_t>(nearest - cascades.begin());
}

render::GBufferPixel pixelOf(const render::Frame& frame, const measure::PixelRepair& repair) {
    if (repair.id == 0) {
        return {};
    }
    const std::uint32_t cascade = cascadeAt(frame.cascades, repair.distanceView);
    const scene::Camera& camera = frame.camera;
    const glm::vec3 normalView(glm::dot(camera.right, repair.normal), glm::dot(camera.up, repair.normal),
                               glm::dot(camera.back, repair.normal));
    const glm::vec3 root(glm::sqrt(glm::clamp(repair.baseColor, 0.0, 1.0)));
    return {.albedo = glm::packUnorm4x8(glm::vec4(root, 0.0f)),
            .normal = glm::packSnorm2x16(render::encodeOctahedral(normalView)),
            .ahead = static_cast<float>(repair.distanceView - frame.anchorsView[cascade]),
            .idAndCascade = repair.id | (cascade << render::GBufferPixel::kIdBits)};
}

} // namespace

void requireCertifiable(const render::RenderOptions& options) {
    const char* what = options.effects != render::Effects{}                  ? "effects"
                       : options.focus.isOn()                                ? "a focus"
                       : options.detail.mode != visibility::DetailMode::none ? "levels of detail"
                                                                             : nullptr;
    if (what != nullptr) {
        throw base::InputError(std::string("a frame with ") + what +
                               " cannot be certified: its truth has none");
    }
}

measure::DrawnFrame drawnFrame(const render::Frame& frame, const render::RenderOptions& options,
                               std::uint32_t subPixelBits) {
    const auto step = [](std::uint32_t bits) { return std::exp2(-1.0 - bits); };
    return {.camera = frame.camera,
            .technique = options.technique,
            .cascades = frame.cascades,
            .ids = frame.ids(),
            .distancesView = image::rasterOf<double>(
                frame.width(), frame.height(), [&](auto x, auto y) { return frame.distanceView(x, y); }),
            .snapPixels = step(subPixelBits) + (options.snapBits > 0 ? step(options.snapBits) : 0.0),
            .hasShadows = options.shadows.isOn()};
}

void putRight(render::Frame& frame, const measure::Certificate& certificate) {
    for (const measure::PixelRepair& repair : certificate.repairs) {
        frame.color.at(repair.x, repair.y) = repair.color;
        frame.gbuffer.at(repair.x, repair.y) = pixelOf(frame, repair);
    }
}

} // namespace cdr::output
