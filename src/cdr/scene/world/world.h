#pragma once

#include <cdr/base/export.h>
#include <cdr/scene/animation/mesh_pose.h>
#include <cdr/scene/world/check.h>
#include <cdr/scene/world/mesh_users.h>
#include <cdr/scene/world/table.h>

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace cdr::scene {

/// What an instance is made from.
struct InstanceOptions {
    MeshHandle mesh;         ///< what is drawn
    MaterialHandle material; ///< how it looks
    /// What the id buffer shows plus one, at most kMaxObjects. Instances may share it: parts of one object.
    std::uint32_t object = 0;
    Transform transform{}; ///< where it is
};

/// A scene that changes while it is drawn. It is the one owner of what it holds; a render::GpuScene made from it follows
/// at the start of each frame. So all that draws sees an edit in the same frame.
///
/// A copy accepts the handles of the world that it is copied from. Handles that one of the two returns after that must not
/// be used with the other: there they may name another object. A world that is assigned to, as by undo, is drawn as it is
/// then, at the cost of reading it whole.
///
/// Instances are drawn in the order of their places (Handle::index). A new one takes the place given back last. A place
/// that is free keeps an instance without size, which no picture and no truth shows.
/// @threads Edits and frames belong on one thread, or take turns.
/// @errors Every function throws base::InputError and changes nothing in three cases. A handle or an index names what is
///         not there (any more), a handle is of another world, or a value cannot be drawn.
/// @lifetime References are valid as long as the world, which must stay where it is. What they refer to changes.
class CDR_EXPORT World {
  public:
    World() : World(Scene{}) {}
    /// Of another world's scene, instances that it removed are not there, and their places are free. Meshes,
    /// materials and textures that it removed are there as what holds their places: an empty mesh, a default material, a white
    /// pixel. They can be removed again.
    /// @throws base::InputError as requireUsable(scene). So it may refuse the scene of a world with poses that the device draws (setPose):
    ///         the bounds of its meshes are those of the poses, and its vertices are not.
    explicit World(Scene scene);

    /// As it is now.
    const Scene& scene() const { return m_scene; }

    /// Handles of what the scene held when the world was made, by index; or of what is at that place now.
    InstanceHandle instance(std::size_t index) const { return m_instances.at(index); }
    /// As instance().
    MeshHandle mesh(std::size_t index) const { return m_meshes.places().at(index); }
    /// As instance().
    MaterialHandle material(std::size_t index) const { return m_materials.places().at(index); }
    /// As instance().
    TextureHandle texture(std::size_t index) const { return m_textures.places().at(index); }
    /// As instance().
    LightHandle light(std::size_t index) const { return m_lightPlaces.at(index); }

    /// Makes an instance; its handle names it until it is removed.
    InstanceHandle addInstance(const InstanceOptions& options);
    /// Frames in flight still show it.
    void removeInstance(InstanceHandle handle);
    /// Moves an instance.
    void setTransform(InstanceHandle handle, const Transform& transform);
    /// The same for many: all of them or, if one cannot be, none. Takes time by their number.
    void setTransforms(std::span<const InstanceHandle> handles, std::span<const Transform> transforms);
    /// Gives an instance another material.
    void setMaterial(InstanceHandle instance, MaterialHandle material);

    /// Makes a light.
    LightHandle addLight(const PointLight& light);
    /// Moves or changes a light.
    void setLight(LightHandle handle, const PointLight& light);
    /// The handle names nothing afterwards.
    void removeLight(LightHandle handle);

    /// What surrounds the things, as the scene says now.
    Environment environment() const;
    /// Changes it, for day and night. Where a sky or air comes or goes, the next frame of each renderer takes longer, since its
    /// passes are made anew. Through a lens with a focus, another background does the same, and air is refused by the frame.
    void setEnvironment(const Environment& environment);

    /// Makes a mesh that instances may use.
    MeshHandle addMesh(Mesh mesh);
    /// Gives a mesh other vertices in the place of its own, as many; its triangles stay. All instances that have it are
    /// drawn with them, and get radii that bound them. Takes time by the number of vertices and of these instances. A mesh
    /// with levels of detail keeps its vertices, since the levels' errors would no longer hold.
    void setVertices(MeshHandle handle, std::vector<Vertex> vertices);
    /// The same with other details, one per vertex or none.
    void setVertices(MeshHandle handle, std::vector<Vertex> vertices, std::vector<VertexDetail> details);
    /// The same with a bounding radius that is not the least one.
    /// @param boundingRadius object space, about the origin
    void setVertices(MeshHandle handle, MeshVertices deformed, float boundingRadius);
    /// Gives a mesh the vertices that deform() makes of a pose, which the device makes for itself. Those of scene() stay as
    /// they are, and only drawing sees the new ones: not truth, certificates and SurfacePath other than `gbuffer`. The bounds
    /// are boundingRadiusOf(). They need not hold the vertices of scene(), so that another World of scene() may be refused; a
    /// copy of this one is not. Takes time by the number of joints and morph targets. The first pose of a mesh by a deformer
    /// also takes time by the number of vertices. setVertices() ends it.
    /// @param pose of as many vertices as the mesh has, with its colours, texture coordinates and number of details
    /// @errors base::InputError also where the deformer has others of these: the device writes positions, normals and tangents
    ///         alone. And where requireUsable() refuses the pose or its deformer, or the bounds are not finite.
    void setPose(MeshHandle handle, MeshPose pose);
    /// The same where the CPU reads the vertices too.
    /// @param deformed what deform() makes of the pose; scene() gets these
    /// @errors As without them, and as setVertices().
    void setPose(MeshHandle handle, MeshPose pose, MeshVertices deformed);
    /// The pose that gives a mesh its vertices, by place; null where it has those of scene().
    /// @errors None.
    const MeshPose* pose(std::uint32_t mesh) const;
    /// The meshes that have a pose, ascending.
    /// @errors None.
    std::vector<std::uint32_t> posedMeshes() const;
    /// Whether the vertices of scene() are those of all poses.
    /// @errors None.
    bool hasPosedVertices() const;
    /// No instance may use it.
    void removeMesh(MeshHandle handle);
    /// A material names its texture by TextureHandle::index.
    MaterialHandle addMaterial(Material material);
    /// Changes a material for all instances that have it.
    void setMaterial(MaterialHandle handle, Material material);
    /// No instance may use it.
    void removeMaterial(MaterialHandle handle);
    /// Makes a texture that materials may use.
    TextureHandle addTexture(Texture texture);
    /// No material may use it.
    void removeTexture(TextureHandle handle);

    /// What changed, for those that follow. Lights and surroundings are few and read again every frame.
    struct Changes {
        const ChangeLog& instances; ///< by place
        const ChangeLog& meshes;    ///< by place
        const ChangeLog& materials; ///< by place
        const ChangeLog& textures;  ///< by place
        const ChangeLog& vertices;  ///< of meshes, by place, where these alone changed
    };
    /// What changed since the world was made; each log grows as edits are made.
    Changes changes() const {
        return {m_instanceChanges, m_meshes.changes(), m_materials.changes(), m_textures.changes(),
                m_vertexChanges};
    }

  private:
    void requireInstance(const InstanceOptions& options) const;
    void requireMaterial(const Material& material) const;
    void noteInstance(std::uint32_t index);
    void useTexture(const Material& material);
    void releaseTexture(const Material& material);
    /// The mesh, if it may get so many other vertices.
    Mesh& requireDeformable(MeshHandle handle, std::size_t vertices);
    /// The mesh, if it may have such a pose.
    Mesh& requirePosable(MeshHandle handle, const MeshPose& pose);
    void noteVertices(MeshHandle handle);

    /// How a mesh gets its vertices.
    struct Posed {
        std::shared_ptr<const MeshPose> pose; ///< copies of the world share it
        bool areVerticesPosed = false;        ///< those of the scene
    };

    Scene m_scene;
    std::uint32_t m_id; ///< in the handles that it gives
    Places<InstanceKind> m_instances;
    ChangeLog m_instanceChanges;
    Table<MeshKind> m_meshes;
    MeshUsers m_meshUsers;
    ChangeLog m_vertexChanges;
    std::map<std::uint32_t, Posed> m_posed; ///< by mesh
    Table<MaterialKind> m_materials;
    Table<TextureKind> m_textures;
    Places<LightKind> m_lightPlaces;
    std::vector<std::uint32_t> m_lightOf; ///< by place: into Scene::lights, which has no free places
};

} // namespace cdr::scene
