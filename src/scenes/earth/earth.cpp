#include <cdr/platform/worker_pool.h>
#include <scenes/earth/concrete.h>
#include <scenes/earth/earth.h>
#include <scenes/earth/ground_blocks.h>
#include <scenes/earth/ground_painter.h>
#include <scenes/orbit/airport.h>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <utility>

namespace cdr::scenes {

namespace {

constexpr double kCloudHeight = 3'000.0;

std::uint32_t addGroundMaterial(SceneBuilder& builder, std::string name, image::ImageRgba8 pixels) {
    const std::uint32_t texture = builder.addTexture({.name = name,
                                                      .pixels = std::move(pixels),
                                                      .wrapU = scene::WrapMode::clampToEdge,
                                                      .wrapV = scene::WrapMode::clampToEdge});
    return builder.addMaterial(scene::Material{.name = std::move(name), .baseColorTexture = texture});
}

std::size_t threadsOf(const EarthOptions& options) {
    const std::size_t threads = options.threads > 0 ? options.threads : std::thread::hardware_concurrency();
    return std::clamp(threads, std::size_t{1}, platform::WorkerPool::kMaxThreads);
}

/// The half of a frame around its centre.
GeodeticFrame middleOf(const GeodeticFrame& frame) {
    return {.west = frame.west + 0.25 * frame.width,
            .north = frame.north - 0.25 * frame.height,
            .width = 0.5 * frame.width,
            .height = 0.5 * frame.height};
}

/// What the texels of a block, from north to south, are EarthOptions::blockTexels times. The path shows the first two, which are
/// wider, at the horizon at most. The next one is what the station sees from afar, where texels would be wider than pixels.
double shareOfTexels(std::size_t block) {
    constexpr std::size_t kSeenFromAfar = 2;
    return block < kSeenFromAfar ? 0.5 : block == kSeenFromAfar ? 2.0 : 1.0;
}

/// How a block is painted, between the coarser and the finer one.
GroundPainter::Canvas canvasOf(const std::vector<GroundBlock>& blocks, std::size_t block,
                               const EarthOptions& options) {
    const auto rowsOf = [&](std::size_t i) { return shareOfTexels(i) * options.blockTexels; };
    const auto texelOf = [&](std::size_t i) { return blocks[i].frame().height / rowsOf(i); };
    const auto height = static_cast<std::uint32_t>(rowsOf(block));
    GroundPainter::Canvas canvas{blocks[block].frame(), height / 2, height};
    if (block + 1 < blocks.size()) {
        canvas.hidden = blocks[block + 1].frame();
    }
    if (block == 0) { // the whole Earth is twice as wide as high, and around it there is none
        canvas.width = 2 * height;
    } else {
        canvas.fine = canvas.hidden.value_or(middleOf(canvas.frame));
        canvas.growth = std::min(texelOf(block - 1) / texelOf(block), canvas.growth);
    }
    return canvas;
}

/// Paints the blocks; a tile wears the finest that covers it.
std::function<TileCoat(const EarthTile&)>
addPaintedGround(SceneBuilder& builder, const GroundPainter& painter, const EarthOptions& options) {
    platform::WorkerPool workers(threadsOf(options));
    std::vector<std::pair<GroundBlock, TileCoat>> coats;
    const std::vector<GroundBlock> blocks = blocksAround(kOrbitAirport, EarthQuadtree::kDeepest - 1);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const GroundPainter::Canvas canvas = canvasOf(blocks, i, options);
        const std::uint32_t material =
            addGroundMaterial(builder, fmt::format("ground {}", i), painter.paint(canvas, workers));
        coats.emplace_back(blocks[i], TileCoat{material, canvas.frame});
    }
    return [coats = std::move(coats)](const EarthTile& tile) {
        const auto finest = std::find_if(coats.rbegin(), coats.rend(),
                                         [&](const auto& coat) { return coat.first.covers(tile); });
        return finest->second;
    };
}

/// The last of a name: the airport's come after those of a model of a file.
scene::Material& materialOf(scene::Scene& scene, std::string_view name) {
    const auto found = std::find_if(scene.materials.rbegin(), scene.materials.rend(),
                                    [&](const scene::Material& material) { return material.name == name; });
    if (found == scene.materials.rend()) {
        throw std::logic_error("the airport has no material of this name");
    }
    return *found;
}

/// The gaps between sheets are narrower than pixels of all frames, so walls of another colour would show as broken lines.
void paintWallsAsCladding(scene::Scene& scene) {
    materialOf(scene, kHangarWall).baseColorFactor = materialOf(scene, kCladding).baseColorFactor;
}

/// One colour over a whole picture shows neither distance nor size.
void paintSlabs(scene::Scene& scene, const EarthOptions& options) {
    platform::WorkerPool workers(threadsOf(options));
    const std::uint32_t side = std::max(1u, options.blockTexels / 5 * 2);
    scene.textures.push_back({.name = kConcrete, .pixels = paintConcrete(side, workers)});
    scene::Material& concrete = materialOf(scene, kConcrete);
    concrete.baseColorTexture = static_cast<std::uint32_t>(scene.textures.size() - 1);
    concrete.baseColorFactor /= glm::vec4(glm::vec3(kConcreteMean), 1.0f);
}

scene::Air airOf(const EarthSurface& surface, const scene::PointLight& sun) {
    // The Earth's axis in world space: from its centre to the pole.
    const glm::dvec3 centre = surface.earthCentre();
    return {.centre = centre,
            .axis = glm::normalize(surface.toWorld({90.0, 0.0}, 0.0) - centre),
            .flattening = kEarthFlattening,
            .toSun = glm::normalize(sun.position),
            .sunlight = sun.color,
            .haze = {.scattering = glm::vec3(2.5e-6f), .height = 1'200.0}};
}

} // namespace

scene::SceneSetup makeEarth(const EarthMaps& maps, const scene::Scene* parked, const EarthOptions& options) {
    const EarthSurface surface(maps.topography, kOrbitAirport, airportPad());
    const glm::dvec3 toSun = orbitToSun();
    const GroundPainter painter(maps.color, kOrbitAirport,
                                kCloudHeight / toSun.y * glm::dvec2(toSun.x, toSun.z));
    const auto cover = [&](SceneBuilder& builder) { return addPaintedGround(builder, painter, options); };
    scene::SceneSetup setup = makeOrbitOn(surface, cover, parked);
    setup.scene.name = "earth";
    paintWallsAsCladding(setup.scene);
    paintSlabs(setup.scene, options);
    setup.scene.air = airOf(surface, setup.scene.lights.front());
    return setup;
}

scene::OpenedScene openEarth(const OrbitFiles& files) {
    if (files.model.empty()) {
        return {.setup = makeEarth(loadEarthMaps(files.folder)), .notes = {}};
    }
    scene::GltfImport model = scene::loadGltf(files.model, files.limits);
    return {.setup = makeEarth(loadEarthMaps(files.folder), &model.scene), .notes = std::move(model.ignored)};
}

} // namespace cdr::scenes
