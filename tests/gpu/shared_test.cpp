#include <cdr/gpu/shared.h>

#include <gtest/gtest.h>

#include <thread>
#include <utility>
#include <vector>

namespace cdr::gpu {

namespace {

/// Stands for a vk::UniqueHandle: it owns a number and counts those that are there.
class UniqueNumber {
  public:
    using element_type = int;

    explicit UniqueNumber(int number, int& alive) : m_number(number), m_alive(&alive) { ++alive; }
    UniqueNumber(UniqueNumber&& other) noexcept
        : m_number(other.m_number),
          m_alive(std::exchange(other.m_alive, nullptr)) {}
    UniqueNumber(const UniqueNumber&) = delete;
    UniqueNumber& operator=(const UniqueNumber&) = delete;
    UniqueNumber& operator=(UniqueNumber&&) = delete;
    ~UniqueNumber() {
        if (m_alive != nullptr) {
            --*m_alive;
        }
    }
    const int& operator*() const { return m_number; }

  private:
    int m_number;
    int* m_alive;
};

using Numbers = SharedObjects<int, UniqueNumber>;

TEST(SharedObjects, GivesEqualOptionsOneObjectWhileSomebodyHasIt) {
    int alive = 0;
    Numbers numbers;
    const auto make = [&](int options) { return UniqueNumber(10 * options, alive); };
    auto first = numbers.get(1, make);
    auto again = numbers.get(1, make);
    const auto other = numbers.get(2, make);
    EXPECT_EQ(*again, 10);
    EXPECT_EQ(*other, 20);
    EXPECT_EQ(first, again);
    EXPECT_NE(first, other);
    EXPECT_EQ(numbers.made(), 2u);
    first = {};
    EXPECT_EQ(alive, 2);
    again = {};
    EXPECT_EQ(alive, 1);
    EXPECT_EQ(*numbers.get(1, make), 10);
    EXPECT_EQ(numbers.made(), 3u);
}

/// From the call on, and until the release.
TEST(SharedObjects, KeepsThoseThatNobodyHasWhereItIsTold) {
    int alive = 0;
    Numbers numbers;
    const auto make = [&](int options) { return UniqueNumber(10 * options, alive); };
    numbers.get(1, make);
    EXPECT_EQ(alive, 0);
    numbers.keep();
    numbers.get(1, make);
    EXPECT_EQ(alive, 1);
    const auto held = numbers.get(2, make);
    EXPECT_EQ(*numbers.get(1, make), 10);
    EXPECT_EQ(numbers.made(), 3u);
    numbers.release();
    EXPECT_EQ(alive, 1);
    EXPECT_EQ(*numbers.get(2, make), 20);
    numbers.get(1, make);
    EXPECT_EQ(alive, 1);
    EXPECT_EQ(numbers.made(), 4u);
}

TEST(SharedObjects, WhatIsKeptGoesWithWhatKeepsIt) {
    int alive = 0;
    {
        Numbers numbers;
        numbers.keep();
        numbers.get(1, [&](int options) { return UniqueNumber(options, alive); });
        EXPECT_EQ(alive, 1);
    }
    EXPECT_EQ(alive, 0);
}

TEST(SharedObjects, ANullOneIsTheNullHandle) {
    const Shared<UniqueNumber> none;
    EXPECT_FALSE(none);
    EXPECT_EQ(*none, 0);
}

TEST(SharedObjects, WhatCannotBeMadeIsNotKept) {
    int alive = 0;
    Numbers numbers;
    EXPECT_THROW(numbers.get(1, [](int) -> UniqueNumber { throw 1; }), int);
    EXPECT_EQ(*numbers.get(1, [&](int) { return UniqueNumber(7, alive); }), 7);
    EXPECT_EQ(numbers.made(), 1u);
}

TEST(SharedObjects, ThreadsThatAskAtOnceGetOneObject) {
    int alive = 0;
    Numbers numbers;
    std::vector<Shared<UniqueNumber>> got(8);
    std::vector<std::jthread> threads;
    for (auto& each : got) {
        threads.emplace_back(
            [&] { each = numbers.get(3, [&](int options) { return UniqueNumber(options, alive); }); });
    }
    threads.clear();
    for (const auto& each : got) {
        EXPECT_EQ(each, got.front());
    }
    EXPECT_EQ(numbers.made(), 1u);
}

} // namespace

} // namespace cdr::gpu
