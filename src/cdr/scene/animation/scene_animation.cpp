#include <cdr/scene/animation/scene_animation.h>
#include <cdr/scene/world/check.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace cdr::scene {

namespace {

/// Vertices that a worker deforms at a time.
constexpr std::size_t kVerticesPerJob = 2048;

/// What a motion works with; the functions of a SceneMotion share it.
struct Moved {
    std::shared_ptr<const SceneAnimation> all;
    const Animation* animation = nullptr; ///< null for rest
    FrameClock clock;
    std::vector<std::size_t> carried;  ///< into SceneAnimation::carried
    std::vector<std::size_t> deformed; ///< into SceneAnimation::deformed

    Pose poseAt(std::uint32_t frame) const {
        return scene::poseAt(all->rig, animation, clock.secondsAt(frame));
    }
};

Transform transformOf(const glm::dvec3& position, const glm::dmat3& linear) {
    const glm::mat3 basis(linear);
    return {.position = position,
            .basis = glm::determinant(glm::dmat3(basis)) == 0.0 ? glm::mat3(0.0f) : basis};
}

std::vector<std::vector<glm::dmat4>> jointsOf(const SceneAnimation& all, const Pose& pose) {
    std::vector<std::vector<glm::dmat4>> joints(all.skins.size());
    for (std::size_t skin = 0; skin < joints.size(); ++skin) {
        for (std::size_t i = 0; i < all.skins[skin].joints.size(); ++i) {
            joints[skin].push_back(pose.toWorld[all.skins[skin].joints[i]] * all.skins[skin].inverseBind[i]);
        }
    }
    return joints;
}

DeformedPlace placeOf(const DeformedMesh& mesh, const DeformedCopy& copy, const Pose& pose,
                      const std::vector<std::vector<glm::dmat4>>& joints) {
    if (mesh.skin) {
        return placeOf(mesh.deformer, joints[*mesh.skin]);
    }
    const glm::dmat4& ofNode = pose.toWorld[mesh.node];
    return placeOf(mesh.deformer, copy.toNode ? ofNode * *copy.toNode : ofNode);
}

std::vector<Transform> transformsAt(const Moved& moved, std::uint32_t frame) {
    const Pose pose = moved.poseAt(frame);
    const auto joints = jointsOf(*moved.all, pose);
    std::vector<Transform> transforms;
    for (const std::size_t i : moved.carried) {
        const CarriedInstance& instance = moved.all->carried[i];
        const glm::dmat4& ofNode = pose.toWorld[instance.node];
        const glm::dmat4 toWorld = instance.toNode ? ofNode * *instance.toNode : ofNode;
        transforms.push_back(
            transformOf(glm::dvec3(toWorld * glm::dvec4(instance.origin, 1.0)), glm::dmat3(toWorld)));
    }
    for (const std::size_t i : moved.deformed) {
        for (const DeformedCopy& copy : moved.all->deformed[i].copies) {
            const DeformedPlace place = placeOf(moved.all->deformed[i], copy, pose, joints);
            transforms.push_back(transformOf(place.position, place.basis));
        }
    }
    return transforms;
}

std::vector<MeshPose> posesAt(const Moved& moved, std::uint32_t frame) {
    const Pose pose = moved.poseAt(frame);
    const auto joints = jointsOf(*moved.all, pose);
    std::vector<MeshPose> poses;
    for (const std::size_t i : moved.deformed) {
        const DeformedMesh& mesh = moved.all->deformed[i];
        const RigNode& node = moved.all->rig.nodes[mesh.node];
        const auto weights = std::span(pose.weights).subspan(node.firstWeight, node.weightCount);
        poses.push_back({.deformer = {moved.all, &mesh.deformer},
                         .weights = {weights.begin(), weights.end()},
                         .joints = mesh.skin ? joints[*mesh.skin] : std::vector<glm::dmat4>(),
                         .place = placeOf(mesh, mesh.copies.front(), pose, joints)});
    }
    return poses;
}

std::vector<MeshVertices> verticesAt(const Moved& moved, std::uint32_t frame, platform::WorkerPool& workers) {
    const std::vector<MeshPose> poses = posesAt(moved, frame);
    struct Job {
        std::size_t mesh; ///< into the result
        std::size_t first;
    };
    std::vector<Job> jobs;
    std::vector<MeshVertices> meshes(poses.size());
    for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) {
        const Deformer& deformer = *poses[mesh].deformer;
        meshes[mesh].vertices.resize(deformer.vertices.size());
        meshes[mesh].details.resize(deformer.details.size());
        for (std::size_t first = 0; first < deformer.vertices.size(); first += kVerticesPerJob) {
            jobs.push_back({mesh, first});
        }
    }
    workers.run(jobs.size(), [&](std::size_t job, std::size_t) {
        const auto [mesh, first] = jobs[job];
        const std::size_t last = std::min(first + kVerticesPerJob, meshes[mesh].vertices.size());
        deform(*poses[mesh].deformer, poses[mesh].deformation(), first, last, meshes[mesh]);
    });
    workers.run(meshes.size(), [&](std::size_t mesh, std::size_t) {
        setFlatNormals(*poses[mesh].deformer, meshes[mesh].vertices);
    });
    return meshes;
}

