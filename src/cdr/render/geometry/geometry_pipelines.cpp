#include <cdr/gpu/pipeline.h>
#include <cdr/render/geometry/geometry_pipelines.h>
#include <cdr/render/geometry/layers.h>
#include <cdr/render/targets/gbuffer.h>
#include <cdr/render/uploaded_scene.h>
#include <cdr/shaders/geometry.h>
#include <cdr/shaders/shared.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

namespace cdr::render {

namespace {

/// A triangle may span the share e of its distance. Then a logarithm set at its vertices errs by up to e^2 / 8
/// of that distance in between. 2 % keeps that below the overlap of cascades (1e-4), so no triangle opens a
/// crack.
constexpr double kLogWideSpan = 0.02;

/// Two steps of a float in clip distances move a cut by 2e-7 of its distance, for spans of up to this. Two cascades lose both
/// that and the rounding of planes, less than half of an overlap of 1e-6 of the far plane. A test adds it up.
constexpr double kLinearWideSpan = 4.0;

using gpu::Spirv;

/// What a variant's shaders are made for.
struct ShaderKind {
    bool isFaceted = false;
    bool isDetailed = false;
};
ShaderKind shaderKindOf(std::uint32_t variant) {
    return {.isFaceted = (variant & kFacetedVariant) != 0, .isDetailed = variant >= kDetailStep};
}

Spirv vertexShader(Batching batching, const ShaderKind& kind) {
    const bool isPushed = batching == Batching::pushConstants;
    if (kind.isDetailed) {
        return isPushed ? Spirv(kGeometryPushedDetailedVert) : Spirv(kGeometryDetailedVert);
    }
    if (isPushed) {
        return kind.isFaceted ? Spirv(kGeometryPushedFacetedVert) : Spirv(kGeometryPushedVert);
    }
    return kind.isFaceted ? Spirv(kGeometryFacetedVert) : Spirv(kGeometryVert);
}

/// Where the depth of a fragment comes from.
enum class FragmentDepth : std::uint8_t {
    rasterised,
    written, ///< by the shader, from the view distance
    moved    ///< by the shader, towards the camera
};

Spirv fragmentShader(const ShaderKind& kind, FragmentDepth depth) {
    if (depth == FragmentDepth::moved) {
        return kind.isDetailed ? Spirv(kGeometryLayeredDetailedFrag) : Spirv(kGeometryLayeredFrag);
    }
    const bool isWritten = depth == FragmentDepth::written;
    if (kind.isDetailed) {
        return isWritten ? Spirv(kGeometryDepthDetailedFrag) : Spirv(kGeometryDetailedFrag);
    }
    if (isWritten) {
        return kind.isFaceted ? Spirv(kGeometryDepthFacetedFrag) : Spirv(kGeometryDepthFrag);
    }
    return kind.isFaceted ? Spirv(kGeometryFacetedFrag) : Spirv(kGeometryFrag);
}

/// Between two depths that a buffer holds; 0 for floats, whose steps differ.
float depthStepOf(depth::DepthFormat format) {
    const depth::DepthFormatTraits& traits = depth::traitsOf(format);
    return traits.isFloat ? 0.0f : std::ldexp(1.0f, -traits.bits);
}

vk::PushConstantRange pushRange(Batching batching) {
    const std::uint32_t size = batching == Batching::pushConstants
                                   ? shaders::kPushedRecordOffset + sizeof(shaders::DrawRecord)
                                   : sizeof(shaders::CascadePush);
    return {.stageFlags = GeometryPipelines::kStages, .size = size};
}

std::vector<vk::VertexInputBindingDescription> bindingsFor(Batching batching, const ShaderKind& kind) {
    std::vector<vk::VertexInputBindingDescription> bindings{vertexBinding()};
    if (batching != Batching::pushConstants) {
        bindings.push_back({.binding = GeometryPipelines::kRecordBinding,
                            .stride = sizeof(shaders::DrawRecord),
                            .inputRate = vk::VertexInputRate::eInstance});
    }
    if (kind.isDetailed) {
        bindings.push_back(detailBinding());
    }
    return bindings;
}

std::vector<vk::VertexInputAttributeDescription> attributesFor(Batching batching, const ShaderKind& kind) {
    std::vector<vk::VertexInputAttributeDescription> attributes = vertexAttributes();
    if (kind.isDetailed) {
        const std::vector<vk::VertexInputAttributeDescription> more = detailAttributes();
        attributes.insert(attributes.end(), more.begin(), more.end());
    }
    if (batching != Batching::pushConstants) {
        constexpr auto kBinding = GeometryPipelines::kRecordBinding;
        constexpr auto kRow = vk::Format::eR32G32B32A32Sfloat;
        using shaders::DrawRecord;
        attributes.insert(attributes.end(),
                          {{4, kBinding, kRow, offsetof(DrawRecord, right)},
                           {5, kBinding, kRow, offsetof(DrawRecord, up)},
                           {6, kBinding, kRow, offsetof(DrawRecord, ahead)},
                           {7, kBinding, vk::Format::eR32G32B32A32Uint, offsetof(DrawRecord, id)}});
    }
    return attributes;
}

/// Those that say where a vertex is.
std::vector<vk::VertexInputAttributeDescription> placeAttributes() {
    std::vector<vk::VertexInputAttributeDescription> attributes = attributesFor(Batching::instanced, {});
    const auto first = attributes.begin();
    attributes.erase(first + 1, first + static_cast<std::ptrdiff_t>(vertexAttributes().size()));
    return attributes;
}

} // namespace

GeometryPipelines::GeometryPipelines(const gpu::Device& device, const UploadedScene& scene,
                                     const GeometryOptions& options)
    : m_options(options),
      m_depthFormat(options.output == GeometryOutput::depth
                        ? kOccluderFormat
                        : vk::Format(device.depthFormat(options.technique.format))),
      m_layout(gpu::makePipelineLayout(
          device, {{scene.textureLayout(), scene.detailLayout()}, {pushRange(options.batching)}},
          "geometry layout")) {
    for (const std::uint32_t variant : options.variants) {
        provide(device, variant);
    }
    follow(device, scene);
}

void GeometryPipelines::follow(const gpu::Device& device, const UploadedScene& scene) {
    for (const DrawKind& kind : scene.kinds()) {
        provide(device, kind.variant);
    }
}

void GeometryPipelines::provide(const gpu::Device& device, std::uint32_t ofKind) {
    const std::uint32_t variant = told(ofKind);
    for (const Span span : {Span::compact, Span::wide}) {
        gpu::Pipeline& pipeline = (span == Span::wide ? m_wide : m_compact)[variant];
        if (!pipeline) {
            pipeline = m_options.output == GeometryOutput::depth ? makeOccluder(device, span)
                                                                 : makeSurfaces(device, variant, span);
        }
    }
}

double wideSpan(depth::Mapping mapping, std::size_t cascades) {
    if (mapping == depth::Mapping::log) {
        return kLogWideSpan;
    }
    // One cascade has no neighbour to crack from.
    return cascades > 1 ? kLinearWideSpan : std::numeric_limits<double>::infinity();
}

std::uint32_t depthFormOf(depth::Mapping mapping, Span span) {
    if (mapping == depth::Mapping::logFragment || (span == Span::wide && mapping == depth::Mapping::log)) {
        return shaders::kDepthFormLogFragment;
    }
    return mapping == depth::Mapping::log ? shaders::kDepthFormLog : shaders::kDepthFormLinear;
}

vk::CompareOp depthCompareOf(depth::Mapping mapping) {
    return depth::isReversed(mapping) ? vk::CompareOp::eGreaterOrEqual : vk::CompareOp::eLessOrEqual;
}

ScopeFormats GeometryPipelines::formats() const {
    ScopeFormats formats{.depth = m_depthFormat};
    if (m_options.output != GeometryOutput::depth) {
        formats.colors.push_back(kGBufferFormat);
        if (m_options.emission) {
            formats.colors.push_back(kEmissionFormat);
        }
    }
    return formats;
}

gpu::Pipeline GeometryPipelines::makeOccluder(const gpu::Device& device, Span span) const {
    const bool isWide = span == Span::wide;
    return gpu::makeGraphicsPipeline(device,
                                     {.name = isWide ? "occluders, wide" : "occluders",
                                      .vertexSpirv = kOccluderVert,
                                      .fragmentSpirv = isWide ? Spirv(kOccluderFrag) : Spirv(),
                                      .constants = {shaders::kDepthFormLinear, 0u, 0u, isWide ? 1u : 0u, 0u,
                                                    std::bit_cast<std::uint32_t>(m_options.snapSteps.x),
                                                    std::bit_cast<std::uint32_t>(m_options.snapSteps.y)},
                                      .layout = m_layout,
                                      .bindings = bindingsFor(Batching::instanced, {}),
                                      .attributes = placeAttributes(),
                                      .depthFormat = m_depthFormat,
                                      .depthCompare = vk::CompareOp::eGreaterOrEqual});
}

gpu::Pipeline GeometryPipelines::makeSurfaces(const gpu::Device& device, std::uint32_t variant,
                                              Span span) const {
    const bool isWide = span == Span::wide;
    const depth::Mapping mapping = m_options.technique.mapping;
    const std::uint32_t form = depthFormOf(mapping, span);
    const bool isBiased = m_options.layers.method == LayerMethod::polygonOffset;
    const bool isLayered = (variant & kLayeredVariant) != 0;
    const FragmentDepth depthBy = isLayered && !isBiased                   ? FragmentDepth::moved
                                  : form == shaders::kDepthFormLogFragment ? FragmentDepth::written
                                                                           : FragmentDepth::rasterised;
    const bool cutsFragments = isWide || depthBy == FragmentDepth::moved;
    const ShaderKind shaderKind = shaderKindOf(variant);
    const bool hasPlanes = (variant & (kFacetedVariant | kPlanesVariant)) != 0;
    const glm::vec2 subPixels = hasPlanes ? m_options.subPixels : glm::vec2(0.0f);
    return gpu::makeGraphicsPipeline(
        device, {.name = isWide ? "geometry, wide" : "geometry",
                 .vertexSpirv = vertexShader(m_options.batching, shaderKind),
                 .fragmentSpirv = fragmentShader(shaderKind, depthBy),
                 .constants = {form, variant & kTexturedVariant ? 1u : 0u, variant & kMaskedVariant ? 1u : 0u,
                               cutsFragments ? 1u : 0u, m_options.metallicRoughness ? 1u : 0u,
                               std::bit_cast<std::uint32_t>(m_options.snapSteps.x),
                               std::bit_cast<std::uint32_t>(m_options.snapSteps.y),
                               std::bit_cast<std::uint32_t>(layerSlope(m_options.subPixelBits)),
                               std::bit_cast<std::uint32_t>(depthStepOf(m_options.technique.format)),
                               std::bit_cast<std::uint32_t>(depth::isReversed(mapping) ? 1.0f : -1.0f),
                               variant / kDetailStep, std::bit_cast<std::uint32_t>(subPixels.x),
                               std::bit_cast<std::uint32_t>(subPixels.y)},
                 .layout = m_layout,
                 .bindings = bindingsFor(m_options.batching, shaderKind),
                 .attributes = attributesFor(m_options.batching, shaderKind),
                 .colorFormats = formats().colors,
                 .depthFormat = m_depthFormat,
                 .depthCompare = depthCompareOf(mapping),
                 .hasDepthBias = isLayered && isBiased});
}

} // namespace cdr::render
