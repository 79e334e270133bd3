#include <cdr/gpu/pipeline.h>
#include <cdr/render/shadows/receiver_push.h>
#include <cdr/render/translucency/translucent_shadows.h>

#include <algorithm>
#include <limits>

namespace cdr::render {

namespace {

/// How many maps of full size the image has room for, along a side. Where a slice has more maps, they are smaller.
constexpr std::uint32_t kFullMapsAlong = 2;

/// Of a square that holds so many maps of one size.
std::uint32_t mapsAlong(std::size_t maps) {
    std::uint32_t along = 1;
    while (std::size_t{along} * along < maps) {
        ++along;
    }
    return along;
}

std::vector<SeenSphere> spheresOf(const scene::Scene& scene, const scene::Camera& camera,
                                  const visibility::VisibleList& visible) {
    std::vector<SeenSphere> seen;
    for (std::size_t i = 0; i < visible.count; ++i) {
        seen.push_back({scene.instances.position(visible.instance[i]) - camera.position,
                        static_cast<double>(visible.radius[i]), visible.distanceView[i]});
    }
    return seen;
}

} // namespace

TranslucentShadows::TranslucentShadows(const gpu::Device& device, const DrawnScene& scene,
                                       const Shadows& options)
    : m_device(device),
      m_scene(scene),
      m_options(options),
      m_casters(device, scene),
      m_map(device, scene.uploaded.textureLayout(), kMinShadowTexels) {}

std::uint32_t TranslucentShadows::maxTexels(std::span<const ReceiverSlice> slices,
                                            const FrameView& view) const {
    const std::vector<std::uint32_t> lights = scene::shadowLights(m_scene.scene.lights);
    std::uint32_t along = 1;
    for (const ReceiverSlice& slice : slices) {
        std::size_t maps = 0;
        for (const std::uint32_t light : lights) {
            // Of all directions: what a light's cone spares does not change the texels of the rest.
            const scene::PointLight all{.position = m_scene.scene.lights[light].position};
            maps +=
                lightViews(all, view.camera.position, slice, view.frustum.footprintSlope, m_options.maxTexels)
                    .size();
        }
        along = std::max(along, mapsAlong(maps));
    }
    const std::uint32_t side = std::min(kFullMapsAlong * m_options.maxTexels, m_device.info().maxImageSide);
    return std::min(m_options.maxTexels, std::max(side / along, std::uint32_t{8}));
}

void TranslucentShadows::prepare(const FrameView& view, const visibility::VisibleList& seen,
                                 std::uint32_t subPixelBits, platform::WorkerPool& workers) {
    const std::vector<ReceiverSlice> slices =
        slicesOf(m_options.method, view.camera, view.frustum, spheresOf(m_scene.scene, view.camera, seen));
    const std::vector<std::uint32_t> lights = scene::shadowLights(m_scene.scene.lights);
    const std::uint32_t most = maxTexels(slices, view);
    m_views.clear();
    // What lies between two slices, or before the first, is drawn with the farther one, and is in none of its maps.
    m_slices.assign(1, {.nearView = 0.0f, .farView = 0.0f, .firstMap = 0, .mapCount = 0});
    for (std::size_t i = 0; i < slices.size(); ++i) {
        const ReceiverSlice& slice = slices[i];
        if (i > 0) {
            m_slices.push_back(m_slices.back());
            m_slices.back().nearView = m_slices.back().farView;
        }
        shaders::TranslucentSlice& drawn = m_slices.back();
        drawn.farView = static_cast<float>(slice.farView);
        drawn.firstMap = static_cast<std::uint32_t>(m_views.size());
        for (std::size_t channel = 0; channel < lights.size(); ++channel) {
            for (const LightView& seenByLight :
                 lightViews(m_scene.scene.lights[lights[channel]], view.camera.position, slice,
                            view.frustum.footprintSlope, most)) {
                m_views.push_back(seenByLight);
                m_views.back().slice = i;
                m_views.back().channel = channel;
            }
        }
        drawn.mapCount = static_cast<std::uint32_t>(m_views.size()) - drawn.firstMap;
    }
    m_slices.back().farView = std::numeric_limits<float>::infinity();
    m_casters.prepare(view, slices, m_views, workers);
    placeMaps();
    gpu::growRecords(m_device, m_receivers, m_views.size(), sizeof(shaders::ReceiverPush),
                     "translucent receivers", vk::BufferUsageFlagBits::eStorageBuffer);
    const bool isPlain = m_options.method == ShadowMethod::plain;
    const auto receivers = m_receivers.as<shaders::ReceiverPush>(m_views.size());
    for (std::size_t i = 0; i < m_views.size(); ++i) {
        receivers[i] = receiverPush(
            m_views[i], view, {.isPlain = isPlain, .subPixelBits = subPixelBits, .corner = m_corners[i]});
    }
    m_receivers.flush();
}

void TranslucentShadows::placeMaps() {
    m_corners.assign(m_views.size(), {});
    std::uint32_t side = m_map.side();
    for (const shaders::TranslucentSlice& slice : m_slices) {
        std::uint32_t cell = 0; // of a side
        for (std::uint32_t i = slice.firstMap; i < slice.firstMap + slice.mapCount; ++i) {
            cell = std::max({cell, m_views[i].size.width, m_views[i].size.height});
        }
        const std::uint32_t along = mapsAlong(slice.mapCount);
        for (std::uint32_t i = 0; i < slice.mapCount; ++i) {
            m_corners[slice.firstMap + i] = vk::Offset2D{static_cast<std::int32_t>(i % along * cell),
                                                         static_cast<std::int32_t>(i / along * cell)};
        }
        side = std::max(side, along * cell);
    }
    if (side > m_map.side()) {
        gpu::requireDeviceBytes(m_device, ShadowMap::predictBytes(m_device, side),
                                "shadow maps of translucent surfaces");
        m_map = ShadowMap(m_device, m_scene.uploaded.textureLayout(), side);
    }
}

void TranslucentShadows::bind(const gpu::DescriptorSet& set, std::uint32_t first, vk::Sampler sampler) const {
    set.setImage(first, m_map.depth().view(), sampler);
    set.setImage(first + 1, m_map.slope().view(), sampler);
    set.setBuffer(first + 2, m_receivers);
}

void TranslucentShadows::recordMaps(vk::CommandBuffer primary, const shaders::TranslucentSlice& slice) const {
    std::vector<ShadowMapPart> parts;
    for (std::size_t i = slice.firstMap; i < slice.firstMap + slice.mapCount; ++i) {
        parts.push_back({.view = m_views[i], .index = i, .corner = m_corners[i]});
    }
    m_map.record(primary, parts, m_casters);
}

} // namespace cdr::render
