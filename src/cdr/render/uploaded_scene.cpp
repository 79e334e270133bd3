#include <cdr/gpu/upload.h>
#include <cdr/render/uploaded_scene.h>
#include <cdr/shaders/shared.h>
#include <cdr/visibility/blended.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace cdr::render {

namespace {

/// That stay where instances have fewer.
constexpr std::size_t kMinKinds = 64;

std::uint64_t predictBytes(const scene::Scene& scene) {
    return SceneTextures::predictBytes(scene) + SceneMeshes::predictBytes(scene);
}

} // namespace

UploadedScene::UploadedScene(const gpu::Device& device, const scene::Scene& scene, std::size_t threads)
    : m_device(device),
      m_scene(&scene),
      m_retired(device),
      m_meshes(device),
      m_lastVertices(device),
      m_vertexUpdates(device),
      m_textures(device, threads) {
    gpu::requireDeviceBytes(device, predictBytes(scene), "scene " + scene.name);
    m_meshes.upload(scene);
    m_textures.follow(scene, {}, m_retired);
    m_textures.followMaterials(scene, {}, m_retired);
    readMaterials();
    readAllInstances();
}

// A world checks each edit. Bounds of a pose that the device makes need not hold the vertices of the scene.
UploadedScene::UploadedScene(const gpu::Device& device, const scene::World& world, std::size_t threads)
    : UploadedScene(device, world.scene(), threads) {
    m_world = &world;
    m_followed = Followed::allOf(world.changes());
    followPoses();
    readKinds({});
}

bool UploadedScene::isCurrent() const {
    return m_world == nullptr || m_followed == Followed::allOf(m_world->changes());
}

const scene::ChangeLog& UploadedScene::instanceChanges() const {
    static const scene::ChangeLog kNone;
    return isLive() ? m_world->changes().instances : kNone;
}

std::uint32_t UploadedScene::generation(std::size_t instance) const {
    if (m_scene->instances.radius[instance] == scene::kNoRadius) {
        return 0;
    }
    return isLive() ? m_world->instance(instance).generation : 1;
}

bool UploadedScene::hasLayers() const {
    return std::any_of(m_layers.begin(), m_layers.end(),
                       [](const LayerPlace& layer) { return layer.offset != 0.0f; });
}

LevelRange UploadedScene::indicesOf(const MeshRange& mesh, std::uint32_t level) const {
    return level == 0 ? LevelRange{mesh.firstIndex, mesh.indexCount, 0.0f}
                      : levels()[mesh.firstLevel + level - 1];
}

std::span<const visibility::MeshChunk> UploadedScene::chunksOf(const MeshRange& mesh) const {
    return std::span(m_meshes.chunks()).subspan(mesh.firstChunk, mesh.chunkCount);
}

void UploadedScene::update() {
    m_retired.close(); // what an update that failed has replaced: nothing was submitted from what it left
    m_retired.free();
    if (isCurrent()) {
        return;
    }
    const scene::World::Changes& changes = m_world->changes();
    if (m_followed.meshes != changes.meshes.end() || m_followed.materials != changes.materials.end() ||
        m_followed.textures != changes.textures.end()) {
        updateTables();
    } else {
        if (m_followed.vertices != changes.vertices.end()) {
            updateVertices();
        }
        updateInstances();
    }
    ++m_revision;
    m_retired.close();
    m_followed = Followed::allOf(changes);
}

void UploadedScene::replaceTables() {
    const scene::World::Changes& changes = m_world->changes();
    const auto meshes = changes.meshes.since(m_followed.meshes);
    const bool areMeshesOthers = m_followed.meshes != changes.meshes.end();
    const vk::Buffer detailsBefore = m_meshes.details().handle();
    if (areMeshesOthers) {
        // Kept, since the next update does not do it again where this one fails from here on.
        m_isEachPoseStale = m_meshes.follow(*m_scene, meshes, m_retired) || m_isEachPoseStale;
        m_arePosesStale = m_arePosesStale || m_isEachPoseStale || (meshes && lacksPose(*meshes));
        m_vertexUpdates.forget(meshes, m_retired);
    }
    if (!meshes && !changes.vertices.since(m_followed.vertices)) { // all is there, and nothing deformed
        m_followed.vertices = changes.vertices.end();
        m_verticesRevision += 2;
    } else {
        followVertices();
    }
    const auto textures = changes.textures.since(m_followed.textures);
    m_textures.follow(*m_scene, textures, m_retired);
    // Where all textures are uploaded anew, each material reads another one.
    const auto materials = changes.materials.since(m_followed.materials);
    m_textures.followMaterials(*m_scene, textures ? materials : std::nullopt, m_retired);
    m_meshes.followDetails(*m_scene, m_retired);
    m_arePosesStale = m_arePosesStale || m_meshes.details().handle() != detailsBefore; // kept, as above
    if (m_arePosesStale) {
        followPoses();
        m_arePosesStale = false;
        m_isEachPoseStale = false;
    }
}

