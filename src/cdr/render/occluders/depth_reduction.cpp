#include <cdr/platform/vector_clones.h>
#include <cdr/render/occluders/depth_reduction.h>

#include <algorithm>
#include <limits>

namespace cdr::render {

namespace {

using visibility::DepthTiles;

/// What the depths of the buffer are rounded by, as a share of the distance.
constexpr double kRounding = 1e-6;

/// The least depth of each tile of a row of tiles.
CDR_VECTOR_CLONES
void leastOfTiles(const float* zNdc, std::size_t width, std::size_t rows, std::span<float> least) {
    std::fill(least.begin(), least.end(), std::numeric_limits<float>::max());
    const std::size_t whole = width / DepthTiles::kSide;
    for (std::size_t row = 0; row < rows; ++row, zNdc += width) {
        for (std::size_t tile = 0; tile < whole; ++tile) {
            float lowest = least[tile];
            for (std::size_t x = 0; x < DepthTiles::kSide; ++x) {
                lowest = std::min(lowest, zNdc[tile * DepthTiles::kSide + x]);
            }
            least[tile] = lowest;
        }
        for (std::size_t x = whole * DepthTiles::kSide; x < width; ++x) {
            least[whole] = std::min(least[whole], zNdc[x]);
        }
    }
}

} // namespace

void reduceDepth(std::span<const float> zNdc, std::uint32_t width, double nearView, const OrderMargin& margin,
                 platform::WorkerPool& workers, DepthTiles& tiles) {
    const std::size_t height = zNdc.size() / width;
    const std::span<double> hiddenBeyond = tiles.hiddenBeyond();
    workers.run(tiles.rows(), [&](std::size_t row, std::size_t) {
        std::vector<float> least(tiles.columns());
        const std::size_t first = row * DepthTiles::kSide;
        leastOfTiles(zNdc.data() + first * width, width,
                     std::min<std::size_t>(DepthTiles::kSide, height - first), least);
        for (std::size_t tile = 0; tile < least.size(); ++tile) {
            const double distanceView = nearView / static_cast<double>(least[tile]);
            hiddenBeyond[row * least.size() + tile] = // infinity where nothing was drawn
                distanceView * (1.0 + kRounding) + margin.at(distanceView);
        }
    });
    tiles.makeLevels();
}

} // namespace cdr::render
