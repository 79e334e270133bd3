#include <viewer/session/camera_control.h>

#include <gtest/gtest.h>

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

} // namespace

} // namespace cdr::viewer_test
