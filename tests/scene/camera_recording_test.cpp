#include "../support/refusal.h"
#include "../support/temporary_folder.h"

#include <cdr/base/error.h>
#include <cdr/platform/file.h>
#include <cdr/scene/camera_recording.h>
#include <scenes/cubes.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace cdr::scene {

namespace {

using test::TemporaryFolder;

/// A flight around the afc field, at irregular moments, with a lens that narrows.
CameraRecording flown() {
    CameraRecording recording{.scene = "afc", .cameras = {}};
    const CameraPath path = scenes::makeAfc(1).path;
    for (std::uint32_t i = 0; i < 12; ++i) {
        Camera camera = path.at(7 * i);
        camera.fovY *= std::pow(0.7, i);
        camera.lensShift = camera.fovY * glm::dvec2(i % 3, -0.25 * (i % 2));
        EXPECT_TRUE(record(recording, 0.1 * i + 0.01 * (i % 3), camera));
    }
    return recording;
}

TEST(CameraRecording, ComesBackFromAFileToTheBit) {
    const TemporaryFolder folder;
    CameraRecording recording = flown();
    recording.scene = "a \"file\"\n.glb";
    writeRecording(folder.path() / "p.json", recording);
    const CameraRecording read = readRecording(folder.path() / "p.json");
    EXPECT_EQ(read.scene, recording.scene);
    ASSERT_EQ(read.cameras.size(), recording.cameras.size());
    for (std::size_t i = 0; i < read.cameras.size(); ++i) {
        EXPECT_EQ(read.cameras[i].seconds, recording.cameras[i].seconds);
        EXPECT_EQ(read.cameras[i].camera, recording.cameras[i].camera);
    }
}

TEST(CameraRecording, RecordsOnlyWhatIsLater) {
    CameraRecording recording;
    EXPECT_FALSE(record(recording, -1.0, {}));
    EXPECT_TRUE(record(recording, 0.0, {}));
    EXPECT_FALSE(record(recording, 0.0, {}));
    EXPECT_FALSE(record(recording, std::nan(""), {}));
    EXPECT_FALSE(record(recording, std::numeric_limits<double>::infinity(), {}));
    EXPECT_TRUE(record(recording, 1e-9, {}));
    EXPECT_THROW(record(recording, 1.0, {.nearView = -1.0}), base::InputError);
    EXPECT_EQ(recording.cameras.size(), 2u);
}

TEST(CameraRecording, StopsWhenFull) {
    CameraRecording recording;
    for (std::size_t i = 0; i < kMaxRecordedCameras; ++i) {
        ASSERT_TRUE(record(recording, static_cast<double>(i), {}));
    }
    EXPECT_FALSE(record(recording, 1e9, {}));
}

TEST(CameraRecording, PlaysRecordedMomentsExactlyAndHoldsTheEnds) {
    const CameraRecording recording = flown();
    for (const RecordedCamera& recorded : recording.cameras) {
        EXPECT_EQ(cameraAt(recording, recorded.seconds), recorded.camera);
    }
    EXPECT_EQ(cameraAt(recording, -5.0), recording.cameras.front().camera);
    EXPECT_EQ(cameraAt(recording, 1e9), recording.cameras.back().camera);
}

TEST(CameraRecording, InterpolatesBetween) {
    CameraRecording recording;
    Camera first = lookAt({.fovY = radiansOf(60.0), .nearView = 0.01, .farView = 1e4}, glm::dvec3(0.0),
                          {0.0, 0.0, -1.0});
    Camera second =
        lookAt({.fovY = radiansOf(0.006), .nearView = 1.0, .farView = 1e8}, {4.0, 0.0, 0.0}, {5.0, 0.0, 0.0});
    first.lensShift.x = 400.0 * std::tan(0.5 * first.fovY);
    record(recording, 1.0, first);
    record(recording, 3.0, second);
    const Camera middle = cameraAt(recording, 2.0);
    EXPECT_NEAR(glm::distance(middle.position, glm::dvec3(2.0, 0.0, 0.0)), 0.0, 1e-15);
    EXPECT_NEAR(glm::distance(-middle.back, glm::normalize(glm::dvec3(1.0, 0.0, -1.0))), 0.0, 1e-15);
    EXPECT_NEAR(middle.fovY / radiansOf(0.6), 1.0, 1e-12);
    EXPECT_NEAR(middle.lensShift.x / std::tan(0.5 * middle.fovY), 200.0, 1e-9); // in halves of the picture
    EXPECT_NEAR(middle.nearView, 0.1, 1e-14);
    EXPECT_NEAR(middle.farView / 1e6, 1.0, 1e-12);
}

TEST(CameraRecording, ArrivesWhereItEndsHoweverLongTheWay) {
    CameraRecording recording;
    const glm::dvec3 end(0.123456789, 0.0, 0.0);
    record(recording, 0.0, lookAlong({}, {1e12, 0.0, 0.0}, {-1.0, 0.0, 0.0}));
    record(recording, 1.0, lookAlong({}, end, {-1.0, 0.0, 0.0}));
    const double share = 1.0 - 0x1p-43; // 0.11 units before the end
    EXPECT_NEAR(cameraAt(recording, share).position.x - end.x, 0x1p-43 * 1e12, 1e-12);
}

TEST(CameraRecording, StaysExactFarOut) {
    // Two cameras a millimetre apart, 10^8 out: the steps of the way are those of float64 there, 1.5e-8.
    CameraRecording recording;
    const glm::dvec3 there(1e8, -1e8, 1e8);
    const glm::dvec3 way(1e-3, 0.0, 0.0);
    const Camera camera = lookAlong({}, there, {0.1, 0.2, -1.0});
    Camera next = camera;
    next.position += way;
    record(recording, 0.0, camera);
    record(recording, 1.0, next);
    double last = there.x;
    for (int i = 1; i < 100; ++i) {
        const Camera between = cameraAt(recording, 0.01 * i);
        EXPECT_NEAR(between.position.x - there.x, 1e-5 * i, 2e-8);
        EXPECT_GE(between.position.x, last);
        EXPECT_EQ(between.position.y, there.y);
        EXPECT_EQ(between.back, camera.back); // the same at both ends, so everywhere
        EXPECT_EQ(between.right, camera.right);
        last = between.position.x;
    }
}

TEST(CameraRecording, TurnsTheShortWayAndStaysUpright) {
    CameraRecording recording;
    record(recording, 0.0, lookAlong({}, glm::dvec3(0.0), {std::sin(3.0), 0.0, -std::cos(3.0)}));
    record(recording, 1.0, lookAlong({}, glm::dvec3(0.0), {std::sin(-3.0), 0.0, -std::cos(-3.0)}));
    for (int i = 0; i <= 10; ++i) {
        const Camera camera = cameraAt(recording, 0.1 * i);
        EXPECT_GE(-camera.back.z, std::cos(0.15) - 1e-12) << i; // past +z, never through -z
        EXPECT_NEAR(camera.up.y, 1.0, 1e-12);
    }
}

TEST(CameraRecording, BecomesAPathOfAnyLength) {
    const CameraRecording recording = flown();
    const CameraPath same = pathOf(recording, 12);
    for (std::uint32_t i = 0; i < 12; ++i) {
        EXPECT_EQ(same.at(i), recording.cameras[i].camera);
    }
    const CameraPath longer = pathOf(recording, 100);
    EXPECT_EQ(longer.at(0), recording.cameras.front().camera);
    EXPECT_EQ(longer.at(99), recording.cameras.back().camera);
    EXPECT_EQ(longer.at(100), longer.at(0));
    EXPECT_LT(longer.at(50).fovY, longer.at(49).fovY);
    EXPECT_EQ(pathOf(recording, 1).at(0), recording.cameras.front().camera);
    EXPECT_THROW(pathOf(recording, 0), base::InputError);
    EXPECT_THROW(pathOf({}, 3), base::InputError);
    EXPECT_THROW(cameraAt({}, 0.0), base::InputError);
}

/// Ways to damage a valid file, and a word of the message for each.
struct Spoiled {
    const char* what;
    std::function<void(nlohmann::json&)> spoil;
};

TEST(CameraRecordingFile, RefusesWhatIsNotOneInOneLineThatNamesIt) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "p.json";
    writeRecording(path, flown());
    const nlohmann::json sound = nlohmann::json::parse(platform::readFile(path, 1 << 20));
    const std::vector<Spoiled> spoiled{
        {"not a camera path", [](auto& j) { j["format"] = "gltf"; }},
        {"not a camera path",
         [](auto& j) {
             j = nlohmann::json::array({1, 2});
         }},
        {"version", [](auto& j) { j["version"] = 2; }},
        {"1 to 36000 cameras", [](auto& j) { j["cameras"] = nlohmann::json::array(); }},
        {"1 to 36000 cameras", [](auto& j) { j["cameras"] = 7; }},
        {"damaged", [](auto& j) { j.erase("cameras"); }},
        {"damaged", [](auto& j) { j["scene"] = 3; }},
        {"too long", [](auto& j) { j["scene"] = std::string(5000, 'a'); }},
        {"camera 3: position must be three numbers",
         [](auto& j) {
             j["cameras"][3]["position"] = {1, 2};
         }},
        {"camera 3: up must be three numbers", [](auto& j) { j["cameras"][3]["up"][1] = "x"; }},
        {"camera 3: near must be a number", [](auto& j) { j["cameras"][3]["near"] = nullptr; }},
        {"camera 3: near must be finite and above 0", [](auto& j) { j["cameras"][3]["near"] = 0.0; }},
        {"camera 3: lens_shift must be two numbers", [](auto& j) { j["cameras"][3]["lens_shift"] = {1.0}; }},
        {"camera 3: lens_shift must be two numbers",
         [](auto& j) {
             j["cameras"][3]["lens_shift"] = {1.0, "x"};
         }},
        {"camera 3: the shift of this lens",
         [](auto& j) {
             j["cameras"][3]["lens_shift"] = {1e9, 0.0};
         }},
        {"camera 3: far must be finite", [](auto& j) { j["cameras"][3]["far"] = 1e-9; }},
        {"camera 3: field of view", [](auto& j) { j["cameras"][3]["fov_radians"] = 3.2; }},
        {"camera 3: right, up and back",
         [](auto& j) {
             j["cameras"][3]["up"] = {0.0, 2.0, 0.0};
         }},
        {"camera 3: right, up and back",
         [](auto& j) {
             j["cameras"][3]["right"] = {0.0, 0.0, 0.0};
         }},
        {"right-handed",
         [](auto& j) {
             for (auto& x : j["cameras"][3]["right"]) {
                 x = -x.template get<double>();
             }
         }},
        {"camera 3: seconds", [](auto& j) { j["cameras"][3]["seconds"] = 0.0; }},
        {"camera 0: seconds", [](auto& j) { j["cameras"][0]["seconds"] = -1.0; }},
        {"camera 4: it is too far from the one before",
         [](auto& j) {
             j["cameras"][3]["position"] = {1e308, 0.0, 0.0};
             j["cameras"][4]["position"] = {-1e308, 0.0, 0.0};
         }},
    };
    for (const Spoiled& spoil : spoiled) {
        nlohmann::json json = sound;
        spoil.spoil(json);
        platform::writeText(path, json.dump());
        const std::string said = cdr::test::inputErrorOf([&] { readRecording(path); });
        EXPECT_NE(said.find(spoil.what), std::string::npos) << spoil.what << ": " << said;
        EXPECT_EQ(said.find(path.string()), 0u) << said;
        EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }
    platform::writeText(path, sound.dump());
    EXPECT_EQ(readRecording(path).cameras.size(), 12u);
}

