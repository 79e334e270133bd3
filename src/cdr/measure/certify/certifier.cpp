#include <cdr/base/error.h>
#include <cdr/image/same_size.h>
#include <cdr/measure/certify/certifier.h>
#include <cdr/measure/certify/device_bound.h>
#include <cdr/measure/certify/screen_triangle.h>
#include <cdr/measure/certify/true_surfaces.h>
#include <cdr/measure/truth/visible_instances.h>
#include <cdr/platform/host_memory.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cdr::measure {

namespace {

/// Rows that a job takes: an instance is placed once for each band that it touches.
constexpr std::uint32_t kBandRows = 48;
/// A device may move a corner by less, unless a triangle is far wider than its distance.
constexpr double kMarginPixels = 1.0;

void requireSound(const DrawnFrame& frame) {
    scene::requireUsable(frame.camera);
    image::requireSameSize(frame.ids, frame.distancesView, "certify: the ids' size");
    if (frame.ids.width == 0 || frame.ids.height == 0) {
        throw base::InputError("certify: a picture needs at least one pixel");
    }
}

} // namespace

Certifier::Certifier(const scene::Scene& scene, platform::WorkerPool& workers)
    : m_scene(&scene),
      m_caster(scene, workers),
      m_layers(layerOffsets(scene.materials)),
      m_outlines(scene.meshes.size()) {
    workers.run(m_outlines.size(),
                [&](std::size_t mesh, std::size_t) { m_outlines[mesh] = outlineOf(scene.meshes[mesh]); });
}

void Certifier::follow(std::span<const std::uint32_t> meshes, platform::WorkerPool& workers) {
    m_caster.follow(meshes, workers);
    workers.run(meshes.size(), [&](std::size_t i, std::size_t) {
        m_outlines.at(meshes[i]) = outlineOf(m_scene->meshes[meshes[i]]);
    });
}

Certifier::Findings Certifier::find(const DrawnFrame& frame, platform::WorkerPool& workers,
                                    FrameBound& frameBound) const {
    const std::uint32_t width = frame.ids.width;
    const std::uint32_t height = frame.ids.height;
    // Of each pixel what is found, whether it is cast, its truth, and whether that is doubtful.
    constexpr std::uint64_t kBytes = sizeof(PixelFinding) + 1 + sizeof(TruthPixel) + 1;
    platform::requireHostBytes(platform::saturatingProduct({kBytes, width, height}),
                               fmt::format("the certificate of {}x{} pixels", width, height));
    const DeviceBound device(frame);
    const DeviceBound float64 = DeviceBound::ofFloat64(frame);
    const std::vector<VisibleInstance> visible =
        visibleInstances(*m_scene, m_caster.shapes(), frame.camera, width, height, workers, kMarginPixels);
    const PixelSlopes slopes = pixelSlopes(frame.camera, width, height);
    const auto enterAll = [&](OrderStrip& strip, const DeviceBound& bound) {
        FrameBound largest;
        InstanceTriangles triangles(frame.camera, width, height, bound, device);
        for (const VisibleInstance& candidate : visible) {
            if (strip.hides(candidate.pixels, candidate.nearestRank())) {
                continue;
            }
            const MeshOutline& outline = m_outlines[m_scene->instances.mesh[candidate.instance]];
            const std::uint32_t material = m_scene->instances.material[candidate.instance];
            const scene::AlphaMode alphaMode = m_scene->materials[material].alphaMode;
            const MaskedPixels masked{*m_scene, m_caster.textures(), slopes, candidate};
            const StripSurface surface{candidate.id, alphaMode, m_layers[material],
                                       alphaMode == scene::AlphaMode::mask ? &masked : nullptr};
            for (const ScreenTriangle& triangle : triangles.of(m_scene->instances, candidate.instance,
                                                               outline, surface.layer, candidate.sides)) {
                strip.enter(triangle, surface);
                largest.add(triangle.bound);
            }
        }
        return largest;
    };
    double farthestLayer = 0.0;
    for (const LayerOffset& layer : m_layers) {
        farthestLayer = std::max(farthestLayer, -layer.view);
    }
    Findings findings(width, height);
    std::vector<FrameBound> bounds((height + kBandRows - 1) / kBandRows);
    workers.run(bounds.size(), [&](std::size_t band, std::size_t) {
        const auto top = static_cast<std::uint32_t>(band) * kBandRows;
        const PixelRect rows{0, top, width, std::min(top + kBandRows, height)};
        OrderStrip strip(frame, device, rows, farthestLayer);
        bounds[band] = enterAll(strip, device);
        if (strip.lookFarther()) {
            bounds[band].add(enterAll(strip, device));
        }
        std::vector<glm::uvec2> open;
        for (std::uint32_t y = rows.top; y < rows.bottom; ++y) {
            for (std::uint32_t x = 0; x < width; ++x) {
                if (frame.ids.at(x, y) != 0) {
                    bounds[band].add(FrameBound{.stepView = device.stepView(frame.distancesView.at(x, y))});
                }
                findings.at(x, y) = strip.findingAt(x, y);
                if (findings.at(x, y).verdict == PixelVerdict::open) {
                    open.emplace_back(x, y);
                }
            }
        }
        if (open.empty()) {
            return;
        }
        OrderStrip proof(strip, open, float64);
        enterAll(proof, float64);
        for (const glm::uvec2& pixel : open) {
            const PixelFinding exact = proof.findingAt(pixel.x, pixel.y);
            PixelFinding& finding = findings.at(pixel.x, pixel.y);
            finding.verdict =
                exact.verdict == PixelVerdict::certified ? PixelVerdict::proven : finding.verdict;
            finding.isMasked = exact.isMasked;
            finding.offView = exact.offView;
        }
    });
    for (const FrameBound& bound : bounds) {
        frameBound.add(bound);
    }
    return findings;
}

