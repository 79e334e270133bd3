#pragma once

#include <cdr/scene/world/world.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace cdr::render_test {

using scene::World;

/// What a world should hold, kept apart from it, and the scene that this makes when built from scratch.
struct Expected {
    struct Object {
        scene::InstanceHandle handle;
        std::size_t mesh; ///< a key of `meshes`
        std::size_t material;
        std::uint32_t object;
        scene::Transform transform;
    };
    struct Look {
        scene::MaterialHandle handle;
        scene::Material material; ///< its textures are keys of `textures`
    };
    std::vector<Object> objects;
    std::map<std::size_t, std::pair<scene::MeshHandle, scene::Mesh>> meshes;
    std::map<std::size_t, Look> materials;
    std::map<std::size_t, std::pair<scene::TextureHandle, scene::Texture>> textures;
    std::vector<std::pair<scene::LightHandle, scene::PointLight>> lights;
    std::size_t nextKey = 0;

    scene::Scene build() const {
        scene::Scene made;
        std::map<std::size_t, std::uint32_t> meshAt;
        std::map<std::size_t, std::uint32_t> materialAt;
        std::map<std::size_t, std::uint32_t> textureAt;
        for (const auto& [key, mesh] : meshes) {
            meshAt[key] = static_cast<std::uint32_t>(made.meshes.size());
            made.meshes.push_back(mesh.second);
        }
        for (const auto& [key, texture] : textures) {
            textureAt[key] = static_cast<std::uint32_t>(made.textures.size());
            made.textures.push_back(texture.second);
        }
        for (const auto& [key, look] : materials) {
            materialAt[key] = static_cast<std::uint32_t>(made.materials.size());
            made.materials.push_back(look.material);
            scene::forEachTexture(made.materials.back(),
                                  [&](std::uint32_t& texture) { texture = textureAt.at(texture); });
        }
        std::vector<Object> ordered = objects;
        std::sort(ordered.begin(), ordered.end(),
                  [](const Object& a, const Object& b) { return a.handle.index < b.handle.index; });
        for (const Object& object : ordered) {
            scene::addInstance(made, meshAt.at(object.mesh), materialAt.at(object.material), object.object,
                               object.transform.position, object.transform.basis);
        }
        for (const auto& light : lights) {
            made.lights.push_back(light.second);
        }
        return made;
    }
};

/// Edits a world at random, and what is expected of it alike.
class Editor {
  public:
    /// What meshes and materials are made: of all kinds, or such as a visibility buffer shows.
    enum class Palette { any, facets };

    Editor(std::uint64_t seed, World& world, Palette palette = Palette::any)
        : m_random(seed),
          m_world(world),
          m_palette(palette) {}

    /// A world to begin with.
    void populate(std::size_t instances) {
        for (int i = 0; i < 4; ++i) {
            addMesh();
        }
        for (int i = 0; i < 3; ++i) {
            addMaterial(false);
        }
        addLight();
        for (std::size_t i = 0; i < instances; ++i) {
            addInstance();
        }
    }

    /// What may be edited. A change of tables has everything read again, and one of kinds has the device's
    /// runs made again. So what follows single changes is tried without.
    enum class Scope : std::size_t { moves = 600, instances = 985, all = 1000 };

    void edit(Scope scope = Scope::all) { edit(below(static_cast<std::size_t>(scope)), scope); }

    /// Half of the edits change meshes, materials or textures.
    void editEvenly() {
        constexpr std::array<std::size_t, 12> kFirstOfKind{0,   600, 740, 890, 950, 965,
                                                           985, 985, 985, 985, 985, 985};
        edit(kFirstOfKind[below(kFirstOfKind.size())], Scope::all);
    }

