#include "../fixture.h"

#include <cdr/base/error.h>

#include <glm/gtc/matrix_transform.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cdr::render_test {

namespace {

/// An object of two parts, which are turned against each other.
class MotionPartsTest : public RenderTest {
  protected:
    void SetUp() override {
        RenderTest::SetUp();
        for (int part = 0; part < 2; ++part) {
            m_parts.push_back(
                m_world.addInstance({.mesh = m_world.mesh(0), .material = m_world.material(0), .object = 7}));
        }
        render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
        options.motion = true;
        m_onDevice.emplace(device(), m_world);
        m_renderer.emplace(device(), *m_onDevice, options);
    }

    /// Where the object is and was, and by how much its parts are shorter along each axis.
    struct Move {
        glm::dmat4 before{1.0};
        glm::dmat4 now{1.0};
        glm::dvec3 size{1.0};
    };
    /// @param slip how far one part moves apart
    bool isRefused(const Move& move, double slip) {
        m_renderer->forgetFrames();
        show(move.before, move.size, 0.0);
        try {
            show(move.now, move.size, slip);
        } catch (const base::InputError& error) {
            EXPECT_NE(std::string(error.what()).find("instances of object 7 moved apart"), std::string::npos)
                << error.what();
            return true;
        }
        return false;
    }

  private:
    void show(const glm::dmat4& object, const glm::dvec3& size, double slip) {
        std::vector<scene::Transform> places;
        for (const auto& [x, angle] : {std::pair(-0.8, 0.7), {0.8 + slip, 1.7}}) {
            const glm::dmat4 moved = glm::translate(object, glm::dvec3(x, 0.0, 0.0));
            const glm::dmat4 part = glm::rotate(glm::scale(moved, size), angle, glm::dvec3(1.0, 2.0, 3.0));
            places.push_back({.position = glm::dvec3(part[3]), .basis = glm::mat3(glm::dmat3(part))});
        }
        m_world.setTransforms(m_parts, places);
        m_renderer->render({.fovY = 1.0});
    }

    scene::World m_world{boxScene()};
    std::vector<scene::InstanceHandle> m_parts;
    std::optional<render::GpuScene> m_onDevice;
    std::optional<render::Renderer> m_renderer;
};

const glm::dmat4 kAhead = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -5.0));
const glm::dmat4 kTurned = glm::rotate(kAhead, 0.1, glm::dvec3(0.3, 1.0, 0.2));

TEST_F(MotionPartsTest, MayBeFlatNowOrBefore) {
    const glm::dvec3 flatten(1.0, 0.0, 1.0);
    const glm::dmat4 flat = glm::scale(kAhead, flatten);
    const glm::dmat4 aside = glm::scale(glm::translate(kAhead, glm::dvec3(0.1, 0.2, 0.0)), flatten);
    const glm::dmat4 flatTurned = glm::scale(kTurned, flatten);
    for (const Move& move : {Move{flat, kAhead}, Move{flat, kTurned}, Move{flat, aside}}) {
        EXPECT_FALSE(isRefused(move, 0.0));
        EXPECT_TRUE(isRefused(move, 0.1));
    }
    for (const Move& move : {Move{kAhead, flat}, Move{flat, flatTurned}, Move{kAhead, flatTurned}}) {
        EXPECT_FALSE(isRefused(move, 0.0)) << "no part tells how the others turned";
    }
}

/// Size 0 hides an object.
TEST_F(MotionPartsTest, MayShrinkToNothingAndGrowAgain) {
    for (const double size : {0.0, 1e-3}) {
        const glm::dmat4 small = glm::scale(kAhead, glm::dvec3(size));
        EXPECT_FALSE(isRefused({kAhead, small}, 0.0)) << size;
        EXPECT_FALSE(isRefused({small, kTurned}, 0.0)) << size;
        EXPECT_EQ(isRefused({small, kTurned}, 0.1), size > 0.0) << "nothing was apart at size 0";
    }
}

/// So far away, where they are is known less exactly than the bases.
TEST_F(MotionPartsTest, MayComeFromFarAwayAndGoThere) {
    const glm::dmat4 far = glm::translate(kAhead, glm::dvec3(1e11, 0.0, 0.0));
    EXPECT_FALSE(isRefused({kAhead, far}, 0.0));
    EXPECT_FALSE(isRefused({far, kAhead}, 0.0));
}

/// The inverses of their bases are less exact than the bases.
TEST_F(MotionPartsTest, MayBeThin) {
    for (const double thickness : {0.1, 1e-2, 1e-3, 1e-4}) {
        const Move move{kAhead, kTurned, {thickness, 1.0, 1.0}};
        EXPECT_FALSE(isRefused(move, 0.0)) << thickness;
        EXPECT_TRUE(isRefused(move, 0.1)) << thickness;
    }
}

} // namespace

} // namespace cdr::render_test
