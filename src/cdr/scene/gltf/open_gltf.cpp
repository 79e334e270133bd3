#include "nodes/lights.h"
#include "nodes/moving_lights.h"

#include <cdr/base/enum_names.h>
#include <cdr/base/format_error.h>
#include <cdr/platform/file.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/scene/animation/node_camera.h>
#include <cdr/scene/animation/scene_animation.h>
#include <cdr/scene/box_tree.h>
#include <cdr/scene/gltf/gltf.h>
#include <cdr/scene/gltf/import_progress.h>
#include <cdr/scene/gltf/open_gltf.h>
#include <cdr/scene/sphere_around.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cdr::scene {

namespace {

/// So many that a step is far shorter than any frame.
constexpr double kMaxFramesPerSecond = 1e6;

/// Bright enough that rough metals, which mirror little of it, are not dark.
constexpr Sky kModelSky{
    .zenith = {0.42f, 0.6f, 0.95f}, .horizon = {1.05f, 1.08f, 1.1f}, .ground = {0.32f, 0.29f, 0.26f}};

constexpr glm::vec3 kModelBackground{0.03f, 0.035f, 0.045f};
constexpr float kAmbientBesideOwn = 0.03f;

/// Around every instance; without any, of radius one at the origin.
Sphere boundingSphere(const Instances& instances) {
    return instances.size() == 0 ? Sphere{.radius = 1.0} : sphereAround(instances);
}

bool isSolid(const Sphere& sphere) {
    return sphere.radius > 0.0 && std::isfinite(sphere.radius);
}

/// How a model is lit.
struct Lighting {
    ModelLight by = ModelLight::lamps;
    std::span<const GltfLight> own; ///< the file's
    /// Around the scene at rest. So lights do not depend on the moment at which a file is opened.
    Sphere bounds;
};

/// Lights a model from the front left above, and from behind, or as its file says.
void addLights(Scene& scene, const Lighting& lighting) {
    const Sphere& bounds = lighting.bounds;
    if (lighting.by == ModelLight::file) {
        for (const GltfLight& each : lighting.own) {
            scene.lights.push_back(gltf::pointLightOf(each, bounds.centre, bounds.radius));
        }
        scene.ambient = glm::vec3(kAmbientBesideOwn);
        scene.background = kModelBackground;
        return;
    }
    const auto at = [&](double x, double y, double z) {
        return bounds.centre + bounds.radius * glm::dvec3(x, y, z);
    };
    const double reach = 6.0 * bounds.radius;
    scene.lights.push_back({.position = at(-2.0, 2.5, 3.0), .color = glm::vec3(1.3f), .halfDistance = reach});
    scene.background = kModelBackground;
    if (lighting.by == ModelLight::sky) {
        scene.sky = kModelSky;
        scene.background = glm::vec3(0.07f, 0.075f, 0.085f); // tone mapping darkens it to the other one
    } else {
        scene.lights.push_back(
            {.position = at(2.5, 1.0, -2.0), .color = {0.5f, 0.55f, 0.7f}, .halfDistance = reach});
    }
}

/// Lights a model, and looks at it from the front, a little from above, or through a camera of its own.
/// @param bounds around the scene as it is now
SceneSetup setUpModel(Scene scene, const Sphere& bounds, const std::optional<Camera>& own,
                      const Lighting& lighting) {
    addLights(scene, lighting);
    if (own) {
        return {.scene = std::move(scene), .path = stillPath(*own)};
    }
    const double fovY = 40.0 * std::numbers::pi / 180.0;
    const double distance = 1.02 * bounds.radius / std::sin(0.5 * fovY);
    const Camera lens{.fovY = fovY, .nearView = 0.01 * bounds.radius, .farView = 1000.0 * bounds.radius};
    const double elevation = 0.2;
    const glm::dvec3 offset(0.35 * distance, elevation * distance, 0.0);
    const double forward = std::sqrt(distance * distance - glm::dot(offset, offset));
    const Camera first = lookAt(lens, bounds.centre + offset + glm::dvec3(0.0, 0.0, forward), bounds.centre);
    return {.scene = std::move(scene), .path = stillPath(first)};
}

std::optional<GltfCamera> chosenCamera(const GltfImport& import, const std::optional<std::uint32_t>& choice) {
    if (!choice) {
        return std::nullopt;
    }
    if (*choice < import.cameras.size()) {
        return import.cameras[*choice];
    }
    std::string names;
    for (std::size_t i = 0; i < std::min<std::size_t>(import.cameras.size(), 10); ++i) {
        names += fmt::format("{} {} '{}'", i == 0 ? ":" : ",", i, import.cameras[i].name);
    }
    throw base::inputError("camera {} does not exist, the scene has {}{}", *choice, import.cameras.size(),
                           names);
}

constexpr base::EnumNames<ModelLight, kModelLights.size()> kLightNames{"light", {"lamps", "sky", "file"}};

bool isPlayed(const GltfChoice& choice) {
    return choice.animation || choice.seconds || choice.framesPerSecond;
}

FrameClock clockOf(const GltfChoice& choice) {
    return {.start = choice.seconds.value_or(0.0), .framesPerSecond = choice.framesPerSecond.value_or(0.0)};
}

std::optional<std::size_t> chosenAnimation(const std::vector<PlayableAnimation>& animations,
                                           const GltfChoice& choice) {
    if (!isPlayed(choice)) {
        return std::nullopt;
    }
    if (animations.empty()) {
        throw base::InputError("it has no animations, which --animation, --time and --fps play");
    }
    if (!choice.animation) {
        return 0;
    }
    if (const auto number = animationOf(animations, *choice.animation)) {
        return number;
    }
    std::string names;
    for (std::size_t i = 0; i < std::min<std::size_t>(animations.size(), 10); ++i) {
        names += fmt::format("{} {} '{}'", i == 0 ? ":" : ",", i, animations[i].name);
    }
    throw base::inputError("animation '{}' does not exist, the file has {}{}",
                           choice.animation->substr(0, 60), animations.size(), names);
}

std::string animationsNote(const std::vector<Animation>& animations) {
    const bool areAllSound = std::ranges::all_of(animations, &std::string::empty, &Animation::fault);
    return animations.size() == 1 ? fmt::format("its animation of {:.4g} s, which render --time shows",
                                                animations.front().seconds)
                                  : fmt::format("its {} animations, which render --animation 0 to {} plays{}",
                                                animations.size(), animations.size() - 1,
                                                areAllSound ? "" : ", but for those that cannot be played");
}

/// Says what of a file's lights is not shown. Without any, ModelLight::file would show next to nothing.
void noteLights(GltfImport& import, std::optional<ModelLight> light) {
    if (light == ModelLight::file && import.lights.empty()) {
        throw base::InputError("it has no lights of its own, which --light file shows");
    }
    if (light != ModelLight::file && !import.lights.empty()) {
        import.ignored.push_back(
            import.lights.size() == 1
                ? "its light, which render --light file shows"
                : fmt::format("its {} lights, which render --light file shows", import.lights.size()));
    }
}

std::vector<ListedLight> listed(std::span<const GltfLight> lights) {
    std::vector<ListedLight> list;
    for (const GltfLight& light : lights) {
        list.push_back({.name = light.name, .type = gltf::typeOf(light)});
    }
    return list;
}

/// A file's camera at a place, as it is drawn.
Camera drawnAs(const GltfCamera& camera, const Camera& place, const Sphere& atRest) {
    return camera.orthographic ? fromAfar(place, *camera.orthographic, atRest.centre, atRest.radius) : place;
}

/// A camera where its node is at each frame. Where a frame flattens it, it stays as it is at rest.
CameraPath carriedPath(const GltfImport& import, const GltfCamera& camera, std::size_t chosen,
                       const GltfChoice& choice, const Sphere& atRest) {
    const FrameClock clock = clockOf(choice);
    const double seconds = import.animation->animations[chosen].seconds;
    const double frames = std::clamp(1.0 + std::floor(seconds * clock.framesPerSecond), 1.0, 1e6);
    const std::size_t node = *import.rigNodeOf[static_cast<std::size_t>(camera.node)];
    return {.frames = static_cast<std::uint32_t>(frames),
            .at = [animation = import.animation, camera, chosen, node, clock, atRest](std::uint32_t frame) {
                const Pose pose =
                    poseAt(animation->rig, &animation->animations[chosen], clock.secondsAt(frame));
                const Camera place = carriedBy(pose.toWorld[node], camera.camera).value_or(camera.camera);
                return drawnAs(camera, place, atRest);
            }};
}

/// Says which cameras of a file are not looked through, or not as they are.
void noteCameras(GltfImport& import, const std::optional<GltfCamera>& chosen) {
    if (!chosen && !import.cameras.empty()) {
        import.ignored.push_back(import.cameras.size() == 1
                                     ? "its camera, which --camera 0 looks through"
                                     : fmt::format("its {} cameras, which --camera 0 to {} looks through",
                                                   import.cameras.size(), import.cameras.size() - 1));
    }
    if (chosen && chosen->orthographic) {
        import.ignored.push_back(
            fmt::format("the xmag of the orthographic camera '{}', which is drawn in perspective from {} "
                        "diameters of the scene away",
                        chosen->name, kAfar));
    }
}

/// What an animation moves.
struct Played {
    SceneMotion motion;
    std::optional<gltf::MovingLights> lights;
    std::optional<std::size_t> animationsNote{}; ///< OpenedScene's
};

/// Shows the first moment of the chosen animation, if any.
Played playedFrom(GltfImport& import, const std::optional<std::size_t>& chosen, const GltfChoice& choice,
                  std::vector<ListedLight>& lights) {
    Played played;
    const auto isPlayable = [](const Animation& animation) { return animation.fault.empty(); };
    if (chosen) {
        if (const Animation& animation = import.animation->animations[*chosen]; !isPlayable(animation)) {
            throw base::InputError(animation.fault);
        }
        played.motion = motionOf(import.animation, chosen, clockOf(choice));
        platform::WorkerPool workers(1);
        show(import.scene, played.motion, 0, workers);
        played.lights.emplace(import, *chosen, clockOf(choice));
        played.lights->place(import.lights, 0);
        for (const std::uint32_t light : played.lights->moving()) {
            lights[light].moves = true;
        }
    } else if (import.animation != nullptr && std::ranges::any_of(import.animation->animations, isPlayable)) {
        played.animationsNote = import.ignored.size();
        import.ignored.push_back(animationsNote(import.animation->animations));
    }
    return played;
}

/// A sphere around what an animation shows at some of its moments. Leaves the scene at another moment.
Sphere boundsOverMoments(GltfImport& import, std::size_t chosen) {
    constexpr std::uint32_t kSteps = 16;
    const double seconds = import.animation->animations[chosen].seconds;
    const SceneMotion motion =
        motionOf(import.animation, chosen, {.framesPerSecond = seconds > 0.0 ? kSteps / seconds : 0.0});
    platform::WorkerPool workers(1);
    std::vector<Sphere> spheres;
    Box box;
    for (std::uint32_t moment = 0; moment <= kSteps + 1; ++moment) { // also after its end
        show(import.scene, motion, moment, workers);
        const Sphere sphere = boundingSphere(import.scene.instances);
        if (isSolid(sphere)) {
            spheres.push_back(sphere);
            box.add(sphere.centre, sphere.radius);
        }
    }
    Sphere all{.centre = spheres.empty() ? glm::dvec3(0.0) : box.centre(), .radius = 0.0};
    for (const Sphere& sphere : spheres) {
        all.radius = std::max(all.radius, glm::distance(all.centre, sphere.centre) + sphere.radius);
    }
    return all;
}

/// A sphere around what there is to look at: at the first moment, or where that shows nothing, at later ones.
Sphere requiredBounds(GltfImport& import, const Played& played, const std::optional<std::size_t>& chosen,
                      const GltfChoice& choice) {
    Sphere bounds = boundingSphere(import.scene.instances);
    if (!isSolid(bounds) && chosen && choice.framesPerSecond) {
        bounds = boundsOverMoments(import, *chosen);
        platform::WorkerPool workers(1);
        show(import.scene, played.motion, 0, workers);
    }
    if (!isSolid(bounds)) {
        throw base::InputError("the scene has no extent to look at");
    }
    return bounds;
}

/// An import lit and framed.
OpenedScene staged(GltfImport import, const GltfChoice& choice) {
    const std::optional<GltfCamera> camera = chosenCamera(import, choice.camera);
    noteCameras(import, camera);
    noteLights(import, choice.light);
    OpenedScene result;
    result.lights = listed(import.lights);
    if (import.animation != nullptr) {
        for (const Animation& animation : import.animation->animations) {
            result.animations.push_back({animation.name, animation.seconds});
        }
    }
    const auto chosen = chosenAnimation(result.animations, choice);
    const Sphere atRest = boundingSphere(import.scene.instances);
    Played played = playedFrom(import, chosen, choice, result.lights);
    const Sphere bounds = requiredBounds(import, played, chosen, choice);
    boundByPoses(import.scene, played.motion, 0);
    const Sphere lightBounds = isSolid(atRest) ? atRest : bounds;
    const auto own = camera ? std::optional(drawnAs(*camera, camera->camera, lightBounds)) : std::nullopt;
    if (own) {
        requireUsable(*own); // that of an orthographic camera depends on the scene
    }
    result.setup = setUpModel(std::move(import.scene), bounds, own,
                              {choice.light.value_or(ModelLight::lamps), import.lights, lightBounds});
    if (chosen && camera && import.rigNodeOf[static_cast<std::size_t>(camera->node)]) {
        result.setup.path = carriedPath(import, *camera, *chosen, choice, lightBounds);
    }
    if (choice.framesPerSecond) {
        if (played.lights && choice.light == ModelLight::file) {
            played.lights->addTo(played.motion, lightBounds.centre, lightBounds.radius);
        }
        result.setup.motion = std::move(played.motion);
    }
    result.notes = std::move(import.ignored);
    result.animationsNote = played.animationsNote;
    return result;
}

/// The same. @param path in messages
OpenedScene opened(const std::filesystem::path& path, GltfImport import, const GltfChoice& choice) {
    try {
        return staged(std::move(import), choice);
    } catch (const base::InputError& error) {
        throw base::inputError("{}: {}", platform::oneLine(path), error.what());
    }
}

} // namespace