    /// Kinds of edits that change meshes, materials or textures.
    static constexpr std::size_t kTableKinds = 7;
    static constexpr std::size_t kFirstRemoval =
        4; ///< of these: meshes and materials go with their instances
    /// @param kind below kTableKinds
    void editTables(std::size_t kind) {
        switch (kind) {
        case 0:
            addMesh();
            break;
        case 1:
            addMaterial(true);
            break;
        case 2: {
            Expected::Look& look = pick(m_expected.materials)->second;
            look.material = randomMaterial(true);
            m_world.setMaterial(look.handle, named(look.material));
            break;
        }
        case 3:
            addTexture();
            break;
        case 4:
            removeUnused(
                m_expected.meshes, [&](std::size_t key) { m_world.removeMesh(m_expected.meshes[key].first); },
                [](const Expected::Object& object) { return object.mesh; });
            break;
        case 5:
            removeUnused(
                m_expected.materials,
                [&](std::size_t key) { m_world.removeMaterial(m_expected.materials[key].handle); },
                [](const Expected::Object& object) { return object.material; });
            break;
        default:
            removeTexture();
        }
    }

    const Expected& expected() const { return m_expected; }

  private:
    void edit(std::size_t kind, Scope scope) {
        if (kind < 600) {
            move(1 + below(4), scope == Scope::moves);
        } else if (kind < 740) {
            addInstance();
        } else if (kind < 890) {
            removeInstance();
        } else if (kind < 950) {
            setMaterialOfInstance();
        } else if (kind < 965) {
            deform();
        } else if (kind < 985) {
            editLights();
        } else {
            editTables(below(kTableKinds));
        }
    }

