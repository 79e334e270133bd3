#include "../host/host_side.h"
#include "views_scene.h"

#include <cdr/base/error.h>
#include <cdr/render/views/views_renderer.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace cdr::render_test {

namespace {

using render::HostFrame;
using render::ViewsRenderer;

constexpr double kEyesNearView = 0.25; ///< of the host's own projection

/// Whether the host has one command buffer for both eyes, or one for each.
enum class EyeCommands : std::uint8_t { shared, separate };

/// A host with images for two eyes.
class TwoEyes {
  public:
    explicit TwoEyes(const gpu::Device& device)
        : m_eyes{HostSide(device, {kViewsWidth, kViewsHeight}),
                 HostSide(device, {kViewsWidth, kViewsHeight})} {}

    std::vector<HostFrame> begin(EyeCommands commands) {
        std::vector<HostFrame> frames;
        for (HostSide& eye : m_eyes) {
            frames.push_back(eye.begin());
            frames.back().depth = eye.depth(kEyesNearView);
        }
        if (commands == EyeCommands::shared) {
            frames[1].commands = frames[0].commands;
            frames[1].done = frames[0].done;
            frames[1].doneValue = frames[0].doneValue;
        }
        return frames;
    }
    void submit() {
        for (HostSide& eye : m_eyes) {
            eye.submit();
        }
    }
    const HostSide& at(std::size_t view) const { return m_eyes.at(view); }

  private:
    std::array<HostSide, 2> m_eyes;
};

class RecordViewsTest : public RenderTest {
  protected:
    void SetUp() override {
        RenderTest::SetUp();
        m_onDevice.emplace(device(), m_scene);
    }

    static render::RenderOptions eyeOptions(const depth::Technique& technique) {
        return smallOptions(technique, kViewsWidth, kViewsHeight);
    }

    static void expectDepths(const image::Raster<float>& depths, const render::Frame& frame) {
        std::size_t surfaces = 0;
        for (std::uint32_t y = 0; y < frame.height(); ++y) {
            for (std::uint32_t x = 0; x < frame.width(); ++x) {
                const double wanted = std::min(kEyesNearView / frame.distanceView(x, y), 1.0);
                ASSERT_NEAR(depths.at(x, y), wanted, 2e-7 * wanted) << x << " " << y;
                surfaces += wanted > 0.0 ? 1 : 0;
            }
        }
        EXPECT_GT(surfaces, 1000u);
    }

    /// Frame by frame the same as a renderer that submits for itself. Frames in flight share the host's images.
    void expectRendered(scene::StereoMode mode, const render::RenderOptions& options, EyeCommands commands) {
        TwoEyes host(device());
        ViewsRenderer recorded(device(), m_scene, *m_onDevice, options, 2);
        ViewsRenderer rendered(device(), m_scene, *m_onDevice, options, 2);
        for (const double ahead : {0.0, 0.7, 1.5}) {
            const std::vector<scene::Camera> cameras = bothEyes(mode, ahead);
            const std::vector<HostFrame> frames = host.begin(commands);
            recorded.record(cameras, frames);
            host.submit();
            const std::vector<render::Frame> wanted = rendered.render(cameras);
            EXPECT_NE(wanted[0].color.pixels, wanted[1].color.pixels);
            for (std::size_t view = 0; view < 2; ++view) {
                EXPECT_EQ(host.at(view).color<image::Rgba8>().pixels, wanted[view].color.pixels)
                    << nameOf(options.submission) << ", view " << view << " at " << ahead;
                expectDepths(host.at(view).depthValues(), wanted[view]);
            }
        }
    }