/// Whether one of the meshes has a pose that followVertices() leaves out: an update that failed has followed it before.
bool UploadedScene::lacksPose(std::span<const std::uint32_t> meshes) const {
    const auto posed = m_world->changes().vertices.since(m_followed.vertices);
    return std::ranges::any_of(meshes, [&](std::uint32_t mesh) {
        return m_world->pose(mesh) != nullptr && posed && std::ranges::count(*posed, mesh) == 0;
    });
}

/// Whether another world's meshes or materials took the place of those that were followed.
bool UploadedScene::areTablesReplaced() const {
    const scene::World::Changes& changes = m_world->changes();
    return !changes.meshes.since(m_followed.meshes) || !changes.materials.since(m_followed.materials);
}

void UploadedScene::updateTables() {
    ++m_meshesRevision;
    m_isEachInstanceStale = m_isEachInstanceStale || areTablesReplaced();
    replaceTables();
    readMaterials();
    if (!m_isEachInstanceStale) {
        readKinds({});
    }
    updateInstances();
}

void UploadedScene::followVertices() {
    const scene::ChangeLog& changes = m_world->changes().vertices;
    if (m_followed.vertices == changes.end()) {
        return;
    }
    std::vector<std::uint32_t> all;
    const auto changed = changes.since(m_followed.vertices);
    if (!changed) {
        all.resize(m_scene->meshes.size());
        std::iota(all.begin(), all.end(), 0u);
    }
    const std::span<const std::uint32_t> meshes = changed ? *changed : std::span<const std::uint32_t>(all);
    ++m_verticesRevision;
    const bool areLastKept = m_lastVerticesUse.use_count() > 1;
    if (!areLastKept) {
        m_lastVertices.drop(m_retired);
    }
    m_vertexUpdates.follow(
        *m_world, meshes,
        {.meshes = m_meshes, .retired = m_retired, .last = areLastKept ? &m_lastVertices : nullptr});
    m_followed.vertices =
        changes.end(); // now: where the update fails after this, the next one moves nothing again
}

/// Has the device deform all meshes that it deforms at all.
void UploadedScene::followPoses() {
    const std::vector<std::uint32_t> meshes = m_world->posedMeshes();
    if (meshes.empty()) {
        return;
    }
    m_verticesRevision += m_isEachPoseStale ? 2 : 0;
    m_vertexUpdates.follow(*m_world, meshes, {.meshes = m_meshes, .retired = m_retired});
}

void UploadedScene::updateVertices() {
    ++m_meshesRevision;
    const auto changed = m_world->changes().vertices.since(m_followed.vertices);
    followVertices();
    readKinds(changed); // in any case: an update that failed has changed meshes, and not their kinds
}

/// Those of meshes; nothing: all.
void UploadedScene::readKinds(const std::optional<std::span<const std::uint32_t>>& meshes) {
    m_tablesRevision += m_kinds.read(meshes, kindsFrom()) ? 1 : 0;
}