void Certifier::repair(const DrawnFrame& frame, const Findings& findings, platform::WorkerPool& workers,
                       Certificate& certificate) const {
    image::Raster<std::uint8_t> open(findings.width, findings.height);
    std::transform(findings.pixels.begin(), findings.pixels.end(), open.pixels.begin(),
                   [](const PixelFinding& finding) { return finding.verdict == PixelVerdict::open ? 1 : 0; });
    const TruthImage truth = m_caster.cast(frame.camera, open, workers);
    for (std::uint32_t y = 0; y < open.height; ++y) {
        for (std::uint32_t x = 0; x < open.width; ++x) {
            if (open.at(x, y) == 0) {
                continue;
            }
            const TruthPixel& seen = truth.at(x, y);
            const bool isWrong = seen.id != frame.ids.at(x, y);
            certificate.wrong += isWrong ? 1 : 0;
            // The right object may show a wrong surface of its own, or a distance that is not a number.
            const double off = std::abs(frame.distancesView.at(x, y) - seen.distanceView);
            if (isWrong || (seen.id != 0 && !(off <= static_cast<double>(findings.at(x, y).offView)))) {
                certificate.repairs.push_back(
                    {.x = x, .y = y, .id = seen.id, .distanceView = seen.distanceView});
            }
        }
    }
    lightRepairs(*m_scene, m_caster.shapes(), frame, workers, certificate.repairs);
}

Certificate Certifier::certify(const DrawnFrame& frame, platform::WorkerPool& workers) const {
    requireSound(frame);
    Certificate certificate;
    const Findings findings = find(frame, workers, certificate.bound);
    certificate.pixels = findings.pixels.size();
    for (std::size_t i = 0; i < findings.pixels.size(); ++i) {
        const PixelVerdict verdict = findings.pixels[i].verdict;
        certificate.blended += findings.pixels[i].isBlended ? 1 : 0;
        certificate.proven += verdict == PixelVerdict::proven ? 1 : 0;
        certificate.certified +=
            verdict == PixelVerdict::certified || verdict == PixelVerdict::proven ? 1 : 0;
        certificate.cast += verdict == PixelVerdict::open ? 1 : 0;
        certificate.castMasked += verdict == PixelVerdict::open && findings.pixels[i].isMasked ? 1 : 0;
        if (verdict == PixelVerdict::refused && certificate.refused++ == 0) {
            certificate.firstRefused = {i % findings.width, i / findings.width};
        }
    }
    if (certificate.isRefused()) {
        certificate.cast = 0;
        certificate.castMasked = 0;
    } else if (certificate.cast > 0) {
        repair(frame, findings, workers, certificate);
    }
    return certificate;
}

} // namespace cdr::measure
