#include "failing_calls.h"
#include "fixture.h"

namespace cdr::render_test {

namespace {

class RendererSetupTest : public RenderTest {};

/// Vulkan lets a device that draws to D24 have no D32_SFLOAT.
TEST_F(RendererSetupTest, ShadowsAndOcclusionCullingAreRefusedWithoutTheirDepthFormat) {
    const scene::Scene scene = boxScene();
    render::RenderOptions plain = thumbnailOptions(
        {depth::Mapping::reversed, depth::SplitCount{1}, depth::DepthFormat::d16}); // on every device
    render::RenderOptions shadows = plain;
    shadows.shadows.method = render::ShadowMethod::anchored;
    render::RenderOptions occlusion = plain;
    occlusion.occlusionCulling = true;
    const std::string lacks = " a depth buffer of D32_SFLOAT, which " + device().info().name + " lacks";
    {
        const StandIn withheld = noDepthFormat(VK_FORMAT_D32_SFLOAT);
        EXPECT_EQ(refusalOf(scene, plain), "none");
        EXPECT_EQ(refusalOf(scene, shadows), "shadows need" + lacks);
        EXPECT_EQ(refusalOf(scene, occlusion), "occlusion culling needs" + lacks);
    }
    EXPECT_EQ(refusalOf(scene, shadows), "none");
    EXPECT_EQ(refusalOf(scene, occlusion), "none");
}

} // namespace

} // namespace cdr::render_test
