#pragma once

#include <cdr/depth/cascade_constants.h>
#include <cdr/depth/make_cascades.h>

#include <vector>

/// An engine that adopts anchored depth, as src/cdr/README.md tells it to.
namespace adoption {

/// What an engine has anyway: objects in float64, and a view.
struct Vec3 {
    double x, y, z;
};
struct Object {
    Vec3 centre; ///< view space: the eye is subtracted and axes are turned in float64
    double radius;
};
struct Engine {
    double nearView = 0.0;
    double farView = 0.0;
    double footprintSlope = 0.0;
    std::vector<Object> visible{};
    cdr::depth::Projection projection{};

    Engine() = default;
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;
    virtual ~Engine() = default;
    virtual void clearDepth(float value) = 0;
    virtual void setCascade(const cdr::depth::CascadeConstants& constants) = 0;
    virtual void draw(const Object& object, float x, float y, float ahead) = 0;
};

/// The recipe itself.
void drawAnchored(Engine& engine, cdr::depth::Cascades& cascades);

} // namespace adoption