TEST(CameraRecordingFile, RefusesWhatIsNotJsonOrTooDeepOrHuge) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "p.json";
    const std::string sound = [&] {
        writeRecording(path, flown());
        const platform::Bytes bytes = platform::readFile(path, 1 << 20);
        return std::string(bytes.begin(), bytes.end());
    }();
    for (const std::string& text :
         {std::string(), std::string("{"), std::string(100'000, '['), sound.substr(0, sound.size() / 2),
          std::string("{\"format\":1e999}"), std::string("\xff\xfe\0\0", 4)}) {
        platform::writeText(path, text);
        EXPECT_NE(cdr::test::inputErrorOf([&] { readRecording(path); }).find("camera path"),
                  std::string::npos)
            << text.substr(0, 40);
    }
    EXPECT_NE(cdr::test::inputErrorOf([&] { readRecording(folder.path() / "none.json"); }), "");
    EXPECT_NE(cdr::test::inputErrorOf([&] { readRecording(folder.path()); }), "");
    // With any byte changed, a valid file is either read or refused.
    for (std::size_t i = 0; i < sound.size(); i += 7) {
        std::string flipped = sound;
        flipped[i] = static_cast<char>(flipped[i] ^ (1 << (i % 7)));
        platform::writeText(path, flipped);
        cdr::test::inputErrorOf([&] { readRecording(path); });
    }
}

} // namespace

} // namespace cdr::scene
