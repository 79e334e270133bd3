#pragma once

#include <cdr/base/sha256.h>
#include <cdr/measure/compare/wrong_pixels.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/render/renderer.h>

#include <gtest/gtest.h>

#include <string>

namespace cdr::render_test {

/// A validated device for one test; any validation message fails the test at its end.
class RenderTest : public testing::Test {
  protected:
    void TearDown() override {
        for (const std::string& message : m_instance.validation().messages()) {
            ADD_FAILURE() << message;
        }
    }

    const gpu::Device& device() const { return m_device; }
    const gpu::Instance& instance() const { return m_instance; }

    render::Frame draw(const scene::Scene& scene, const scene::Camera& camera,
                       const render::RenderOptions& options) {
        const render::GpuScene gpuScene(m_device, scene);
        render::Renderer renderer(m_device, scene, gpuScene, options);
        return renderer.render(camera);
    }

    measure::WrongPixels wrongIn(const render::Frame& frame, const scene::Scene& scene,
                                 const scene::Camera& camera) {
        base::WorkerPool workers(2);
        return measure::countWrong(frame.ids(),
                                   measure::castTruth(scene, camera, frame.width(), frame.height(), workers));
    }

  private:
    gpu::Instance m_instance{{.validate = true, .extensions = {}}};
    gpu::Device m_device{m_instance, ""};
};

inline render::RenderOptions smallOptions(const depth::Technique& technique) {
    return {.width = 480,
            .height = 270,
            .technique = technique,
            .targets = render::TargetsKind::single,
            .threads = 1};
}

/// One hash over everything a frame holds, pixel by pixel.
inline std::string hashOf(const render::Frame& frame) {
    return base::sha256Of(frame.color.pixels) + base::sha256Of(frame.gbuffer.pixels);
}

/// A scene of boxes with one white material, ambient light and the unit box as mesh 0.
inline scene::Scene boxScene() {
    scene::Scene scene;
    scene.name = "boxes";
    scene.meshes.push_back(scene::makeBox(glm::vec3(0.5f)));
    scene.materials.push_back({.name = "white"});
    scene.lights.push_back(
        {.position = glm::dvec3(5.0, 9.0, 7.0), .color = glm::vec3(1.0f), .halfDistance = 20.0});
    return scene;
}

inline void addBox(scene::Scene& scene, const glm::dvec3& position,
                   const glm::mat3& basis = glm::mat3(1.0f)) {
    scene::addInstance(scene, 0, 0, static_cast<std::uint32_t>(scene.instances.size()), position, basis);
}

} // namespace cdr::render_test
