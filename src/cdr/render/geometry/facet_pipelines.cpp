#include <cdr/render/geometry/facet_pipelines.h>
#include <cdr/render/shading/finish.h>
#include <cdr/render/targets/gbuffer.h>
#include <cdr/shaders/geometry.h>

#include <bit>

namespace cdr::render {

namespace {

using gpu::Spirv;

constexpr vk::VertexInputBindingDescription kVertices{.binding = FacetPipelines::kVertexBinding,
                                                      .stride = sizeof(shaders::FacetVertex),
                                                      .inputRate = vk::VertexInputRate::eVertex};
constexpr vk::VertexInputAttributeDescription kPlace{
    0, FacetPipelines::kVertexBinding, vk::Format::eR32G32B32Sfloat, offsetof(shaders::FacetVertex, x)};

/// The place of a vertex and which facet starts with it, or how that is lit.
/// @param lights 0 where facets are not lit.
void addAttributes(std::uint32_t lights, gpu::GraphicsPipelineOptions& options) {
    options.bindings = {kVertices};
    options.attributes = {kPlace};
    if (lights == 0) {
        options.attributes.push_back(
            {1, FacetPipelines::kVertexBinding, vk::Format::eR32Uint, offsetof(shaders::FacetVertex, facet)});
        return;
    }
    constexpr auto kColor = static_cast<std::uint32_t>(sizeof(glm::vec3));
    options.bindings.push_back(
        {FacetPipelines::kLitBinding, (1 + lights) * kColor, vk::VertexInputRate::eVertex});
    for (std::uint32_t color = 0; color <= lights; ++color) {
        options.attributes.push_back(
            {1 + color, FacetPipelines::kLitBinding, vk::Format::eR32G32B32Sfloat, color * kColor});
    }
}

struct Shaders {
    Spirv vertex;
    Spirv cutVertex;
    Spirv fragment;
    Spirv cutFragment;
    Spirv depthFragment;
};

/// By the number of lights by which facets are lit; 0: they are not.
Shaders shadersFor(std::uint32_t lights) {
    switch (lights) {
    case 0:
        return {kFacetVert, kFacetCutVert, kFacetFrag, kFacetCutFrag, kFacetDepthFrag};
    case 1:
        return {kFacetOneLightVert, kFacetOneLightCutVert, kFacetOneLightFrag, kFacetOneLightCutFrag,
                kFacetOneLightDepthFrag};
    default:
        return {kFacetTwoLightVert, kFacetTwoLightCutVert, kFacetTwoLightFrag, kFacetTwoLightCutFrag,
                kFacetTwoLightDepthFrag};
    }
}

} // namespace

FacetPipelines::FacetPipelines(const gpu::Device& device, const GeometryOptions& options)
    : m_options(options),
      m_depthFormat(options.output == GeometryOutput::depth
                        ? GeometryPipelines::kOccluderFormat
                        : depthAttachmentFormat(device, options.technique.format, surfaceFormat())) {
    std::uint32_t pushed = sizeof(shaders::CascadePush);
    if (options.output == GeometryOutput::lit) {
        pushed = shaders::kPushedLightsOffset + shaders::kPushedLights * sizeof(glm::vec4);
    }
    m_layout = gpu::makePipelineLayout(
        device, {{}, {{.stageFlags = GeometryPipelines::kStages, .size = pushed}}}, "facet layout");
    const auto add = [&](std::uint32_t lights) {
        m_pipelines.push_back({make(device, Span::compact, lights), make(device, Span::wide, lights)});
    };
    switch (options.output) {
    case GeometryOutput::surfaces:
        add(0);
        break;
    case GeometryOutput::depth:
        m_pipelines.push_back({makeOccluder(device, Span::compact), makeOccluder(device, Span::wide)});
        break;
    case GeometryOutput::lit:
        for (std::uint32_t lights = 1; lights <= shaders::kPushedLights; ++lights) {
            add(lights);
        }
        break;
    }
}

vk::Pipeline FacetPipelines::pipeline(Span span, std::size_t lights) const {
    const Spans& spans = m_pipelines[m_options.output == GeometryOutput::lit ? lights - 1 : 0];
    return *(span == Span::wide ? spans.wide : spans.compact);
}

ScopeFormats FacetPipelines::formats() const {
    if (m_options.output == GeometryOutput::depth) {
        return {.depth = m_depthFormat};
    }
    return {.colors = {surfaceFormat()}, .depth = m_depthFormat};
}

vk::Format FacetPipelines::surfaceFormat() const {
    switch (m_options.output) {
    case GeometryOutput::surfaces:
        return kVisibilityFormat;
    case GeometryOutput::depth:
        return vk::Format::eUndefined;
    case GeometryOutput::lit:
        return kPictureFormat;
    }
    return vk::Format::eUndefined;
}

std::vector<std::uint32_t> FacetPipelines::constantsOf(Span span, std::uint32_t form) const {
    return {form,
            0u,
            0u,
            span == Span::wide ? 1u : 0u,
            0u,
            std::bit_cast<std::uint32_t>(m_options.snapSteps.x),
            std::bit_cast<std::uint32_t>(m_options.snapSteps.y)};
}

gpu::Pipeline FacetPipelines::makeOccluder(const gpu::Device& device, Span span) const {
    const bool isWide = span == Span::wide;
    return gpu::makeGraphicsPipeline(device, {.name = isWide ? "facet occluders, wide" : "facet occluders",
                                              .vertexSpirv = kFacetOccluderVert,
                                              .fragmentSpirv = isWide ? Spirv(kOccluderFrag) : Spirv(),
                                              .constants = constantsOf(span, shaders::kDepthFormLinear),
                                              .layout = m_layout,
                                              .bindings = {kVertices},
                                              .attributes = {kPlace},
                                              .depthFormat = m_depthFormat,
                                              .depthCompare = vk::CompareOp::eGreaterOrEqual});
}

gpu::Pipeline FacetPipelines::make(const gpu::Device& device, Span span, std::uint32_t lights) const {
    const bool isWide = span == Span::wide;
    const std::uint32_t form = depthFormOf(m_options.technique.mapping, span);
    const bool writesDepth = form == shaders::kDepthFormLogFragment;
    const bool cuts = isWide || writesDepth;
    const Shaders shaders = shadersFor(lights);
    gpu::GraphicsPipelineOptions options{
        .name = isWide ? "facets, wide" : "facets",
        .vertexSpirv = cuts ? shaders.cutVertex : shaders.vertex,
        .fragmentSpirv = writesDepth ? shaders.depthFragment
                         : cuts      ? shaders.cutFragment
                                     : shaders.fragment,
        .constants = constantsOf(span, form),
        .layout = m_layout,
        .colorFormats = {surfaceFormat()},
        .depthFormat = m_depthFormat,
        .stencil = marksDrawn(m_depthFormat, surfaceFormat()) ? gpu::Stencil::marks : gpu::Stencil::none,
        .depthCompare = depthCompareOf(m_options.technique.mapping)};
    addAttributes(lights, options);
    if (lights > 0) {
        const auto [finish, exposure] = finishConstants(m_options.finish, Daylight::absent);
        options.name = isWide ? "lit facets, wide" : "lit facets";
        options.constants.insert(options.constants.end(), {finish, exposure});
    }
    return gpu::makeGraphicsPipeline(device, options);
}

} // namespace cdr::render
