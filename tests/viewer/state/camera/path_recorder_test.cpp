#include <viewer/state/camera/path_recorder.h>

#include <gtest/gtest.h>

namespace cdr::viewer {

namespace {

scene::Camera cameraAt(double x) {
    return scene::lookAt({}, {x, 0.0, 10.0}, {x, 0.0, 0.0});
}

TEST(PathRecorder, ThinsMotionToThirtyASecondAndKeepsBothEnds) {
    PathRecorder recorder;
    recorder.begin("cubes");
    for (int i = 0; i <= 1000; ++i) { // a second of a fast interface
        ASSERT_TRUE(recorder.add(i == 0 ? 7.0 : 0.001, cameraAt(i)));
    }
    recorder.end();
    const auto& recording = recorder.recording();
    EXPECT_EQ(recording.scene, "cubes");
    EXPECT_GE(recording.cameras.size(), 28u);
    EXPECT_LE(recording.cameras.size(), 32u);
    EXPECT_EQ(recording.cameras.front().seconds, 0.0);
    EXPECT_EQ(recording.cameras.front().camera.position.x, 0.0);
    EXPECT_NEAR(recording.seconds(), 1.0, 1e-9);
    EXPECT_EQ(recording.cameras.back().camera.position.x, 1000.0);
}

TEST(PathRecorder, KeepsTheEndsOfARest) {
    PathRecorder recorder;
    recorder.begin("cubes");
    recorder.add(0.0, cameraAt(0.0));
    for (int i = 0; i < 100; ++i) {
        recorder.add(0.1, cameraAt(0.0));
    }
    recorder.add(0.1, cameraAt(1.0));
    recorder.end();
    const auto& cameras = recorder.recording().cameras;
    ASSERT_EQ(cameras.size(), 3u);
    EXPECT_NEAR(cameras[1].seconds, 10.0, 1e-9);
    EXPECT_EQ(cameras[1].camera.position.x, 0.0);
    EXPECT_NEAR(cameras[2].seconds, 10.1, 1e-9);
    EXPECT_EQ(cameras[2].camera.position.x, 1.0);
    // Halfway through the rest the camera has not begun to leave.
    EXPECT_EQ(scene::cameraAt(recorder.recording(), 5.0).position.x, 0.0);
}

/// Its first camera may come too soon after one that was kept.
TEST(PathRecorder, KeepsTheEndsOfARestThatBeginsBetweenTwoOfThirtyASecond) {
    const auto rested = [](bool leaves) {
        PathRecorder recorder;
        recorder.begin("cubes");
        recorder.add(0.0, cameraAt(0.0));
        recorder.add(0.05, cameraAt(1.0));
        recorder.add(0.01, cameraAt(2.0));
        for (int i = 0; i < 100; ++i) {
            recorder.add(0.1, cameraAt(2.0));
        }
        if (leaves) {
            recorder.add(0.1, cameraAt(3.0));
        }
        recorder.end();
        return recorder.recording();
    };
    for (const bool leaves : {true, false}) {
        EXPECT_EQ(scene::cameraAt(rested(leaves), 5.0).position.x, 2.0) << leaves;
        EXPECT_EQ(rested(leaves).cameras.size(), leaves ? 5u : 4u);
    }
}

TEST(PathRecorder, MayHoldNothingOrOneCamera) {
    PathRecorder recorder;
    EXPECT_FALSE(recorder.add(0.1, cameraAt(1.0))) << "not begun";
    recorder.begin("cubes");
    recorder.end();
    EXPECT_TRUE(recorder.recording().cameras.empty());
    recorder.begin("afc");
    recorder.add(0.1, cameraAt(1.0));
    recorder.end();
    EXPECT_EQ(recorder.recording().cameras.size(), 1u);
    EXPECT_FALSE(recorder.isRecording());
    recorder.begin("afc");
    EXPECT_TRUE(recorder.recording().cameras.empty()) << "what was recorded before is gone";
}

TEST(PathRecorder, IsFullOnceAFileWouldBe) {
    PathRecorder recorder;
    recorder.begin("cubes");
    std::size_t added = 0;
    while (recorder.add(0.1, cameraAt(static_cast<double>(added)))) {
        ASSERT_LT(++added, 2 * scene::kMaxRecordedCameras);
    }
    recorder.end();
    EXPECT_GT(recorder.recording().cameras.size(), scene::kMaxRecordedCameras - 4);
    EXPECT_LE(recorder.recording().cameras.size(), scene::kMaxRecordedCameras);
    EXPECT_EQ(recorder.recording().cameras.back().camera.position.x, static_cast<double>(added - 1));
}

} // namespace

} // namespace cdr::viewer
