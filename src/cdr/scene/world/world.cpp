#include <cdr/base/format_error.h>
#include <cdr/scene/world/world.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cdr::scene {

namespace {

template <typename Kind>
std::string nameOf(const char* kind, Handle<Kind> handle) {
    return fmt::format("{} {}", kind, handle.index);
}

/// deform() takes from the deformer what the device leaves as the mesh has it, so both must have the same.
void requireAlike(const Deformer& deformer, const Mesh& mesh, const std::string& what) {
    const auto areAlike = [](const auto& ones, const auto& others, const auto& member) {
        return std::equal(ones.begin(), ones.end(), others.begin(), others.end(),
                          [&](const auto& a, const auto& b) { return a.*member == b.*member; });
    };
    const auto require = [&](bool isAlike, const char* part) {
        if (!isAlike) {
            throw base::inputError("{}: its deformer has other {} than the mesh, and a pose "
                                   "changes positions, normals and tangents alone",
                                   what, part);
        }
    };
    require(areAlike(deformer.vertices, mesh.vertices, &Vertex::color), "colours");
    require(areAlike(deformer.vertices, mesh.vertices, &Vertex::uv), "texture coordinates");
    require(deformer.details.size() == mesh.details.size(), "details");
    require(areAlike(deformer.details, mesh.details, &VertexDetail::uv), "second texture coordinates");
}

} // namespace

World::World(Scene scene)
    : m_scene(std::move(scene)),
      m_id(newWorldId()),
      m_instances("instance", m_id, m_scene.instances.size()),
      m_meshes("mesh", "instances", m_id, m_scene.meshes.size()),
      m_materials("material", "instances", m_id, m_scene.materials.size()),
      m_textures("texture", "materials", m_id, m_scene.textures.size()),
      m_lightPlaces("light", m_id, m_scene.lights.size()) {
    requireUsable(m_scene);
    for (std::uint32_t light = 0; light < m_scene.lights.size(); ++light) {
        m_lightOf.push_back(light);
    }
    for (std::size_t i = 0; i < m_scene.instances.size(); ++i) {
        if (m_scene.instances.radius[i] == kNoRadius) { // another world's, which removed it
            m_instances.free(m_instances.at(i));
            continue;
        }
        m_meshes.use(m_scene.instances.mesh[i]);
        m_materials.use(m_scene.instances.material[i]);
    }
    for (const Material& material : m_scene.materials) {
        useTexture(material);
    }
}

void World::noteInstance(std::uint32_t index) {
    m_instanceChanges.add(index, m_scene.instances.size());
}

void World::useTexture(const Material& material) {
    forEachTexture(material, [&](std::uint32_t texture) { m_textures.use(texture); });
}

void World::releaseTexture(const Material& material) {
    forEachTexture(material, [&](std::uint32_t texture) { m_textures.release(texture); });
}

void World::requireInstance(const InstanceOptions& options) const {
    m_meshes.places().require(options.mesh);
    m_materials.places().require(options.material);
    if (options.object > kMaxObjects) {
        throw base::inputError("object {} is over the limit of {}", options.object, kMaxObjects);
    }
    requireUsable(options.transform, "the new instance");
}

InstanceHandle World::addInstance(const InstanceOptions& options) {
    requireInstance(options);
    const InstanceHandle handle = m_instances.take();
    Instances& instances = m_scene.instances;
    const std::uint32_t i = handle.index;
    if (i == instances.size()) {
        scene::addInstance(m_scene, options.mesh.index, options.material.index, options.object,
                           options.transform.position, options.transform.basis);
    } else {
        instances.mesh[i] = options.mesh.index;
        instances.material[i] = options.material.index;
        instances.object[i] = options.object;
        placeInstance(m_scene, i, options.transform.position, options.transform.basis);
    }
    m_meshes.use(options.mesh.index);
    m_meshUsers.add(options.mesh.index, i);
    m_materials.use(options.material.index);
    noteInstance(i);
    return handle;
}

void World::removeInstance(InstanceHandle handle) {
    m_instances.require(handle);
    Instances& instances = m_scene.instances;
    const std::uint32_t i = handle.index;
    m_meshes.release(instances.mesh[i]);
    m_meshUsers.remove(instances.mesh[i], i);
    m_materials.release(instances.material[i]);
    m_instances.free(handle);
    instances.radius[i] = kNoRadius;
    instances.basis[i] = glm::mat3(0.0f);
    noteInstance(i);
}

