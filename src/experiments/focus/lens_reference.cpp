#include "lens_reference.h"

#include <cdr/image/srgb.h>

#include <cmath>
#include <numbers>

namespace cdr::experiments {

scene::Camera cameraOnLens(const scene::Camera& camera, const render::Focus& lens, std::uint32_t index,
                           std::uint32_t count) {
    const double goldenAngle = std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double radius = 0.5 * lens.aperture * std::sqrt((index + 0.5) / count);
    const double angle = goldenAngle * index;
    const glm::dvec3 eye =
        camera.position + radius * (std::cos(angle) * camera.right + std::sin(angle) * camera.up);
    return scene::lookAt(camera, eye, camera.position - lens.distance * camera.back);
}

void LensReference::add(const image::ImageRgba8& picture) {
    m_width = picture.width;
    m_height = picture.height;
    m_sums.resize(picture.pixels.size());
    const std::array<double, 256>& linear = image::linearOfSrgb();
    for (std::size_t i = 0; i < m_sums.size(); ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            m_sums[i][channel] += linear[picture.pixels[i][channel]];
        }
    }
    ++m_pictures;
}

image::ImageRgba8 LensReference::mean() const {
    image::ImageRgba8 picture(m_width, m_height);
    for (std::size_t i = 0; i < m_sums.size(); ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            picture.pixels[i][channel] = image::srgbOfLinear(m_sums[i][channel] / m_pictures);
        }
        picture.pixels[i][3] = 255;
    }
    return picture;
}

} // namespace cdr::experiments
