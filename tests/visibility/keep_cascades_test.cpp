#include <cdr/visibility/bin.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace cdr::visibility {
namespace {

TEST(Bin, KeepsTheListsOfSomeCascades) {
    DrawLists whole;
    whole.instance = {4, 5, 6, 7, 8, 9, 99};
    whole.begins = {0, 1, 2, 2, 5, 6, 6};
    whole.visible = 6;
    for (const auto& [begin, end] : {std::pair(0u, 3u), std::pair(0u, 1u), std::pair(1u, 3u),
                                     std::pair(2u, 3u), std::pair(1u, 1u), std::pair(3u, 3u)}) {
        DrawLists lists = whole;
        keepCascades(lists, {begin, end});
        EXPECT_EQ(lists.cascades(), 3u);
        EXPECT_EQ(lists.visible, 6u);
        for (std::size_t cascade = 0; cascade < 3; ++cascade) {
            const bool isKept = cascade >= begin && cascade < end;
            const auto range = lists.range(cascade);
            ASSERT_EQ(range.size(), isKept ? whole.range(cascade).size() : 0u);
            EXPECT_TRUE(std::equal(lists.instance.data() + range.begin, lists.instance.data() + range.end,
                                   whole.instance.data() + whole.range(cascade).begin));
            if (isKept) {
                EXPECT_EQ(lists.wideBegin(cascade) - range.begin,
                          whole.wideBegin(cascade) - whole.range(cascade).begin);
            }
        }
    }
}

} // namespace
} // namespace cdr::visibility
