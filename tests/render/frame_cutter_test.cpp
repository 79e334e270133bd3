#include <cdr/render/frame_cutter.h>

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace cdr::render_test {

namespace {

using render::CascadeView;
using render::FrameCutter;
using render::FrameView;
using render::RenderOptions;

/// Targets that draw nothing and give each cascade a slice that names it.
class NoTargets final : public render::Targets {
  public:
    render::DepthSlice depthSlice(std::size_t cascade, std::size_t cascades) const override {
        return {.min = static_cast<float>(cascade), .max = static_cast<float>(cascades)};
    }
    void record(render::CascadeCommands&, const FrameView&) override {}
    const gpu::Image& gbuffer() const override { return m_image; }

  private:
    gpu::Image m_image;
};

RenderOptions cutOptions(const char* technique) {
    return {.width = 640, .height = 360, .technique = depth::parseTechnique(technique)};
}

const scene::Camera kCutCamera{.fovY = 0.8, .nearView = 0.1, .farView = 1e5};

FrameView cutView(const RenderOptions& options) {
    const NoTargets targets;
    FrameCutter cutter(options, targets);
    FrameView view = cutter.look(kCutCamera);
    cutter.cut(view, {});
    return view;
}

TEST(FrameCutter, LooksThroughThePictureOfTheOptions) {
    const NoTargets targets;
    RenderOptions options = cutOptions("cdr");
    options.detail = {.mode = visibility::DetailMode::perObject, .pixels = 2.0};
    const FrameView view = FrameCutter(options, targets).look(kCutCamera);
    EXPECT_EQ(view.camera, kCutCamera);
    EXPECT_EQ(view.frustum.aspect, 640.0 / 360.0);
    EXPECT_EQ(view.levels.mode, visibility::DetailMode::perObject);
    EXPECT_DOUBLE_EQ(view.levels.slope, 2.0 * view.frustum.footprintSlope);
    EXPECT_TRUE(view.cascades.empty());
}

TEST(FrameCutter, ClipRangesReachIntoTheNextCascade) {
    for (const char* technique : {"standard/count:3", "log/count:3", "anchored/count:3"}) {
        const FrameView view = cutView(cutOptions(technique));
        ASSERT_EQ(view.cascades.size(), 3u) << technique;
        for (std::size_t i = 0; i < 3; ++i) {
            const CascadeView& cascade = view.cascades[i];
            const depth::Cascade& clip = cascade.clipRange;
            EXPECT_EQ(clip.nearView, cascade.range.nearView) << technique;
            EXPECT_EQ(clip.farView > cascade.range.farView, i < 2) << technique;
            EXPECT_EQ(cascade.slice.min, static_cast<float>(i));
            EXPECT_EQ(cascade.slice.max, 3.0f);
            EXPECT_EQ(cascade.extent, (vk::Extent2D{640, 360}));
            EXPECT_EQ(view.clipRanges()[i], clip);
            EXPECT_EQ(view.ranges()[i], cascade.range);
            const bool isAnchored = std::string_view(technique) == "anchored/count:3";
            EXPECT_EQ(view.anchorsView()[i], isAnchored ? cascade.range.nearView : 0.0) << technique;
        }
    }
}

TEST(FrameCutter, OnlyTheLastReversedCascadeIsOpenToInfinity) {
    const FrameView view = cutView(cutOptions("reversed/count:2"));
    ASSERT_EQ(view.cascades.size(), 2u);
    EXPECT_NE(view.cascades[0].terms.scale, 0.0);
    EXPECT_EQ(view.cascades[1].terms.scale, 0.0);
    EXPECT_EQ(view.cascades[1].terms.offset, view.cascades[1].range.nearView);
}

/// The thinnest object decides how fine they are, among those that the camera sees.
TEST(FrameCutter, FittedCascadesIgnoreWhatAHostDrawsOutOfRange) {
    const NoTargets targets;
    const RenderOptions options = cutOptions("anchored/fitted:1e-9,max=32");
    const auto rangesOver = [&](const std::vector<depth::Interval>& occupied) {
        FrameCutter cutter(options, targets);
        FrameView view = cutter.look(kCutCamera);
        cutter.cut(view, {}, occupied);
        return view.ranges();
    };
    const depth::Interval large{1e3, 9e4};
    const depth::Cascades wanted = rangesOver({large});
    EXPECT_EQ(rangesOver({large, {-5.0, -4.0}}), wanted) << "behind the camera";
    EXPECT_EQ(rangesOver({{0.01, 0.02}, large}), wanted) << "before the near plane";
    EXPECT_EQ(rangesOver({large, {2e5, 2e5 + 1.0}}), wanted) << "too far away";
    EXPECT_EQ(rangesOver({{-5.0, -1.0}}), rangesOver({}));
    EXPECT_NE(rangesOver({large, {-1.0, 2.0}}), wanted) << "around the camera";
}

TEST(FrameCutter, CascadesOutOfFocusAreSmallerAndOverlap) {
    RenderOptions options = cutOptions("anchored/at:5,20,300");
    options.targets = render::TargetsKind::layers;
    options.focus = {.distance = 10.0, .aperture = 0.5, .blend = true};
    const FrameView view = cutView(options);
    ASSERT_EQ(view.cascades.size(), 4u);
    EXPECT_EQ(view.cascades[1].extent, (vk::Extent2D{640, 360})); // holds what is sharp
    EXPECT_LT(view.cascades[3].extent.width, 640u);
    EXPECT_EQ(view.cascades[3].range.nearView, 300.0);
    EXPECT_LT(view.cascades[3].clipRange.nearView, 300.0);
}

TEST(FrameCutter, PushConstantsAreTheViewRounded) {
    const FrameView view = cutView(cutOptions("anchored/count:3"));
    const CascadeView& cascade = view.cascades[1];
    const shaders::CascadePush push = makeCascadePush(view, 1);
    EXPECT_EQ(push.anchorView, static_cast<float>(cascade.terms.anchorView));
    EXPECT_EQ(push.nearAhead, 0.0f);
    EXPECT_EQ(push.farAhead, static_cast<float>(cascade.clipRange.farView - cascade.clipRange.nearView));
    EXPECT_EQ(push.projectionX, static_cast<float>(1.0 / view.frustum.tanX));
    EXPECT_EQ(push.projectionY, static_cast<float>(-1.0 / view.frustum.tanY));
    EXPECT_EQ(push.cascade, 1u);
}

} // namespace

} // namespace cdr::render_test
