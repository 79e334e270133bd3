#include <cdr/scene/box_tree.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace cdr::scene {
namespace {

std::vector<Box> randomBoxes(std::size_t count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> place(-100.0, 100.0);
    std::vector<Box> boxes(count);
    for (Box& box : boxes) {
        const glm::dvec3 at(place(random), place(random), place(random));
        box.add(at);
        box.add(at + glm::dvec3(1.0, 2.0, 3.0));
    }
    return boxes;
}

/// Nodes between a node and its deepest leaf; checks what holds of each node.
std::size_t checkedDepth(const BoxTree& tree, std::span<const Box> boxes, std::uint32_t node,
                         std::vector<int>& seen) {
    const BoxTree::Node& self = tree.nodes()[node];
    Box inside;
    if (self.count > 0) {
        for (const std::uint32_t item : tree.order().subspan(self.first, self.count)) {
            ++seen[item];
            inside.add(boxes[item]);
        }
    } else {
        inside.add(tree.nodes()[self.first].box);
        inside.add(tree.nodes()[self.first + 1].box);
    }
    EXPECT_EQ(self.box.low, inside.low);
    EXPECT_EQ(self.box.high, inside.high);
    if (self.count > 0) {
        return 0;
    }
    return 1 + std::max(checkedDepth(tree, boxes, self.first, seen),
                        checkedDepth(tree, boxes, self.first + 1, seen));
}

/// Who looks at a box must not miss that something was no number, whatever followed it.
TEST(Box, KeepsWhatIsNotANumber) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const glm::dvec3 bad(0.0, none, 0.0);
    for (const auto& add : std::vector<std::function<void(Box&)>>{
             [&](Box& box) { box.add(bad); }, [&](Box& box) { box.add(Box{.low = bad, .high = bad}); },
             [&](Box& box) { box.add(bad, 1.0); }, [&](Box& box) { box.add(glm::dvec3(0.0), none); }}) {
        Box box;
        box.add(glm::dvec3(0.0));
        add(box);
        box.add(glm::dvec3(2.0));
        EXPECT_TRUE(std::isnan(box.low.y) && std::isnan(box.high.y));
        EXPECT_TRUE(std::isnan(box.diagonal()));
    }
}

TEST(BoxTree, HoldsEachItemOnceInBoxesThatFit) {
    for (const std::size_t count : {1u, 4u, 5u, 8u, 9u, 1000u}) {
        const std::vector<Box> boxes = randomBoxes(count, count);
        const BoxTree tree(boxes);
        std::vector<int> seen(count);
        const std::size_t depth = checkedDepth(tree, boxes, 0, seen);
        EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(count));
        EXPECT_LE(depth, count <= 4 ? 0u : count == 1000 ? 8u : 2u);
    }
}

TEST(BoxTree, IsBalancedWhereAllItemsAreAtOnePlace) {
    const std::vector<Box> boxes(1000, Box{.low = glm::dvec3(1.0), .high = glm::dvec3(1.0)});
    const BoxTree tree(boxes);
    std::vector<int> seen(boxes.size());
    EXPECT_EQ(checkedDepth(tree, boxes, 0, seen), 8u);
}

TEST(BoxTree, OfNothingHasNoNodes) {
    const BoxTree tree({});
    EXPECT_TRUE(tree.nodes().empty());
    EXPECT_TRUE(tree.order().empty());
}

TEST(Box, KnowsItsLongestAxis) {
    Box box{.low = glm::dvec3(0.0), .high = {1.0, 2.0, 2.0}};
    EXPECT_EQ(box.longestAxis(), 1);
    box.add(glm::dvec3(0.0, 0.0, -3.0));
    EXPECT_EQ(box.longestAxis(), 2);
    EXPECT_EQ((Box{.low = glm::dvec3(0.0), .high = glm::dvec3(1.0)}).longestAxis(), 0);
}

} // namespace
} // namespace cdr::scene
