#include <cdr/gpu/memory.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/retired.h>
#include <cdr/gpu/upload.h>
#include <cdr/render/draw_kinds.h>
#include <cdr/render/materials/material_words.h>
#include <cdr/render/materials/scene_textures.h>
#include <cdr/render/upload/last_vertices.h>
#include <cdr/render/upload/scene_meshes.h>
#include <cdr/render/upload/vertex_updates.h>
#include <cdr/shaders/shared.h>
#include <cdr/visibility/blended.h>
#include <cdr/visibility/instance_cells.h>

#include <algorithm>
#include <mutex>
#include <numeric>
#include <optional>
#include <utility>

namespace cdr::render {

namespace {

std::uint64_t predictBytes(const scene::Scene& scene) {
    return SceneTextures::predictBytes(scene) + SceneMeshes::predictBytes(scene);
}

} // namespace

class GpuScene::State {
  public:
    State(const gpu::Device& device, const scene::Scene& scene, std::size_t threads);
    bool isCurrent() const;
    void update();
    const visibility::InstanceCells& cells(platform::WorkerPool& workers);

  private:
    friend class GpuScene; // it only hands out what is here

    /// What cells() made, and how far it has followed.
    struct Culled {
        std::mutex mutex;
        visibility::InstanceCells cells;
        bool isMade = false;
        std::uint64_t instances = 0; ///< of the world's changes
        std::uint64_t readings = 0;  ///< m_readings
    };

    /// What instances keep of their material.
    struct SurfaceKind {
        bool unlit = false;
        bool blends = false;

        bool operator==(const SurfaceKind&) const = default;
    };
    /// How far the world's changes were followed.
    struct Followed {
        std::uint64_t instances = 0;
        std::uint64_t meshes = 0;
        std::uint64_t materials = 0;
        std::uint64_t textures = 0;
        std::uint64_t vertices = 0;

        static Followed allOf(const scene::World::Changes& c) {
            return {c.instances.end(), c.meshes.end(), c.materials.end(), c.textures.end(), c.vertices.end()};
        }
        bool operator==(const Followed&) const = default;
    };

    void updateTables();
    void followVertices();
    void followPoses();
    void updateVertices();
    void readKinds(const std::optional<std::span<const std::uint32_t>>& meshes);
    bool areTablesReplaced() const;
    bool lacksPose(std::span<const std::uint32_t> meshes) const;
    void forgetKinds();
    void readMaterials();
    void replaceTables();
    DrawKinds::From kindsFrom() const { return {*m_scene, m_meshes, m_textures, m_layers}; }
    void readInstance(std::size_t i);
    void readAllInstances();
    void updateInstances();