void UploadedScene::readMaterials() {
    m_materials.clear();
    m_layers = layerPlaces(m_scene->materials);
    const std::vector<SurfaceKind> surfacesBefore = std::exchange(m_surfaces, {});
    m_hasMetallicRoughness = false;
    m_hasBlended = false;
    m_hasEmission = false;
    for (const scene::Material& material : m_scene->materials) {
        m_materials.push_back(wordsOf(material));
        m_hasMetallicRoughness = m_hasMetallicRoughness || isMetallicRoughness(material);
        m_hasEmission = m_hasEmission || scene::hasEmission(material);
        m_hasBlended = m_hasBlended || material.alphaMode == scene::AlphaMode::blend;
        m_surfaces.push_back(
            {.unlit = material.unlit, .blends = material.alphaMode == scene::AlphaMode::blend});
    }
    const std::size_t common = std::min(surfacesBefore.size(), m_surfaces.size());
    m_isEachInstanceStale =
        m_isEachInstanceStale ||
        !std::equal(surfacesBefore.begin(), surfacesBefore.begin() + static_cast<std::ptrdiff_t>(common),
                    m_surfaces.begin());
}

void UploadedScene::readInstance(std::size_t i) {
    const scene::Instances& instances = m_scene->instances;
    const bool isMirrored = isMirror(instances.basis[i]);
    const DrawKinds::Key key{instances.mesh[i], instances.material[i], isMirrored};
    DrawSource& source = m_sources[i];
    // What moves or goes keeps its kind, which spares the look-up and leaves runs of one kind whole.
    const bool keepsKind = source.kind < m_kinds.all().size() &&
                           (m_kinds.keyOf(source.kind) == key || instances.radius[i] == scene::kNoRadius);
    source = {.position = instances.position(i),
              .basis = instances.basis[i],
              .id = instances.object[i] + 1 +
                    (m_scene->materials[instances.material[i]].unlit ? shaders::kIdUnlit : 0u) +
                    (isMirrored ? shaders::kIdMirror : 0u),
              .material = instances.material[i],
              .kind = keepsKind ? source.kind : m_kinds.indexOf(key, kindsFrom())};
}

/// With no kind but those that instances have now.
void UploadedScene::readAllInstances() {
    m_isEachInstanceStale = true; // also where this ends early
    m_kinds.clear();
    m_sources.assign(m_scene->instances.size(), {});
    for (std::size_t i = 0; i < m_sources.size(); ++i) {
        m_sources[i].kind = i == 0 ? 0 : m_sources[i - 1].kind; // often its own too, which spares the look-up
        readInstance(i);
    }
    m_blended = visibility::blendedInstances(*m_scene);
    m_isEachInstanceStale = false;
    ++m_readings;
    ++m_tablesRevision;
    ++m_meshesRevision; // facets are made by kind
    // So many that reading all instances again takes eight instances' time for each kind that came.
    m_mostKinds = std::max({kMinKinds, 4 * m_kinds.all().size(), m_sources.size() / 8});
}

void UploadedScene::updateInstances() {
    const auto changed = m_world->changes().instances.since(m_followed.instances);
    if (!changed || m_isEachInstanceStale || m_kinds.all().size() > m_mostKinds) {
        readAllInstances();
        return;
    }
    m_sources.resize(m_scene->instances.size());
    bool isBlendedStale = false;
    for (const std::uint32_t i : *changed) {
        readInstance(i);
        if (m_hasBlended) {
            const bool was = std::binary_search(m_blended.begin(), m_blended.end(), i);
            isBlendedStale = isBlendedStale || was != visibility::isBlended(*m_scene, i);
        }
    }
    if (isBlendedStale) {
        m_blended = visibility::blendedInstances(*m_scene);
    }
}

const visibility::InstanceCells& UploadedScene::cells(platform::WorkerPool& workers) const {
    const std::scoped_lock lock(m_culled.mutex);
    if (!std::exchange(m_culled.isMade, false)) { // nor after an error, which leaves them half made
        m_culled.cells.build(*m_scene, workers);
    } else if (m_culled.readings != m_readings || m_culled.instances != m_followed.instances) {
        const auto changed = m_world->changes().instances.since(m_culled.instances);
        if (changed && m_culled.readings == m_readings) {
            m_culled.cells.update(*m_scene, *changed, workers);
        } else {
            std::vector<std::uint32_t> all(m_scene->instances.size());
            std::iota(all.begin(), all.end(), 0u);
            m_culled.cells.update(*m_scene, all, workers);
        }
    }
    m_culled.isMade = true;
    m_culled.instances = m_followed.instances;
    m_culled.readings = m_readings;
    return m_culled.cells;
}

} // namespace cdr::render
