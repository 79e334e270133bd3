#include <cdr/image/beside.h>
#include <cdr/render/views/joined_frame.h>

#include <algorithm>
#include <vector>

namespace cdr::render {

namespace {

FrameTimes joinedTimes(std::span<const Frame> views) {
    FrameTimes times;
    for (const Frame& view : views) {
        const FrameTimes& own = view.stats.times;
        times.cullMs += own.cullMs;
        times.splitMs += own.splitMs;
        times.occludersMs += own.occludersMs;
        times.binMs += own.binMs;
        times.translucentMs += own.translucentMs;
        times.shadowsMs += own.shadowsMs;
        times.recordMs += own.recordMs;
        times.executeMs = std::max(times.executeMs, own.executeMs); // later views wait for earlier ones
        if (own.deviceMs) {
            times.deviceMs = times.deviceMs.value_or(0.0) + *own.deviceMs;
        }
    }
    return times;
}

FrameStats joinedStats(std::span<const Frame> views) {
    FrameStats stats;
    stats.translucency = views.front().stats.translucency;
    stats.translucency.draws = 0;
    stats.translucency.fragments = 0;
    stats.translucency.bytes = 0;
    for (const Frame& view : views) {
        const FrameStats& own = view.stats;
        stats.visible += own.visible;
        stats.draws += own.draws;
        stats.occluders.draws += own.occluders.draws;
        stats.occluders.hidden += own.occluders.hidden;
        stats.shadows.maps += own.shadows.maps;
        stats.shadows.casters += own.shadows.casters;
        stats.translucency.draws += own.translucency.draws;
        stats.translucency.fragments += own.translucency.fragments;
        stats.translucency.bytes += own.translucency.bytes;
        if (own.translucency.refusal) {
            stats.translucency.method = own.translucency.method;
            stats.translucency.refusal = own.translucency.refusal;
        }
        stats.lostMetallicRoughness = stats.lostMetallicRoughness || own.lostMetallicRoughness;
        stats.lostEmission = stats.lostEmission || own.lostEmission;
    }
    stats.duplication =
        stats.visible > 0 ? static_cast<double>(stats.draws) / static_cast<double>(stats.visible) : 1.0;
    stats.times = joinedTimes(views);
    return stats;
}

template <typename Pixel>
image::Raster<Pixel> joinedRaster(std::span<const Frame> views, image::Raster<Pixel> Frame::*raster,
                                  std::uint32_t shift, Pixel fill = {}) {
    std::vector<const image::Raster<Pixel>*> pictures;
    for (const Frame& view : views) {
        pictures.push_back(&(view.*raster));
    }
    return image::beside<Pixel>(pictures, shift, fill);
}

} // namespace

Frame joinedFrame(std::span<const Frame> views, const scene::Camera& camera, std::uint32_t shift) {
    Frame joined;
    joined.camera = camera;
    std::int64_t column = 0;
    for (const Frame& view : views) {
        const bool isFirst = joined.views.empty();
        const std::int64_t moved = isFirst ? -std::int64_t{shift / 2} : std::int64_t{shift - shift / 2};
        joined.views.push_back({.camera = view.camera, .firstColumn = column + moved});
        column += view.width();
    }
    joined.cascades = views.front().cascades;
    joined.anchorsView = views.front().anchorsView;
    joined.color = joinedRaster(views, &Frame::color, shift, image::Rgba8{0, 0, 0, 255});
    joined.linear = joinedRaster(views, &Frame::linear, shift);
    joined.gbuffer = joinedRaster(views, &Frame::gbuffer, shift);
    joined.motion = joinedRaster(views, &Frame::motion, shift);
    joined.litMask = joinedRaster(views, &Frame::litMask, shift);
    joined.fragmentCounts = joinedRaster(views, &Frame::fragmentCounts, shift);
    joined.stats = joinedStats(views);
    return joined;
}

} // namespace cdr::render
