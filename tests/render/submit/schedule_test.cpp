#include "../fixture.h"

#include <cdr/platform/schedule.h>
#include <scenes/cubes.h>

#include <random>

namespace cdr::render_test {

namespace {

class ScheduleTest : public RenderTest {
  protected:
    render::RenderOptions options(const char* technique, render::TargetsKind targets,
                                  render::Submission submission) {
        render::RenderOptions options = smallOptions(depth::parseTechnique(technique), 48, 27);
        options.targets = targets;
        options.submission = submission;
        options.batching = render::Batching::perObject;
        return options;
    }
};

/// Three cascades are three jobs of recording, in each order, on each of two workers: 48 ways.
TEST_F(ScheduleTest, NoOrderOfFewJobsChangesTheFrame) {
    scene::Scene scene = boxScene();
    for (const double distance : {3.0, 60.0, 900.0}) {
        addBox(scene, glm::dvec3(0.3 * distance, 0.0, -distance),
               glm::mat3(static_cast<float>(distance) / 4.0f));
        addBox(scene, glm::dvec3(0.0, 0.0, -distance), glm::mat3(static_cast<float>(distance) / 4.0f));
    }
    const scene::Camera camera{.fovY = 0.9, .nearView = 1.0, .farView = 1000.0};
    const render::GpuScene gpuScene(device(), scene);
    for (const render::TargetsKind targets : render::kTargetsKinds) {
        for (const render::Submission submission :
             {render::Submission::primaries, render::Submission::secondaries}) {
            render::RenderOptions alone = options("anchored/count:3", targets, submission);
            const std::string expected = hashOf(draw(scene, camera, alone));
            render::RenderOptions scheduled = alone;
            scheduled.threads = 2;
            for (std::uint64_t number = 0; number < platform::scheduleCount(3, 2); ++number) {
                scheduled.schedule = number;
                const render::Frame frame = draw(scene, gpuScene, camera, scheduled);
                ASSERT_EQ(hashOf(frame), expected) << nameOf(targets) << ", schedule " << number;
                ASSERT_EQ(frame.stats.draws, 6u);
            }
        }
    }
}

/// Random orders of many jobs, including those that cull and bin.
TEST_F(ScheduleTest, NoOrderOfManyJobsChangesTheFrame) {
    const scene::SceneSetup setup = scenes::makeRotation(1, 64'000);
    const scene::Camera camera = setup.path.at(0);
    const render::GpuScene gpuScene(device(), setup.scene);
    for (const render::Submission submission :
         {render::Submission::primaries, render::Submission::secondaries}) {
        const render::RenderOptions alone =
            options("standard/count:5", render::TargetsKind::single, submission);
        const std::string expected = hashOf(draw(setup.scene, camera, alone));
        std::mt19937_64 random(2013);
        for (int round = 0; round < 12; ++round) {
            render::RenderOptions scheduled = alone;
            scheduled.threads = 3;
            scheduled.schedule = random();
            ASSERT_EQ(hashOf(draw(setup.scene, gpuScene, camera, scheduled)), expected)
                << "schedule " << *scheduled.schedule;
        }
    }
}

} // namespace

} // namespace cdr::render_test