/// What the chosen animation reaches; without one all that deforms.
void select(Moved& moved) {
    const SceneAnimation& all = *moved.all;
    std::vector<bool> nodes(all.rig.nodes.size(), moved.animation == nullptr);
    if (moved.animation != nullptr) {
        nodes = movedBy(all.rig, *moved.animation);
    }
    for (std::size_t i = 0; moved.animation != nullptr && i < all.carried.size(); ++i) {
        if (nodes[all.carried[i].node]) {
            moved.carried.push_back(i);
        }
    }
    for (std::size_t i = 0; i < all.deformed.size(); ++i) {
        const DeformedMesh& mesh = all.deformed[i];
        const auto isMoved = [&](std::size_t joint) { return nodes[joint]; };
        const bool byJoints = mesh.skin && std::ranges::any_of(all.skins[*mesh.skin].joints, isMoved);
        if (nodes[mesh.node] || byJoints) {
            moved.deformed.push_back(i);
        }
    }
}

} // namespace

SceneMotion motionOf(const std::shared_ptr<const SceneAnimation>& animation,
                     std::optional<std::size_t> chosen, const FrameClock& clock) {
    const auto moved = std::make_shared<Moved>();
    moved->all = animation;
    moved->animation = chosen ? &animation->animations[*chosen] : nullptr;
    moved->clock = clock;
    select(*moved);
    SceneMotion motion;
    for (const std::size_t i : moved->carried) {
        motion.instances.push_back(animation->carried[i].instance);
    }
    for (const std::size_t i : moved->deformed) {
        for (const DeformedCopy& copy : animation->deformed[i].copies) {
            motion.instances.push_back(copy.instance);
        }
        motion.meshes.push_back(animation->deformed[i].mesh);
    }
    motion.transforms = [moved](std::uint32_t frame) { return transformsAt(*moved, frame); };
    motion.poses = [moved](std::uint32_t frame) { return posesAt(*moved, frame); };
    motion.vertices = [moved](std::uint32_t frame, platform::WorkerPool& workers) {
        return verticesAt(*moved, frame, workers);
    };
    return motion;
}

void show(Scene& scene, const SceneMotion& motion, std::uint32_t frame, platform::WorkerPool& workers) {
    if (!motion) {
        return;
    }
    if (!motion.meshes.empty()) {
        std::vector<MeshVertices> vertices = motion.vertices(frame, workers);
        for (std::size_t i = 0; i < motion.meshes.size(); ++i) {
            Mesh& mesh = scene.meshes[motion.meshes[i]];
            mesh.vertices = std::move(vertices[i].vertices);
            mesh.details = std::move(vertices[i].details);
            mesh.boundingRadius = boundingRadiusOf(mesh.vertices);
            requireUsable(mesh.vertices, mesh.boundingRadius, mesh.name);
            requireUsable(mesh.details, mesh.vertices.size(), mesh.name);
        }
    }
    const std::vector<Transform> transforms =
        motion.instances.empty() ? std::vector<Transform>() : motion.transforms(frame);
    for (std::size_t i = 0; i < motion.instances.size(); ++i) {
        requireUsable(transforms[i], "instance " + std::to_string(motion.instances[i]));
        placeInstance(scene, motion.instances[i], transforms[i].position, transforms[i].basis);
    }
    const std::vector<PointLight> lights =
        motion.lights.empty() ? std::vector<PointLight>() : motion.lightsAt(frame);
    for (std::size_t i = 0; i < motion.lights.size(); ++i) {
        requireUsable(lights[i], "light " + std::to_string(motion.lights[i]));
        scene.lights[motion.lights[i]] = lights[i];
    }
}

void boundByPoses(Scene& scene, const SceneMotion& motion, std::uint32_t frame) {
    if (!motion.poses) {
        return;
    }
    const std::vector<MeshPose> poses = motion.poses(frame);
    for (std::size_t i = 0; i < poses.size(); ++i) {
        Mesh& mesh = scene.meshes[motion.meshes[i]];
        mesh.boundingRadius = boundingRadiusOf(poses[i]);
        requireUsable(mesh.vertices, mesh.boundingRadius, mesh.name);
    }
    for (const std::uint32_t i : motion.instances) {
        placeInstance(scene, i, scene.instances.position(i), scene.instances.basis[i]);
    }
}

} // namespace cdr::scene
