#include <cdr/visibility/hidden_cells.h>
#include <cdr/visibility/occluders.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace cdr::visibility {

namespace {

constexpr double kOpen = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kTiledWidth = 203; // whole tiles neither across nor down
constexpr std::uint32_t kTiledHeight = 101;

/// Every tile that a rectangle meets, looked at one by one.
bool hidesByTiles(DepthTiles& tiles, const PixelRect& rect, double nearestView) {
    for (std::uint32_t row = 0; row < tiles.rows(); ++row) {
        for (std::uint32_t column = 0; column < tiles.columns(); ++column) {
            const double left = column * DepthTiles::kSide;
            const double top = row * DepthTiles::kSide;
            const double right = std::min<double>(left + DepthTiles::kSide, kTiledWidth);
            const double bottom = std::min<double>(top + DepthTiles::kSide, kTiledHeight);
            const bool meets =
                rect.left < right && rect.right > left && rect.top < bottom && rect.bottom > top;
            if (meets && nearestView <= tiles.hiddenBeyond()[std::size_t{row} * tiles.columns() + column]) {
                return false;
            }
        }
    }
    return true;
}

TEST(DepthTiles, HideNothingBeforeTheyAreFilled) {
    const DepthTiles tiles(kTiledWidth, kTiledHeight);
    EXPECT_FALSE(tiles.hides({0.0, 0.0, 5.0, 5.0}, 1e300));
}

TEST(DepthTiles, APictureWithoutPixelsHidesAll) {
    for (const DepthTiles& tiles : {DepthTiles(0, 8), DepthTiles(100, 0), DepthTiles(0, 0)}) {
        EXPECT_TRUE(tiles.hides({0.0, 0.0, 8.0, 8.0}, 1.0));
    }
}

TEST(DepthTiles, HideWhatIsBesideThePicture) {
    const DepthTiles tiles(kTiledWidth, kTiledHeight);
    EXPECT_TRUE(tiles.hides({-9.0, 0.0, -1.0, 5.0}, 1.0));
    EXPECT_TRUE(tiles.hides({0.0, kTiledHeight + 1.0, 9.0, kTiledHeight + 4.0}, 1.0));
    EXPECT_FALSE(tiles.hides({-9.0, 0.0, 0.5, 5.0}, 1.0));
}

TEST(DepthTiles, HideWhatEachTileHides) {
    std::mt19937_64 random(7);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    int hidden = 0;
    for (int run = 0; run < 50; ++run) {
        DepthTiles tiles(kTiledWidth, kTiledHeight);
        for (double& beyond : tiles.hiddenBeyond()) {
            beyond = uniform(0.0, 1.0) < 0.03 ? kOpen : uniform(1.0, 10.0);
        }
        tiles.makeLevels();
        for (int i = 0; i < 400; ++i) {
            const double left = uniform(-30.0, kTiledWidth);
            const double top = uniform(-30.0, kTiledHeight);
            const double side = std::pow(10.0, uniform(-1.0, 2.0));
            const PixelRect rect{left, top, left + side, top + uniform(0.5, 2.0) * side};
            const double nearest = uniform(1.0, 12.0);
            const bool wanted = hidesByTiles(tiles, rect, nearest);
            hidden += wanted ? 1 : 0;
            ASSERT_EQ(tiles.hides(rect, nearest), wanted) << run << " " << i;
        }
    }
    EXPECT_GT(hidden, 1000);
}

TEST(DepthTiles, WhatIsNotANumberHidesNothing) {
    DepthTiles tiles(kTiledWidth, kTiledHeight);
    std::fill(tiles.hiddenBeyond().begin(), tiles.hiddenBeyond().end(), 1.0);
    tiles.hiddenBeyond().back() = kOpen;
    tiles.makeLevels();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(tiles.hides({0.0, 0.0, nan, nan}, 5.0));
    EXPECT_FALSE(tiles.hides({0.0, 0.0, 5.0, 5.0}, nan));
}

/// Balls before and behind a wall at distance 50 that fills the left half of the picture.
class HiddenTest : public testing::Test {
  protected:
    HiddenTest() {
        m_scene.meshes.push_back(scene::makeBox(glm::vec3(0.5f)));
        m_scene.materials.resize(4);
        m_scene.materials[1].alphaMode = scene::AlphaMode::mask;
        m_scene.materials[2].alphaMode = scene::AlphaMode::blend;
        m_scene.materials[3].layer = 0.01f;
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> any(-1.0, 1.0);
        for (std::uint32_t i = 0; i < 5000; ++i) {
            const double w = 55.0 + 50.0 * any(random);
            scene::addInstance(m_scene, 0, i % 16 == 0 ? 1 + i / 16 % 3 : 0, i,
                               {w * any(random), 0.6 * w * any(random), -w}, glm::mat3(1.0f));
        }
        m_cells.build(m_scene, m_workers);
        std::fill(m_tiles.hiddenBeyond().begin(), m_tiles.hiddenBeyond().end(), kOpen);
        for (std::size_t row = 0; row < m_tiles.rows(); ++row) {
            const auto tiles = m_tiles.hiddenBeyond().subspan(row * m_tiles.columns(), m_tiles.columns() / 2);
            std::fill(tiles.begin(), tiles.end(), 50.0);
        }
        m_tiles.makeLevels();
    }