std::string_view nameOf(ModelLight light) {
    return kLightNames.nameOf(light);
}

ModelLight parseModelLight(std::string_view name) {
    return kLightNames.parse(name);
}

bool isGltfPath(const std::filesystem::path& path) {
    const std::string extension = platform::lowerExtension(path);
    return extension == ".gltf" || extension == ".glb";
}

void requireUsable(const GltfChoice& choice) {
    if (choice.seconds && !(*choice.seconds >= 0.0 && std::isfinite(*choice.seconds))) {
        throw base::inputError("--time must be finite and at least 0, in seconds, not {}", *choice.seconds);
    }
    if (choice.framesPerSecond &&
        !(*choice.framesPerSecond > 0.0 && *choice.framesPerSecond <= kMaxFramesPerSecond)) {
        throw base::inputError("--fps must be above 0 and at most {}, not {}", kMaxFramesPerSecond,
                               *choice.framesPerSecond);
    }
    if (choice.textureMiB && (*choice.textureMiB < 1 || *choice.textureMiB > kMaxTextureMiB)) {
        throw base::inputError("--texture-memory must be from 1 to {}, in MiB, not {}", kMaxTextureMiB,
                               *choice.textureMiB);
    }
    if (choice.pointRadius &&
        !(*choice.pointRadius >= kMinPointRadius && *choice.pointRadius <= kMaxPointRadius)) {
        throw base::inputError("--points must be from {} to {}, in scene units, not {}", kMinPointRadius,
                               kMaxPointRadius, *choice.pointRadius);
    }
}

