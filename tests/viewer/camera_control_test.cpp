#include <viewer/session/camera_control.h>
#include <viewer/state/camera/stereo_view.h>

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <initializer_list>

namespace cdr::viewer_test {

namespace {

using namespace viewer;

class PointerOverThePicture : public testing::Test {
  protected:
    void happens(const InputEvent& event) { m_control.handle(event, m_area, InputOwner::picture, m_model); }
    bool isOver() const { return m_area.contains(m_control.cursor()); }

  private:
    CameraControl m_control;
    PictureArea m_area;
    ViewerModel m_model;
};

TEST_F(PointerOverThePicture, IsNotBeforeItComesNorAfterItLeaves) {
    EXPECT_FALSE(isOver());
    happens(MoveInput{0.0, 0.0});
    EXPECT_TRUE(isOver());
    happens(LeaveInput{});
    EXPECT_FALSE(isOver());
}

/// Else what is dragged would jump.
TEST_F(PointerOverThePicture, StaysWhereItIsWhileItDrags) {
    happens(MoveInput{5.0, 5.0});
    happens(ButtonInput{.button = 0, .pressed = true});
    happens(LeaveInput{});
    EXPECT_TRUE(isOver());
}

CameraControl holding(std::initializer_list<int> keys) {
    CameraControl control;
    ViewerModel model;
    for (const int key : keys) {
        control.handle(KeyInput{.key = key, .pressed = true}, {}, InputOwner::picture, model);
    }
    return control;
}

/// How far a short flight goes.
double flown(std::initializer_list<int> keys) {
    CameraControl control = holding(keys);
    ViewerModel model;
    model.camera.isThere = true;
    model.camera.surfaceView = 100.0;
    constexpr double kSeconds = 0.01;
    control.apply({}, kSeconds, model);
    return glm::length(model.camera.now.position);
}

/// The camera after Alt and the wheel, with two eyes beside each other or one.
scene::Camera zoomedAt(double x, const PictureArea& area, const ViewSettings& settings) {
    CameraControl control = holding({GLFW_KEY_LEFT_ALT});
    ViewerModel model;
    model.settings = settings;
    model.camera.isThere = true;
    control.handle(MoveInput{x, 70.0}, area, InputOwner::picture, model);
    control.handle(ScrollInput{.y = 2.0}, area, InputOwner::picture, model);
    control.apply(area, 0.01, model);
    return model.camera.now;
}

TEST(LensOfTwoEyes, NarrowsAboutWhatTheEyeUnderTheCursorSees) {
    const PictureArea both{.extent = {400, 150}};
    const PictureArea one{.extent = {200, 150}};
    const ViewSettings beside = withNextStereo({}, {10.0});
    const scene::Camera expected = zoomedAt(30.0, one, {});
    EXPECT_NE(expected, ViewerModel().camera.now);
    EXPECT_EQ(zoomedAt(30.0, both, beside), expected);
    EXPECT_EQ(zoomedAt(230.0, both, beside), expected);
    EXPECT_NE(zoomedAt(30.0, both, {}), expected);
}

TEST(HeldKeys, OfOneMeaningAreLetOneByOne) {
    CameraControl control = holding({GLFW_KEY_W, GLFW_KEY_UP});
    ViewerModel model;
    control.handle(KeyInput{.key = GLFW_KEY_W}, {}, InputOwner::picture, model);
    EXPECT_TRUE(control.isActive()) << "the other is still held";
    control.handle(KeyInput{.key = GLFW_KEY_UP}, {}, InputOwner::picture, model);
    EXPECT_FALSE(control.isActive());
}

TEST(HeldKeys, ChangeTheSpeedOnBothSidesOfTheKeyboard) {
    const double plain = flown({GLFW_KEY_W});
    EXPECT_GT(plain, 0.0);
    EXPECT_GT(flown({GLFW_KEY_W, GLFW_KEY_LEFT_SHIFT}), 5.0 * plain);
    EXPECT_EQ(flown({GLFW_KEY_W, GLFW_KEY_RIGHT_SHIFT}), flown({GLFW_KEY_W, GLFW_KEY_LEFT_SHIFT}));
    EXPECT_LT(flown({GLFW_KEY_W, GLFW_KEY_LEFT_CONTROL}), 0.2 * plain);
    EXPECT_EQ(flown({GLFW_KEY_W, GLFW_KEY_RIGHT_CONTROL}), flown({GLFW_KEY_W, GLFW_KEY_LEFT_CONTROL}));
}

} // namespace

} // namespace cdr::viewer_test