    const gpu::Device& m_device;
    const scene::Scene* m_scene;
    const scene::World* m_world = nullptr;
    Followed m_followed;
    std::uint64_t m_revision = 0;
    std::uint64_t m_tablesRevision = 0;
    std::uint64_t m_meshesRevision = 0;
    std::uint64_t m_readings = 0; ///< of all instances
    gpu::Retired m_retired;       ///< what frames in flight may still read
    SceneMeshes m_meshes;
    LastVertices m_lastVertices;
    VertexUpdates m_vertexUpdates;
    bool m_arePosesStale =
        false; ///< whether meshes that the device deforms were uploaded as the CPU has them
    bool m_isEachPoseStale = false; ///< the same of all meshes, so that what is kept is not the last frame's
    std::shared_ptr<const char> m_lastVerticesUse = std::make_shared<char>(); ///< each renderer has one more
    std::uint64_t m_verticesRevision = 0;
    SceneTextures m_textures;
    std::vector<MaterialWords> m_materials;
    bool m_hasMetallicRoughness = false;
    bool m_hasBlended = false;
    bool m_hasEmission = false;
    std::vector<SurfaceKind> m_surfaces; ///< by material
    bool m_isEachInstanceStale = false;  ///< whether a material changed what instances keep of it
    std::vector<LayerPlace> m_layers;    ///< by material
    DrawKinds m_kinds;                   ///< until the tables are replaced
    std::vector<DrawSource> m_sources;
    std::vector<std::uint32_t> m_blended;
    Culled m_culled;
};

GpuScene::State::State(const gpu::Device& device, const scene::Scene& scene, std::size_t threads)
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

GpuScene::GpuScene(const gpu::Device& device, const scene::Scene& scene, std::size_t threads)
    : m_state((scene::requireUsable(scene), std::make_unique<State>(device, scene, threads))) {}

// A world checks each edit. Bounds of a pose that the device makes need not hold the vertices of the scene.
GpuScene::GpuScene(const gpu::Device& device, const scene::World& world, std::size_t threads)
    : m_state(std::make_unique<State>(device, world.scene(), threads)) {
    m_state->m_world = &world;
    m_state->m_followed = State::Followed::allOf(world.changes());
    m_state->followPoses();
    m_state->readKinds({});
}

bool GpuScene::State::isCurrent() const {
    return m_world == nullptr || m_followed == Followed::allOf(m_world->changes());
}

GpuScene::~GpuScene() = default;
GpuScene::GpuScene(GpuScene&&) noexcept = default;
GpuScene& GpuScene::operator=(GpuScene&&) noexcept = default;

void GpuScene::update() {
    m_state->update();
}

const scene::ChangeLog& GpuScene::instanceChanges() const {
    static const scene::ChangeLog kNone;
    return isLive() ? m_state->m_world->changes().instances : kNone;
}

std::uint64_t GpuScene::followedInstances() const {
    return m_state->m_followed.instances;
}

std::uint32_t GpuScene::generation(std::size_t instance) const {
    if (scene().instances.radius[instance] == scene::kNoRadius) {
        return 0;
    }
    return isLive() ? m_state->m_world->instance(instance).generation : 1;
}

// clang-format off: a list
VkDevice GpuScene::device() const {
    return m_state->m_device.handle();
}
const scene::Scene& GpuScene::scene() const {
    return *m_state->m_scene;
}
bool GpuScene::isLive() const {
    return m_state->m_world != nullptr;
}
bool GpuScene::isCurrent() const {
    return m_state->isCurrent();
}
std::uint64_t GpuScene::revision() const {
    return m_state->m_revision;
}
std::uint64_t GpuScene::tablesRevision() const {
    return m_state->m_tablesRevision;
}
std::uint64_t GpuScene::meshesRevision() const {
    return m_state->m_meshesRevision;
}
VkBuffer GpuScene::vertices() const {
    return m_state->m_meshes.vertices().handle();
}
VkBuffer GpuScene::indices() const {
    return m_state->m_meshes.indices().handle();
}
const gpu::SetLayout& GpuScene::textureLayout() const {
    return m_state->m_textures.baseColorLayout();
}
const gpu::SetLayout& GpuScene::detailLayout() const {
    return m_state->m_textures.detailLayout();
}
std::shared_ptr<const void> GpuScene::keepLastVertices() {
    return m_state->m_lastVerticesUse;
}
std::uint64_t GpuScene::verticesRevision() const {
    return m_state->m_verticesRevision;
}
const LastVertices& GpuScene::lastVertices() const {
    return m_state->m_lastVertices;
}
VkBuffer GpuScene::details() const {
    return m_state->m_meshes.details().handle();
}
bool GpuScene::hasHostVertices() const {
    return !isLive() || m_state->m_world->hasPosedVertices();
}
const std::vector<MaterialWords>& GpuScene::materials() const {
    return m_state->m_materials;
}
bool GpuScene::hasMetallicRoughness() const {
    return m_state->m_hasMetallicRoughness;
}
bool GpuScene::hasBlended() const {
    return m_state->m_hasBlended;
}
bool GpuScene::hasEmission() const {
    return m_state->m_hasEmission;
}
bool GpuScene::hasLayers() const {
    return std::any_of(m_state->m_layers.begin(), m_state->m_layers.end(),
                       [](const LayerPlace& layer) { return layer.offset != 0.0f; });
}
std::span<const std::uint32_t> GpuScene::blended() const {
    return m_state->m_blended;
}
const visibility::InstanceCells& GpuScene::cells(platform::WorkerPool& workers) const {
    return m_state->cells(workers);
}
const std::vector<DrawSource>& GpuScene::sources() const {
    return m_state->m_sources;
}
const std::vector<DrawKind>& GpuScene::kinds() const {
    return m_state->m_kinds.all();
}
const std::vector<LevelRange>& GpuScene::levels() const {
    return m_state->m_meshes.levels();
}
// clang-format on

LevelRange GpuScene::indicesOf(const MeshRange& mesh, std::uint32_t level) const {
    return level == 0 ? LevelRange{mesh.firstIndex, mesh.indexCount, 0.0f}
                      : m_state->m_meshes.levels()[mesh.firstLevel + level - 1];
}

std::span<const visibility::MeshChunk> GpuScene::chunksOf(const MeshRange& mesh) const {
    return std::span(m_state->m_meshes.chunks()).subspan(mesh.firstChunk, mesh.chunkCount);
}

void GpuScene::State::update() {
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

void GpuScene::State::replaceTables() {
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
bool GpuScene::State::lacksPose(std::span<const std::uint32_t> meshes) const {
    const auto posed = m_world->changes().vertices.since(m_followed.vertices);
    return std::ranges::any_of(meshes, [&](std::uint32_t mesh) {
        return m_world->pose(mesh) != nullptr && posed && std::ranges::count(*posed, mesh) == 0;
    });
}

/// Whether another world's meshes or materials took the place of those that were followed.
bool GpuScene::State::areTablesReplaced() const {
    const scene::World::Changes& changes = m_world->changes();
    return !changes.meshes.since(m_followed.meshes) || !changes.materials.since(m_followed.materials);
}

void GpuScene::State::forgetKinds() {
    m_kinds.clear();
    m_sources.clear();
    m_isEachInstanceStale = true;
}

void GpuScene::State::updateTables() {
    ++m_meshesRevision;
    if (areTablesReplaced()) {
        forgetKinds();
    }
    replaceTables();
    readMaterials();
    readKinds({});
    if (m_isEachInstanceStale) {
        readAllInstances();
    } else {
        updateInstances();
    }
}

void GpuScene::State::followVertices() {
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
void GpuScene::State::followPoses() {
    const std::vector<std::uint32_t> meshes = m_world->posedMeshes();
    if (meshes.empty()) {
        return;
    }
    m_verticesRevision += m_isEachPoseStale ? 2 : 0;
    m_vertexUpdates.follow(*m_world, meshes, {.meshes = m_meshes, .retired = m_retired});
}

void GpuScene::State::updateVertices() {
    ++m_meshesRevision;
    const auto changed = m_world->changes().vertices.since(m_followed.vertices);
    followVertices();
    readKinds(changed); // in any case: an update that failed has changed meshes, and not their kinds
}

/// Those of meshes; nothing: all.
void GpuScene::State::readKinds(const std::optional<std::span<const std::uint32_t>>& meshes) {
    m_tablesRevision += m_kinds.read(meshes, kindsFrom()) ? 1 : 0;
}

void GpuScene::State::readMaterials() {
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

void GpuScene::State::readInstance(std::size_t i) {
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

void GpuScene::State::readAllInstances() {
    m_sources.resize(m_scene->instances.size());
    for (std::size_t i = 0; i < m_sources.size(); ++i) {
        readInstance(i);
    }
    m_blended = visibility::blendedInstances(*m_scene);
    m_isEachInstanceStale = false;
    ++m_readings;
    ++m_tablesRevision;
}

void GpuScene::State::updateInstances() {
    const auto changed = m_world->changes().instances.since(m_followed.instances);
    if (!changed) {
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

const visibility::InstanceCells& GpuScene::State::cells(platform::WorkerPool& workers) {
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