    VisibleCells visible(std::size_t threads = 2) {
        platform::WorkerPool workers(threads);
        VisibleCells cells;
        cullCells(m_cells, m_camera, m_frustum, workers, cells);
        return cells;
    }

    static std::set<std::uint32_t> instancesOf(const VisibleCells& cells) {
        std::set<std::uint32_t> instances;
        for (const VisibleCells::Part& part : cells.parts) {
            for (std::size_t slot = 0; slot < InstanceCells::kCellSlots; ++slot) {
                if (part.slots >> slot & 1) {
                    instances.insert(cells.cells->instancesOf(part.cell)[slot]);
                }
            }
        }
        return instances;
    }

    scene::Scene m_scene;
    platform::WorkerPool m_workers{2};
    InstanceCells m_cells;
    scene::Camera m_camera{.fovY = 1.0, .nearView = 0.1, .farView = 1000.0};
    scene::Frustum m_frustum = scene::frustumOf(m_camera, 640, 360);
    DepthTiles m_tiles{640, 360};
};

TEST_F(HiddenTest, DropsWhatIsWhollyBehindAndKeepsTheRest) {
    VisibleCells cells = visible();
    const std::set<std::uint32_t> before = instancesOf(cells);
    dropHidden(m_frustum, m_tiles, m_workers, cells);
    const std::set<std::uint32_t> shown = instancesOf(cells);
    const double pixel = m_frustum.footprintSlope;
    int dropped = 0;
    for (const std::uint32_t i : before) {
        const glm::dvec3 position = m_scene.instances.position(i);
        const double w = -position.z;
        const auto radius = static_cast<double>(m_scene.instances.radius[i]);
        const double rim = 20.0 * pixel * w; // of tiles, and of pixels
        const bool isNearer = w - radius < 50.0;
        const bool reachesRight = position.x + radius > 0.0;
        // In the picture, since what is beside it may go or stay.
        const bool isInside = std::abs(position.x) + radius < w * m_frustum.tanX &&
                              std::abs(position.y) + radius < w * m_frustum.tanY;
        if (isInside && (isNearer || reachesRight)) {
            EXPECT_TRUE(shown.contains(i)) << i;
        }
        if (w - 2.1 * radius > 50.0 && position.x + 2.0 * radius + rim < 0.0) {
            EXPECT_FALSE(shown.contains(i)) << i;
        }
        dropped += shown.contains(i) ? 0 : 1;
    }
    EXPECT_GT(dropped, 1000);
}

TEST_F(HiddenTest, DropsTheSameForAnyNumberOfWorkers) {
    VisibleCells one = visible();
    VisibleCells many = visible();
    platform::WorkerPool alone(1);
    platform::WorkerPool eight(8);
    dropHidden(m_frustum, m_tiles, alone, one);
    dropHidden(m_frustum, m_tiles, eight, many);
    EXPECT_EQ(instancesOf(one), instancesOf(many));
}

TEST_F(HiddenTest, OccludersAreLargeOpaqueAndInNoLayer) {
    Occluders occluders;
    const VisibleCells cells = visible();
    const std::set<std::uint32_t> chosen = instancesOf(occluders.choose(m_scene, m_frustum, cells));
    EXPECT_GT(chosen.size(), 10u);
    EXPECT_LT(chosen.size(), instancesOf(cells).size() / 2);
    for (const std::uint32_t i : chosen) {
        EXPECT_EQ(m_scene.instances.material[i], 0u);
    }
}

TEST_F(HiddenTest, OccludersAreWhatTheLastFrameShowed) {
    Occluders occluders;
    VisibleCells shown = visible();
    const std::set<std::uint32_t> first = instancesOf(occluders.choose(m_scene, m_frustum, shown));
    const VisibleCells all = shown;
    dropHidden(m_frustum, m_tiles, m_workers, shown);
    occluders.remember(shown);
    const std::set<std::uint32_t> kept = instancesOf(shown);
    const std::set<std::uint32_t> second = instancesOf(occluders.choose(m_scene, m_frustum, all));
    EXPECT_GT(second.size(), first.size()); // smaller ones too
    EXPECT_TRUE(std::includes(kept.begin(), kept.end(), second.begin(), second.end()));
    occluders.forget();
    EXPECT_EQ(instancesOf(occluders.choose(m_scene, m_frustum, all)), first);
}

} // namespace

} // namespace cdr::visibility