void World::setTransform(InstanceHandle handle, const Transform& transform) {
    setTransforms({&handle, 1}, {&transform, 1});
}

void World::setTransforms(std::span<const InstanceHandle> handles, std::span<const Transform> transforms) {
    if (handles.size() != transforms.size()) {
        throw base::inputError("{} instances cannot take {} transforms", handles.size(), transforms.size());
    }
    for (std::size_t i = 0; i < handles.size(); ++i) {
        m_instances.require(handles[i]);
        if (!isUsable(transforms[i])) {
            requireUsable(transforms[i], nameOf("instance", handles[i]));
        }
    }
    for (std::size_t i = 0; i < handles.size(); ++i) {
        placeInstance(m_scene, handles[i].index, transforms[i].position, transforms[i].basis);
        noteInstance(handles[i].index);
    }
}

void World::setMaterial(InstanceHandle instance, MaterialHandle material) {
    m_instances.require(instance);
    m_materials.places().require(material);
    std::uint32_t& used = m_scene.instances.material[instance.index];
    m_materials.release(used);
    used = material.index;
    m_materials.use(used);
    noteInstance(instance.index);
}

LightHandle World::addLight(const PointLight& light) {
    requireUsable(light, "the new light");
    const LightHandle handle = m_lightPlaces.take();
    m_lightOf.resize(m_lightPlaces.size());
    m_lightOf[handle.index] = static_cast<std::uint32_t>(m_scene.lights.size());
    m_scene.lights.push_back(light);
    return handle;
}

void World::setLight(LightHandle handle, const PointLight& light) {
    m_lightPlaces.require(handle);
    requireUsable(light, nameOf("light", handle));
    m_scene.lights[m_lightOf[handle.index]] = light;
}

void World::removeLight(LightHandle handle) {
    m_lightPlaces.require(handle);
    const std::uint32_t removed = m_lightOf[handle.index];
    // The others keep their order, since their light is added up in it.
    m_scene.lights.erase(m_scene.lights.begin() + removed);
    for (std::uint32_t& light : m_lightOf) {
        light -= light > removed ? 1 : 0;
    }
    m_lightPlaces.free(handle);
}

Environment World::environment() const {
    return {
        .ambient = m_scene.ambient, .background = m_scene.background, .sky = m_scene.sky, .air = m_scene.air};
}

void World::setEnvironment(const Environment& environment) {
    requireUsable(environment);
    m_scene.ambient = environment.ambient;
    m_scene.background = environment.background;
    m_scene.sky = environment.sky;
    m_scene.air = environment.air;
}

MeshHandle World::addMesh(Mesh mesh) {
    requireUsable(mesh, "the new mesh");
    return m_meshes.add(m_scene.meshes, std::move(mesh));
}

void World::setVertices(MeshHandle handle, std::vector<Vertex> vertices) {
    m_meshes.places().require(handle);
    setVertices(handle, std::move(vertices), m_scene.meshes[handle.index].details);
}

Mesh& World::requireDeformable(MeshHandle handle, std::size_t vertices) {
    m_meshes.places().require(handle);
    Mesh& mesh = m_scene.meshes[handle.index];
    const std::string what = nameOf("mesh", handle);
    if (vertices != mesh.vertices.size()) {
        throw base::inputError("{}: {} vertices cannot stand in the place of {}", what, vertices,
                               mesh.vertices.size());
    }
    if (!mesh.levels.empty() || !mesh.clusters.clusters.empty()) {
        throw base::InputError(what + ": its levels of detail would not hold for other vertices");
    }
    return mesh;
}

void World::noteVertices(MeshHandle handle) {
    m_vertexChanges.add(handle.index, m_scene.meshes.size());
    for (const std::uint32_t i : m_meshUsers.of(handle.index, m_scene.instances)) {
        placeInstance(m_scene, i, m_scene.instances.position(i), m_scene.instances.basis[i]);
        noteInstance(i);
    }
}

void World::setVertices(MeshHandle handle, std::vector<Vertex> vertices, std::vector<VertexDetail> details) {
    const float radius = boundingRadiusOf(vertices);
    setVertices(handle, {.vertices = std::move(vertices), .details = std::move(details)}, radius);
}