std::optional<std::size_t> animationOf(std::span<const PlayableAnimation> animations, std::string_view text) {
    const auto first = [&](const auto& isMeant) -> std::optional<std::size_t> {
        for (std::size_t i = 0; i < animations.size(); ++i) {
            if (isMeant(i)) {
                return i;
            }
        }
        return std::nullopt;
    };
    const auto named = first([&](std::size_t i) { return animations[i].name == text; });
    const std::string_view digits = text.starts_with('#') ? text.substr(1) : text;
    return named ? named : first([&](std::size_t i) { return std::to_string(i) == digits; });
}

GltfLimits limitsOf(const GltfChoice& choice) {
    requireUsable(choice);
    GltfLimits limits;
    if (choice.textureMiB) {
        limits.textureMemory = *choice.textureMiB << 20u;
    }
    limits.pointRadius = choice.pointRadius;
    return limits;
}

std::optional<double> secondsAt(const GltfChoice& choice, std::uint32_t frame) {
    return isPlayed(choice) ? std::optional(clockOf(choice).secondsAt(frame)) : std::nullopt;
}

OpenedScene openGltf(const std::filesystem::path& path, const GltfChoice& choice) {
    return openGltf(path, choice, ImportProgress());
}

OpenedScene openGltf(const std::filesystem::path& path, const GltfChoice& choice,
                     const ImportProgress& progress) {
    GltfLimits limits = limitsOf(choice);
    limits.progress = progress;
    return opened(path, loadGltf(path, limits, choice.scene), choice);
}

OpenedScene openGltf(std::span<const std::byte> file, const std::string& name, const GltfChoice& choice) {
    return opened(name, loadGltf(file, name, limitsOf(choice), choice.scene), choice);
}

} // namespace cdr::scene
