#include <cdr/gpu/commands.h>
#include <cdr/render/shading/finish.h>
#include <cdr/render/shading/picture.h>
#include <cdr/render/stages.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/shaders/shading.h>

#include <array>
#include <utility>

namespace cdr::render {

bool needsLit(const PictureOptions& options) {
    return options.hasSteps || options.antialias != Antialias::none || options.keepsLinear;
}

Picture::Picture(const gpu::Device& device, const PictureOptions& options, const gpu::Image* drawn)
    : m_device(device),
      m_drawn(drawn),
      m_own(drawn == nullptr
                ? std::optional<gpu::Image>(std::in_place, device,
                                            colorOptions(options.extent, kPictureFormat), "picture")
                : std::nullopt),
      m_lit(needsLit(options) ? makeLit(device, options) : nullptr),
      m_keepsLinear(options.keepsLinear) {}

std::unique_ptr<Picture::Lit> Picture::makeLit(const gpu::Device& device, const PictureOptions& options) {
    const std::array constants = finishConstants(options.finish, options.daylight);
    const bool smooth = options.antialias == Antialias::edges;
    auto lit = std::make_unique<Lit>(
        Lit{.image = {device, colorOptions(options.extent, kLitFormat), "lit"},
            .pass = {device,
                     {.name = "encode",
                      .fragmentSpirv = smooth ? gpu::Spirv(kEncodeAntialiasedFrag) : gpu::Spirv(kEncodeFrag),
                      .bindings = {vk::DescriptorType::eCombinedImageSampler},
                      .format = kPictureFormat,
                      .constants = {constants.begin(), constants.end()}}}});
    lit->inputs = lit->pass.makeInputs();
    lit->inputs.setImage(0, lit->image);
    return lit;
}

void Picture::finish(vk::CommandBuffer primary) const {
    m_device.beginLabel(primary, "picture");
    if (m_lit) {
        gpu::pipelineBarrier(primary, {readBarrier(m_lit->image), attachBarrier(encoded())});
        m_lit->pass.record(primary, m_lit->inputs, encoded());
    }
    if (m_keepsLinear) {
        gpu::pipelineBarrier(primary, {copyBarrier(m_lit->image)});
    }
    gpu::pipelineBarrier(primary, {copyBarrier(encoded(), kDrawnColor)});
    m_device.endLabel(primary);
}

std::uint64_t Picture::predictBytes(const gpu::Device& device, const PictureOptions& options) {
    return gpu::predictBytes(device, colorOptions(options.extent, kPictureFormat)) +
           (needsLit(options) ? gpu::predictBytes(device, colorOptions(options.extent, kLitFormat)) : 0);
}

} // namespace cdr::render