void World::setVertices(MeshHandle handle, MeshVertices deformed, float boundingRadius) {
    Mesh& mesh = requireDeformable(handle, deformed.vertices.size());
    const std::string what = nameOf("mesh", handle);
    requireUsable(deformed.vertices, boundingRadius, what);
    requireUsable(deformed.details, deformed.vertices.size(), what);
    mesh.vertices = std::move(deformed.vertices);
    mesh.details = std::move(deformed.details);
    mesh.boundingRadius = boundingRadius;
    mesh.boxHalfSides.reset();
    m_posed.erase(handle.index);
    noteVertices(handle);
}

Mesh& World::requirePosable(MeshHandle handle, const MeshPose& pose) {
    m_meshes.places().require(handle);
    const std::string what = nameOf("mesh", handle);
    requireUsable(pose, what);
    Mesh& mesh = requireDeformable(handle, pose.deformer->vertices.size());
    const MeshPose* before = this->pose(handle.index);
    if (before == nullptr || before->deformer != pose.deformer) {
        requireUsable(*pose.deformer, what); // takes time by vertices, so not for each pose
        requireAlike(*pose.deformer, mesh, what);
    }
    return mesh;
}

void World::setPose(MeshHandle handle, MeshPose pose) {
    Mesh& mesh = requirePosable(handle, pose);
    const float radius = boundingRadiusOf(pose);
    requireUsable(std::span<const Vertex>(), radius, nameOf("mesh", handle));
    mesh.boundingRadius = radius;
    mesh.boxHalfSides.reset();
    m_posed[handle.index] = {.pose = std::make_shared<const MeshPose>(std::move(pose))};
    noteVertices(handle);
}

void World::setPose(MeshHandle handle, MeshPose pose, MeshVertices deformed) {
    requirePosable(handle, pose);
    setVertices(handle, std::move(deformed), boundingRadiusOf(pose));
    m_posed[handle.index] = {.pose = std::make_shared<const MeshPose>(std::move(pose)),
                             .areVerticesPosed = true};
}

const MeshPose* World::pose(std::uint32_t mesh) const {
    const auto found = m_posed.find(mesh);
    return found == m_posed.end() ? nullptr : found->second.pose.get();
}

std::vector<std::uint32_t> World::posedMeshes() const {
    std::vector<std::uint32_t> meshes;
    for (const auto& [mesh, posed] : m_posed) {
        meshes.push_back(mesh);
    }
    return meshes;
}

bool World::hasPosedVertices() const {
    return std::ranges::all_of(m_posed, [](const auto& entry) { return entry.second.areVerticesPosed; });
}

void World::removeMesh(MeshHandle handle) {
    m_meshes.remove(m_scene.meshes, handle, Mesh{});
    m_posed.erase(handle.index);
}

void World::requireMaterial(const Material& material) const {
    requireUsable(material, m_scene.textures.size(), "the material");
    forEachTexture(material, [&](std::uint32_t texture) { m_textures.places().at(texture); });
}

MaterialHandle World::addMaterial(Material material) {
    requireMaterial(material);
    useTexture(material);
    return m_materials.add(m_scene.materials, std::move(material));
}

void World::setMaterial(MaterialHandle handle, Material material) {
    m_materials.places().require(handle);
    requireMaterial(material);
    releaseTexture(m_scene.materials[handle.index]);
    useTexture(material);
    m_materials.set(m_scene.materials, handle, std::move(material));
}

void World::removeMaterial(MaterialHandle handle) {
    m_materials.requireUnused(handle);
    releaseTexture(m_scene.materials[handle.index]);
    m_materials.remove(m_scene.materials, handle, Material{});
}

TextureHandle World::addTexture(Texture texture) {
    requireUsable(texture, "the new texture");
    return m_textures.add(m_scene.textures, std::move(texture));
}

void World::removeTexture(TextureHandle handle) {
    // A place keeps a pixel, so that no picture is empty.
    m_textures.remove(m_scene.textures, handle,
                      Texture{.name = {}, .pixels = image::ImageRgba8(1, 1, {255, 255, 255, 255})});
}

} // namespace cdr::scene