    scene::Scene m_scene = floorAndBoxes();
    std::optional<render::GpuScene> m_onDevice;
};

TEST_F(RecordViewsTest, RecordedPicturesAreTheRenderedOnes) {
    for (const scene::StereoMode mode : scene::kStereoModes) {
        for (const render::Submission submission : submissions()) {
            for (const std::size_t threads : {1u, 2u}) {
                for (const EyeCommands commands : {EyeCommands::shared, EyeCommands::separate}) {
                    if (submission == render::Submission::primaries) {
                        continue; // needs command buffers of its own
                    }
                    render::RenderOptions options = eyeOptions(depth::parseTechnique("anchored"));
                    options.submission = submission;
                    options.threads = threads;
                    options.framesInFlight = 2;
                    expectRendered(mode, options, commands);
                }
            }
        }
    }
}

TEST_F(RecordViewsTest, RecordedPicturesAreTheRenderedOnesWithWhateverElseIsDrawn) {
    std::vector<render::RenderOptions> all(4, eyeOptions(depth::parseTechnique("anchored")));
    all[0].shadows.method = render::ShadowMethod::anchored;
    all[1].surface = render::SurfacePath::visibility;
    all[2].targets = render::parseTargets("pool:2");
    all[3].effects.antialias = render::Antialias::edges;
    for (const render::RenderOptions& options : all) {
        expectRendered(scene::StereoMode::toedIn, options, EyeCommands::shared);
    }
}

/// Cascades cover what the host draws in either eye, though the scene ends long before it.
TEST_F(RecordViewsTest, AHostsObjectsAreDrawnInTheirViews) {
    constexpr double kSquareView = 300.0;
    constexpr std::uint32_t kSquareObject = 4000;
    scene::Scene scene = boxScene();
    addBox(scene, {0.0, 0.0, -5.0});
    const render::GpuScene onDevice(device(), scene);
    const render::RenderOptions options = eyeOptions(depth::parseTechnique("anchored"));
    const HostRectangles squares(device(), vk::Format(device().depthFormat(depth::DepthFormat::d32f)));
    TwoEyes host(device());
    ViewsRenderer renderer(device(), scene, onDevice, options, 2);
    for (std::size_t withSquare = 0; withSquare < 2; ++withSquare) {
        std::vector<HostFrame> frames = host.begin(EyeCommands::shared);
        HostFrame& frame = frames[withSquare];
        frame.occupied = {{kSquareView, kSquareView}};
        frame.draw = [&](const render::HostCascade& cascade) {
            squares.draw(cascade, HostRectangles::Square{40.0, kSquareView, 20.0, kSquareObject});
        };
        renderer.forgetFrames();
        renderer.record(bothEyes(scene::StereoMode::parallel), frames);
        host.submit();
        for (std::size_t view = 0; view < 2; ++view) {
            const auto pixels = readGBuffer(device(), renderer.surfaces(view).gbuffer);
            const auto found = std::count_if(
                pixels.pixels.begin(), pixels.pixels.end(),
                [](const render::GBufferPixel& pixel) { return pixel.id() == kSquareObject + 1; });
            EXPECT_EQ(found > 20, view == withSquare) << found << " in view " << view;
        }
    }
}

/// With one line that says why, before anything is recorded: what was refused can be recorded again, corrected.
TEST_F(RecordViewsTest, RefuseWhatCannotBeRecorded) {
    const render::RenderOptions options = eyeOptions(depth::parseTechnique("anchored"));
    const std::vector<scene::Camera> cameras = bothEyes(scene::StereoMode::parallel);
    TwoEyes host(device());
    ViewsRenderer renderer(device(), m_scene, *m_onDevice, options, 2);
    const std::vector<HostFrame> good = host.begin(EyeCommands::shared);
    const auto refusal = [&](const std::vector<HostFrame>& frames, const std::vector<scene::Camera>& from) {
        try {
            renderer.record(from, frames);
        } catch (const base::InputError& error) {
            return std::string(error.what());
        }
        host.submit(); // else the renderer would wait for it forever
        return std::string();
    };
    std::vector<HostFrame> bad = good;
    ASSERT_NE(refusal({good[0]}, cameras).find("1 frames were given for 2 views"), std::string::npos);
    ASSERT_NE(refusal(good, {cameras[0]}).find("1 cameras were given for 2 views"), std::string::npos);
    bad[1].color = good[0].color;
    ASSERT_NE(refusal(bad, cameras).find("one image"), std::string::npos);
    bad = good;
    bad[1].depth->image = good[0].depth->image;
    ASSERT_NE(refusal(bad, cameras).find("one image"), std::string::npos);
    bad = good;
    bad[1].color.layout = VK_IMAGE_LAYOUT_UNDEFINED;
    ASSERT_NE(refusal(bad, cameras).find("no layout is named"), std::string::npos);
    renderer.record(cameras, good);
    host.submit();
    const std::vector<render::Frame> wanted =
        ViewsRenderer(device(), m_scene, *m_onDevice, options, 2).render(cameras);
    EXPECT_EQ(host.at(1).color<image::Rgba8>().pixels, wanted[1].color.pixels);
}

/// A view that was recorded before an error, and frames that the host drops, are waited for by nobody.
TEST_F(RecordViewsTest, NothingWaitsForFramesThatAreNotSubmitted) {
    const render::RenderOptions options = eyeOptions(depth::parseTechnique("anchored"));
    const std::vector<scene::Camera> cameras = bothEyes(scene::StereoMode::parallel);
    for (const EyeCommands commands : {EyeCommands::shared, EyeCommands::separate}) {
        TwoEyes host(device());
        ViewsRenderer renderer(device(), m_scene, *m_onDevice, options, 2);
        std::vector<HostFrame> frames = host.begin(commands);
        frames[1].draw = [](const render::HostCascade&) { throw base::RunError("the host's"); };
        EXPECT_THROW(renderer.record(cameras, frames), base::RunError);
        renderer.finish();
        renderer.record(cameras, host.begin(commands));
        renderer.dropRecorded();
        renderer.finish();
        renderer.record(cameras, host.begin(commands));
        renderer.dropRecorded();
    } // nor does the destructor wait
}

/// A view that was recorded before an error goes on from no frame that the other one lacks.
TEST_F(RecordViewsTest, NoViewMovesFromAFrameThatIsNotSubmitted) {
    render::RenderOptions options = eyeOptions(depth::parseTechnique("anchored"));
    options.motion = true;
    const auto camerasAt = [](double ahead) {
        return std::vector<scene::Camera>(2, bothEyes(scene::StereoMode::parallel, ahead).front());
    };
    for (const EyeCommands commands : {EyeCommands::shared, EyeCommands::separate}) {
        TwoEyes host(device());
        ViewsRenderer renderer(device(), m_scene, *m_onDevice, options, 2);
        renderer.draw(camerasAt(0.0));
        std::vector<HostFrame> frames = host.begin(commands);
        frames[1].draw = [](const render::HostCascade&) { throw base::RunError("the host's"); };
        EXPECT_THROW(renderer.record(camerasAt(0.7), frames), base::RunError);
        const std::vector<render::Frame> next = renderer.render(camerasAt(1.5));
        EXPECT_EQ(next[0].motion, next[1].motion);
        EXPECT_EQ(next[0].motion, draw(m_scene, camerasAt(1.5)[0], options).motion);
    }
}

/// A refused frame leaves the one before to the device: dropRecorded() gives nothing back that the host submitted.
TEST_F(RecordViewsTest, ARefusedFrameLeavesTheOneBefore) {
    const render::RenderOptions options = eyeOptions(depth::parseTechnique("anchored"));
    const std::vector<scene::Camera> cameras = bothEyes(scene::StereoMode::parallel);
    const std::span<const scene::Camera> tooFew = std::span(cameras).first(1);
    const std::vector<std::function<void(ViewsRenderer&, std::vector<HostFrame>)>> refusals{
        [&](ViewsRenderer& renderer, std::vector<HostFrame> frames) {
            frames[1].color.format = VK_FORMAT_R32G32B32A32_UINT;
            renderer.record(cameras, frames);
        },
        [&](ViewsRenderer& renderer, const auto&) { renderer.skip(tooFew); },
        [&](ViewsRenderer& renderer, const auto&) { renderer.submit(tooFew); }};
    for (const auto& refused : refusals) {
        TwoEyes host(device());
        ViewsRenderer renderer(device(), m_scene, *m_onDevice, options, 2);
        const std::vector<HostFrame> frames = host.begin(EyeCommands::shared);
        renderer.record(cameras, frames);
        EXPECT_THROW(refused(renderer, frames), base::InputError);
        renderer.dropRecorded();
        std::thread submitting([&] { host.submit(); });
        renderer.finish(); // waits for what is being submitted
        EXPECT_GE(vk::Device(device().handle()).getSemaphoreCounterValue(frames[0].done),
                  frames[0].doneValue);
        submitting.join();
        vk::Device(device().handle()).waitIdle(); // for the host's other submission
    }
}

} // namespace

} // namespace cdr::render_test