    std::size_t below(std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(m_random);
    }
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(m_random);
    }

    template <typename Map>
    typename Map::iterator pick(Map& map) {
        return std::next(map.begin(), static_cast<std::ptrdiff_t>(below(map.size())));
    }

    scene::Transform randomTransform() {
        const double ahead = between(2.0, 900.0);
        scene::Transform made{.position = {between(-0.6, 0.6) * ahead, between(-0.4, 0.4) * ahead, -ahead},
                              .basis = glm::mat3(static_cast<float>(between(0.5, 3.0)))};
        if (below(6) == 0) {
            made.basis[0] = -made.basis[0]; // a mirror
        }
        return made;
    }

    /// @param isRigid: mirrors stay mirrors, so that draws keep their kind
    void move(std::size_t count, bool isRigid) {
        std::vector<scene::InstanceHandle> handles;
        std::vector<scene::Transform> transforms;
        for (std::size_t i = 0; i < count && !m_expected.objects.empty(); ++i) {
            Expected::Object& object = *pick(m_expected.objects);
            const float before = glm::determinant(object.transform.basis);
            object.transform = randomTransform();
            if (isRigid && before * glm::determinant(object.transform.basis) < 0.0f) {
                object.transform.basis[0] = -object.transform.basis[0];
            }
            handles.push_back(object.handle);
            transforms.push_back(object.transform);
        }
        m_world.setTransforms(handles, transforms);
    }

    /// Another one each time, in no order: each object is one that moves as a whole.
    std::uint32_t nextObject() {
        constexpr std::uint64_t kPrime = 1'000'003;
        return static_cast<std::uint32_t>(++m_objects * 7919 % kPrime);
    }

    void addInstance() {
        Expected::Object made{.handle = {},
                              .mesh = pick(m_expected.meshes)->first,
                              .material = pick(m_expected.materials)->first,
                              .object = nextObject(),
                              .transform = randomTransform()};
        made.handle = m_world.addInstance({.mesh = m_expected.meshes.at(made.mesh).first,
                                           .material = m_expected.materials.at(made.material).handle,
                                           .object = made.object,
                                           .transform = made.transform});
        m_expected.objects.push_back(made);
    }

    void removeInstance() {
        if (m_expected.objects.empty()) {
            return;
        }
        const auto removed = pick(m_expected.objects);
        m_world.removeInstance(removed->handle);
        m_expected.objects.erase(removed);
    }

    void setMaterialOfInstance() {
        if (m_expected.objects.empty()) {
            return;
        }
        Expected::Object& object = *pick(m_expected.objects);
        object.material = pick(m_expected.materials)->first;
        m_world.setMaterial(object.handle, m_expected.materials.at(object.material).handle);
    }

    /// Gives a mesh without levels other vertices, now and then with facets.
    void deform() {
        const auto found = std::find_if(pick(m_expected.meshes), m_expected.meshes.end(),
                                        [](const auto& entry) { return entry.second.second.levels.empty(); });
        if (found == m_expected.meshes.end()) {
            return;
        }
        auto& [handle, mesh] = found->second;
        const bool hasFacets = below(2) == 0;
        const auto scale = static_cast<float>(between(0.7, 1.4));
        for (scene::Vertex& vertex : mesh.vertices) {
            if (m_palette == Palette::facets) {
                vertex.position *= scale;
                continue;
            }
            vertex.position *= static_cast<float>(between(0.7, 1.4));
            vertex.normal = hasFacets ? glm::vec3(0.0f, 0.0f, 1.0f) : glm::normalize(vertex.position);
        }
        mesh.boundingRadius = scene::boundingRadiusOf(mesh.vertices);
        mesh.boxHalfSides.reset();
        m_world.setVertices(handle, mesh.vertices);
    }

    void shape(scene::PointLight& light) {
        light.range = below(3) == 0 ? std::optional(between(50.0, 200.0)) : std::nullopt;
        light.cone.reset();
        if (below(3) == 0) {
            light.cone = {.direction =
                              glm::normalize(glm::dvec3(between(-1.0, 1.0), -1.0, between(-1.0, 1.0))),
                          .inner = between(0.0, 0.4),
                          .outer = between(0.5, 1.5)};
        }
    }

    void addLight() {
        scene::PointLight light{.position = {between(-50.0, 50.0), between(0.0, 50.0), between(-200.0, 0.0)},
                                .color = glm::vec3(static_cast<float>(between(0.1, 0.9))),
                                .halfDistance = between(5.0, 100.0)};
        shape(light);
        m_expected.lights.emplace_back(m_world.addLight(light), light);
    }

    void editLights() {
        const std::size_t kind = below(3);
        if (m_expected.lights.empty() || (kind == 0 && m_expected.lights.size() < 7)) {
            addLight();
        } else if (kind == 1) {
            const auto removed = pick(m_expected.lights);
            m_world.removeLight(removed->first);
            m_expected.lights.erase(removed);
        } else {
            auto& [handle, light] = *pick(m_expected.lights);
            light.halfDistance = between(5.0, 100.0);
            shape(light);
            m_world.setLight(handle, light);
        }
    }

    void addMesh() {
        scene::Mesh mesh = scene::makeBox({static_cast<float>(between(0.2, 1.0)), 0.5f, 0.4f});
        if (m_palette == Palette::any && below(2) == 0) {
            for (scene::Vertex& vertex : mesh.vertices) {
                vertex.normal = glm::normalize(vertex.position); // no facets
                mesh.details.push_back({.tangent = {1.0f, 0.0f, 0.0f, 1.0f}, .uv = {vertex.normal}});
            }
            mesh.boxHalfSides.reset();
            // Half of it serves as a coarser level.
            mesh.levels.push_back(
                {.indices = {mesh.indices.begin(), mesh.indices.begin() + 18}, .error = 0.2f});
        }
        m_expected.meshes[m_expected.nextKey++] = {m_world.addMesh(mesh), mesh};
    }

    scene::Material randomMaterial(bool any) {
        scene::Material made{.name = "made",
                             .baseColorFactor = glm::vec4(static_cast<float>(between(0.1, 1.0)),
                                                          static_cast<float>(between(0.1, 1.0)), 0.5f, 0.6f)};
        if (any && m_palette == Palette::any) {
            made.doubleSided = below(3) == 0;
            made.unlit = below(4) == 0;
            made.alphaMode = static_cast<scene::AlphaMode>(below(3));
            if (below(3) == 0) {
                made.metallicRoughness = scene::MetallicRoughness{.metallic = 0.5f, .roughness = 0.4f};
            }
            made.baseColorTexture = randomTexture();
            if (below(2) == 0) {
                made.detail.emission = glm::vec3(static_cast<float>(between(0.0, 0.5)));
                made.detail.normal = randomUse();
                made.detail.emissive = randomUse();
                made.detail.occlusion = randomUse();
            }
        }
        return made;
    }

    /// The key of one that is there, or none.
    std::optional<std::uint32_t> randomTexture() {
        if (m_expected.textures.empty() || below(2) == 0) {
            return std::nullopt;
        }
        return static_cast<std::uint32_t>(pick(m_expected.textures)->first);
    }
    std::optional<scene::TextureUse> randomUse() {
        const std::optional<std::uint32_t> texture = randomTexture();
        return texture ? std::optional(scene::TextureUse{.texture = *texture, .second = below(2) == 0})
                       : std::nullopt;
    }

    /// With the textures' places for their keys.
    scene::Material named(scene::Material material) const {
        scene::forEachTexture(
            material, [&](std::uint32_t& texture) { texture = m_expected.textures.at(texture).first.index; });
        return material;
    }

    void addMaterial(bool any) {
        const scene::Material made = randomMaterial(any);
        m_expected.materials[m_expected.nextKey++] = {m_world.addMaterial(named(made)), made};
    }

    void addTexture() {
        image::ImageRgba8 pixels(4, 4, {255, 255, 255, 255});
        for (image::Rgba8& pixel : pixels.pixels) {
            pixel[0] = static_cast<std::uint8_t>(below(256));
            pixel[3] = static_cast<std::uint8_t>(128 + below(128));
        }
        const scene::Texture texture{.name = "made",
                                     .pixels = pixels,
                                     .wrapU = below(2) == 0 ? scene::WrapMode::repeat
                                                            : scene::WrapMode::clampToEdge,
                                     .content = static_cast<scene::TextureContent>(below(2))};
        m_expected.textures[m_expected.nextKey++] = {m_world.addTexture(texture), texture};
    }

    /// Removes one mesh or material with all instances of it.
    template <typename Map, typename Remove, typename KeyOf>
    void removeUnused(Map& map, Remove remove, KeyOf keyOf) {
        if (map.size() < 2) {
            return;
        }
        const std::size_t key = pick(map)->first;
        std::erase_if(m_expected.objects, [&](const Expected::Object& object) {
            if (keyOf(object) == key) {
                m_world.removeInstance(object.handle);
                return true;
            }
            return false;
        });
        remove(key);
        map.erase(key);
    }

    void removeTexture() {
        if (m_expected.textures.empty()) {
            return;
        }
        const auto removed = pick(m_expected.textures);
        const auto drop = [&](auto& texture, std::size_t key) {
            if (texture && key == removed->first) {
                texture.reset();
            }
        };
        for (auto& [key, look] : m_expected.materials) {
            const scene::Material before = look.material;
            scene::MaterialDetail& detail = look.material.detail;
            drop(look.material.baseColorTexture, before.baseColorTexture.value_or(0));
            for (auto* use : {&detail.normal, &detail.emissive, &detail.occlusion}) {
                drop(*use, *use ? (*use)->texture : 0);
            }
            if (before.detail != detail || before.baseColorTexture != look.material.baseColorTexture) {
                m_world.setMaterial(look.handle, named(look.material));
            }
        }
        m_world.removeTexture(removed->second.first);
        m_expected.textures.erase(removed);
    }

    std::mt19937_64 m_random;
    World& m_world;
    Palette m_palette;
    std::uint64_t m_objects = 0; ///< that got a number
    Expected m_expected;
};

} // namespace cdr::render_test
