#include "picking.h"

#include "camera/heading.h"
#include "technique_label.h"

#include <cdr/scene/frustum.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cdr::viewer {

namespace {

double nearestSurface(const render::Frame& frame) {
    constexpr std::uint32_t kSamples = 32; // each way
    double nearest = std::numeric_limits<double>::infinity();
    for (std::uint32_t row = 0; row < kSamples; ++row) {
        for (std::uint32_t column = 0; column < kSamples; ++column) {
            nearest = std::min(nearest, frame.distanceView((2 * column + 1) * frame.width() / (2 * kSamples),
                                                           (2 * row + 1) * frame.height() / (2 * kSamples)));
        }
    }
    if (std::isfinite(nearest)) {
        return nearest;
    }
    // A small object lies between the samples.
    for (const render::GBufferPixel& pixel : frame.gbuffer.pixels) {
        nearest = pixel.id() != 0 ? std::min(nearest, frame.distanceView(pixel)) : nearest;
    }
    return nearest;
}

} // namespace

double surfaceView(const render::Frame& frame, const glm::dvec2& pixel) {
    if (frame.width() == 0 || frame.height() == 0) {
        return std::numeric_limits<double>::infinity();
    }
    const bool inside =
        pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < frame.width() && pixel.y < frame.height();
    const double under =
        inside ? frame.distanceView(static_cast<std::uint32_t>(pixel.x), static_cast<std::uint32_t>(pixel.y))
               : std::numeric_limits<double>::infinity();
    return std::isfinite(under) ? under : nearestSurface(frame);
}

std::string objectName(const scene::Scene& scene, std::uint32_t object) {
    if (object < scene.objectNames.size() && !scene.objectNames[object].empty()) {
        return scene.objectNames[object];
    }
    return fmt::format("object {}", object);
}

std::vector<std::uint32_t> materialsOf(const scene::Scene& scene, std::uint32_t object) {
    const scene::Instances& instances = scene.instances;
    std::vector<std::uint32_t> materials;
    for (std::size_t i = 0; i < instances.object.size(); ++i) {
        if (instances.object[i] == object) {
            materials.push_back(instances.material[i]);
        }
    }
    std::sort(materials.begin(), materials.end());
    materials.erase(std::unique(materials.begin(), materials.end()), materials.end());
    return materials;
}

std::optional<PickedPoint> pickAt(const render::Frame& frame, const scene::Scene& scene,
                                  const depth::Technique& technique, std::uint32_t x, std::uint32_t y) {
    if (x >= frame.width() || y >= frame.height()) {
        return std::nullopt;
    }
    const std::optional<render::Pick> pick = frame.pick(x, y);
    if (!pick) {
        return std::nullopt;
    }
    return PickedPoint{.object = pick->object,
                       .name = objectName(scene, pick->object),
                       .position = pick->position,
                       .normal = pick->normal,
                       .distance = glm::distance(pick->position, frame.camera.position),
                       .distanceView = pick->distanceView,
                       .stepView = techniqueStepView(technique, frame.cascades, pick->distanceView),
                       .footprint = pick->distanceView * footprintSlope(frame.camera, frame.height())};
}

Span spanBetween(const PickedPoint& first, const PickedPoint& second) {
    const glm::dvec3 vector = second.position - first.position;
    return {.vector = vector,
            .length = glm::length(vector),
            .alongView = second.distanceView - first.distanceView,
            .uncertainty = std::hypot(std::hypot(0.5 * first.footprint, 0.5 * second.footprint),
                                      std::hypot(first.stepView, second.stepView))};
}

void Measuring::click(const PickedPoint& point) {
    if (m_first && !m_second) {
        m_second = point;
    } else {
        m_first = point;
        m_second.reset();
    }
}

std::vector<std::uint32_t> Measuring::materialsIn(const scene::Scene& scene) const {
    return last() ? materialsOf(scene, last()->object) : std::vector<std::uint32_t>();
}

std::optional<Span> Measuring::span() const {
    return m_first && m_second ? std::optional(spanBetween(*m_first, *m_second)) : std::nullopt;
}

std::string describe(const PickedPoint& point, base::LengthUnit unit) {
    const std::string step = std::isfinite(point.stepView)
                                 ? "a step of " + base::quantityText(point.stepView, unit)
                                 : "where nothing is told apart";
    return fmt::format("{}, {} away, {}", point.name, base::quantityText(point.distance, unit), step);
}

std::string describe(const Span& span, base::LengthUnit unit) {
    const std::string within = std::isfinite(span.uncertainty)
                                   ? "to within " + base::quantityText(span.uncertainty, unit)
                                   : "where nothing is told apart";
    return fmt::format("{}, {} of it along the view, {}", base::quantityText(span.length, unit),
                       base::quantityText(span.alongView, unit), within);
}

} // namespace cdr::viewer
