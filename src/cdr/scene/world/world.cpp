#include <cdr/base/error.h>
#include <cdr/scene/world/world.h>

#include <fmt/format.h>

#include <utility>

namespace cdr::scene {

namespace {

template <typename Kind>
Handle<Kind> handleAt(const Places<Kind>& places, std::size_t index, const char* kind) {
    if (!places.isTaken(index)) {
        throw base::InputError(fmt::format("{} {} is not there", kind, index));
    }
    return places.at(index);
}

template <typename Kind>
void requireHandle(const Places<Kind>& places, Handle<Kind> handle, const char* kind) {
    if (!places.has(handle)) {
        throw base::InputError(fmt::format("{} {} (generation {}) is not there: {}", kind, handle.index,
                                           handle.generation,
                                           handle.index < places.size() ? "it was removed" : "it never was"));
    }
}

void requireUnused(std::uint32_t uses, std::uint32_t index, const char* kind, const char* users) {
    if (uses > 0) {
        throw base::InputError(
            fmt::format("{} {} cannot be removed: {} {} use it", kind, index, uses, users));
    }
}

template <typename Kind>
std::string nameOf(const char* kind, Handle<Kind> handle) {
    return fmt::format("{} {}", kind, handle.index);
}

/// Puts a value at a place, which may be one beyond the last.
template <typename T>
void put(std::vector<T>& values, std::uint32_t index, T value) {
    if (index == values.size()) {
        values.push_back(std::move(value));
    } else {
        values[index] = std::move(value);
    }
}

} // namespace

World::World(Scene scene)
    : m_scene(std::move(scene)),
      m_instances(m_scene.instances.size()),
      m_meshes(m_scene.meshes.size()),
      m_materials(m_scene.materials.size()),
      m_textures(m_scene.textures.size()),
      m_lightPlaces(m_scene.lights.size()),
      m_meshUses(m_scene.meshes.size()),
      m_materialUses(m_scene.materials.size()),
      m_textureUses(m_scene.textures.size()) {
    requireUsable(m_scene);
    for (std::uint32_t light = 0; light < m_scene.lights.size(); ++light) {
        m_lightOf.push_back(light);
    }
    for (std::size_t i = 0; i < m_scene.instances.size(); ++i) {
        ++m_meshUses[m_scene.instances.mesh[i]];
        ++m_materialUses[m_scene.instances.material[i]];
    }
    for (const Material& material : m_scene.materials) {
        useTexture(material, 1);
    }
}

InstanceHandle World::instance(std::size_t index) const {
    return handleAt(m_instances, index, "instance");
}

MeshHandle World::mesh(std::size_t index) const {
    return handleAt(m_meshes, index, "mesh");
}

MaterialHandle World::material(std::size_t index) const {
    return handleAt(m_materials, index, "material");
}

TextureHandle World::texture(std::size_t index) const {
    return handleAt(m_textures, index, "texture");
}

LightHandle World::light(std::size_t index) const {
    return handleAt(m_lightPlaces, index, "light");
}

void World::noteInstance(std::uint32_t index) {
    m_changes.instances.add(index, m_scene.instances.size());
}

void World::useTexture(const Material& material, int uses) {
    if (material.baseColorTexture) {
        m_textureUses[*material.baseColorTexture] += static_cast<std::uint32_t>(uses);
    }
}

void World::requireInstance(const InstanceOptions& options) const {
    requireHandle(m_meshes, options.mesh, "mesh");
    requireHandle(m_materials, options.material, "material");
    if (options.object > kMaxObjects) {
        throw base::InputError(fmt::format("object {} is over the limit of {}", options.object, kMaxObjects));
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
    ++m_meshUses[options.mesh.index];
    ++m_materialUses[options.material.index];
    noteInstance(i);
    return handle;
}

void World::removeInstance(InstanceHandle handle) {
    requireHandle(m_instances, handle, "instance");
    Instances& instances = m_scene.instances;
    const std::uint32_t i = handle.index;
    --m_meshUses[instances.mesh[i]];
    --m_materialUses[instances.material[i]];
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
        throw base::InputError(
            fmt::format("{} instances cannot take {} transforms", handles.size(), transforms.size()));
    }
    for (std::size_t i = 0; i < handles.size(); ++i) {
        requireHandle(m_instances, handles[i], "instance");
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
    requireHandle(m_instances, instance, "instance");
    requireHandle(m_materials, material, "material");
    std::uint32_t& used = m_scene.instances.material[instance.index];
    --m_materialUses[used];
    used = material.index;
    ++m_materialUses[used];
    noteInstance(instance.index);
}

LightHandle World::addLight(const PointLight& light) {
    requireUsable(light, "the new light");
    const LightHandle handle = m_lightPlaces.take();
    put(m_lightOf, handle.index, static_cast<std::uint32_t>(m_scene.lights.size()));
    m_scene.lights.push_back(light);
    return handle;
}

void World::setLight(LightHandle handle, const PointLight& light) {
    requireHandle(m_lightPlaces, handle, "light");
    requireUsable(light, nameOf("light", handle));
    m_scene.lights[m_lightOf[handle.index]] = light;
}

void World::removeLight(LightHandle handle) {
    requireHandle(m_lightPlaces, handle, "light");
    const std::uint32_t removed = m_lightOf[handle.index];
    // The others keep their order, since their light is added up in it.
    m_scene.lights.erase(m_scene.lights.begin() + removed);
    for (std::uint32_t& light : m_lightOf) {
        light -= light > removed ? 1 : 0;
    }
    m_lightPlaces.free(handle);
}

MeshHandle World::addMesh(Mesh mesh) {
    requireUsable(mesh, "the new mesh");
    const MeshHandle handle = m_meshes.take();
    put(m_scene.meshes, handle.index, std::move(mesh));
    put(m_meshUses, handle.index, 0u);
    m_changes.meshes.add(handle.index, m_scene.meshes.size());
    return handle;
}

void World::removeMesh(MeshHandle handle) {
    requireHandle(m_meshes, handle, "mesh");
    requireUnused(m_meshUses[handle.index], handle.index, "mesh", "instances");
    m_meshes.free(handle);
    m_scene.meshes[handle.index] = {};
    m_changes.meshes.add(handle.index, m_scene.meshes.size());
}

void World::requireMaterial(const Material& material) const {
    requireUsable(material, m_scene.textures.size(), "the material");
    if (material.baseColorTexture) {
        handleAt(m_textures, *material.baseColorTexture, "texture");
    }
}

MaterialHandle World::addMaterial(Material material) {
    requireMaterial(material);
    const MaterialHandle handle = m_materials.take();
    useTexture(material, 1);
    put(m_scene.materials, handle.index, std::move(material));
    put(m_materialUses, handle.index, 0u);
    m_changes.materials.add(handle.index, m_scene.materials.size());
    return handle;
}

void World::setMaterial(MaterialHandle handle, Material material) {
    requireHandle(m_materials, handle, "material");
    requireMaterial(material);
    useTexture(m_scene.materials[handle.index], -1);
    useTexture(material, 1);
    m_scene.materials[handle.index] = std::move(material);
    m_changes.materials.add(handle.index, m_scene.materials.size());
}

void World::removeMaterial(MaterialHandle handle) {
    requireHandle(m_materials, handle, "material");
    requireUnused(m_materialUses[handle.index], handle.index, "material", "instances");
    useTexture(m_scene.materials[handle.index], -1);
    m_materials.free(handle);
    m_scene.materials[handle.index] = {};
    m_changes.materials.add(handle.index, m_scene.materials.size());
}

TextureHandle World::addTexture(Texture texture) {
    requireUsable(texture, "the new texture");
    const TextureHandle handle = m_textures.take();
    put(m_scene.textures, handle.index, std::move(texture));
    put(m_textureUses, handle.index, 0u);
    m_changes.textures.add(handle.index, m_scene.textures.size());
    return handle;
}

void World::removeTexture(TextureHandle handle) {
    requireHandle(m_textures, handle, "texture");
    requireUnused(m_textureUses[handle.index], handle.index, "texture", "materials");
    m_textures.free(handle);
    // A place keeps a pixel, so that no picture is empty.
    m_scene.textures[handle.index] = {.name = {}, .pixels = image::ImageRgba8(1, 1, {255, 255, 255, 255})};
    m_changes.textures.add(handle.index, m_scene.textures.size());
}

} // namespace cdr::scene
