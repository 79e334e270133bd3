#include "views_scene.h"

#include <cdr/gpu/functions.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/views/views_renderer.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace cdr::render_test {

namespace {

using render::ViewsRenderer;

/// How the frames of several views reach the queue.
class ViewsOrderTest : public RenderTest {
  protected:
    gpu::BorrowedDevice borrowedWith(std::function<VkResult(const VkSubmitInfo2&, VkFence)> submit) {
        gpu::BorrowedDevice handles = lentDevice();
        handles.submit = std::move(submit);
        return handles;
    }

    static render::RenderOptions orderOptions(const char* technique) {
        return smallOptions(depth::parseTechnique(technique), kViewsWidth, kViewsHeight);
    }
};

/// The draws of both eyes, and then for each eye the rest, which its fence waits for. Where a submission fails, what was
/// submitted before has been waited for: the next frame is drawn as if nothing had happened.
TEST_F(ViewsOrderTest, TheDrawsOfAllViewsComeFirst) {
    std::string order;
    std::size_t failing = 0; // counted from 1; 0: none
    const VkQueue queue = device().queue();
    const gpu::Device borrowed(borrowedWith([&](const VkSubmitInfo2& submission, VkFence done) {
        order += done == VK_NULL_HANDLE ? "draws " : "rest ";
        return failing != 0 && --failing == 0 ? VK_ERROR_OUT_OF_HOST_MEMORY
                                              : gpu::functions().vkQueueSubmit2(queue, 1, &submission, done);
    }));
    const scene::Scene scene = floorAndBoxes();
    const render::GpuScene onDevice(borrowed, scene);
    ViewsRenderer renderer(borrowed, scene, onDevice, orderOptions("anchored"), 2);
    order.clear();
    const std::string wanted = hashOf(renderer.render(bothEyes())[1]);
    EXPECT_EQ(order, "draws draws rest rest ");
    for (const std::size_t submission : {1u, 2u, 3u, 4u}) {
        failing = submission;
        EXPECT_ANY_THROW(renderer.render(bothEyes())) << submission;
        EXPECT_EQ(hashOf(renderer.render(bothEyes())[1]), wanted) << submission;
    }
}

/// A host may still read the images of a frame whose lists had too little room, and only the next frame waits for that.
TEST_F(ViewsOrderTest, TheNextFrameDrawsNoneAgainThatLackedRoom) {
    if (!canDrawGpuDriven()) {
        GTEST_SKIP() << "the device cannot cull and bin";
    }
    std::size_t submissions = 0;
    const VkQueue queue = device().queue();
    gpu::BorrowedDevice handles = borrowedWith([&](const VkSubmitInfo2& submission, VkFence done) {
        ++submissions;
        return gpu::functions().vkQueueSubmit2(queue, 1, &submission, done);
    });
    handles.hasGpuDrivenFeatures = true;
    const gpu::Device borrowed(handles);
    scene::Scene scene = boxScene();
    addBox(scene, glm::dvec3(0.0, -501.0, 0.0),
           glm::mat3(1'000.0f)); // in all cascades, so that there are more draws than room
    const render::GpuScene onDevice(borrowed, scene);
    render::RenderOptions options = orderOptions("anchored/count:6");
    options.submission = render::Submission::gpuDriven;
    ViewsRenderer renderer(borrowed, scene, onDevice, options, 2);
    renderer.submit(bothEyes());
    submissions = 0;
    const std::vector<scene::Camera> next = bothEyes(scene::StereoMode::parallel, 0.7);
    renderer.submit(next);
    EXPECT_EQ(submissions, 4u); // the draws of both views, then the rest of both
    const std::vector<render::Frame> views = renderer.render(next);
    for (std::size_t view = 0; view < views.size(); ++view) {
        EXPECT_EQ(hashOf(views[view]), hashOf(draw(scene, next[view], options))) << view;
    }
}

} // namespace

} // namespace cdr::render_test
