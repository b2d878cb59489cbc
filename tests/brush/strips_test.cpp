#include "brush/strips.hpp"

#include "core/random.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

constexpr int kCells = 64;
constexpr double kRadius = 3.0;

/// Elements scattered over a square of cells, across the travel along x.
std::vector<StripPlace> scattered(int count, std::uint32_t seed) {
    std::vector<StripPlace> places;
    for (int i = 0; i < count; ++i) {
        const auto number = static_cast<std::uint32_t>(i);
        const double x = kCells * core::uniform_noise(number, seed);
        const double y = kCells * core::uniform_noise(number, seed + 1);
        places.push_back({2 * i, x, y, x});
    }
    return places;
}

/// A board of cells, each of which lists the elements whose footprints have come over it. Plain lists:
/// two threads in one cell would race, which the thread sanitizer reports.
class Board {
  public:
    explicit Board(const std::vector<StripPlace>& places) : places_(places), visits_(kCells * kCells) {}

    void visit(int element) {
        const StripPlace& place = places_[element / 2];
        for (int y = 0; y < kCells; ++y) {
            for (int x = 0; x < kCells; ++x) {
                if (std::hypot(x + 0.5 - place.x_mm, y + 0.5 - place.y_mm) <= kRadius)
                    visits_[y * kCells + x].push_back(element);
            }
        }
    }
    const std::vector<std::vector<int>>& visits() const { return visits_; }

  private:
    const std::vector<StripPlace>& places_;
    std::vector<std::vector<int>> visits_;
};

class StripsOnThreads : public testing::TestWithParam<int> {};

TEST_P(StripsOnThreads, EveryCellSeesTheElementsInTheirOrder) {
    core::ThreadPool pool(GetParam());
    Strips strips;
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        const std::vector<StripPlace> places = scattered(150, seed);
        Board alone(places), beside(places);
        for (const StripPlace& place : places)
            alone.visit(place.element);
        strips.divide(places, kRadius, 5);
        EXPECT_EQ(strips.count(), 5);
        EXPECT_TRUE(strips.run(&pool, [&](int element, int) {
            beside.visit(element);
            return true;
        }));
        EXPECT_EQ(beside.visits(), alone.visits()) << "seed " << seed;
    }
}

TEST_P(StripsOnThreads, GoesOnWhereAnElementWasHindered) {
    core::ThreadPool pool(GetParam());
    const std::vector<StripPlace> places = scattered(150, 7);
    Board alone(places), beside(places);
    for (const StripPlace& place : places)
        alone.visit(place.element);
    std::vector<char> freed(4, 0);
    int halts = 0;
    Strips strips;
    strips.divide(places, kRadius, 4);
    const auto act = [&](int element, int strip) {
        if (element % 10 == 0 && freed[strip] == 0) return false;
        freed[strip] = 0;
        beside.visit(element);
        return true;
    };
    for (; !strips.run(&pool, act); ++halts) {
        ASSERT_FALSE(strips.hindered().empty());
        for (const int strip : strips.hindered())
            freed[strip] = 1;
    }
    EXPECT_GT(halts, 0);
    EXPECT_EQ(beside.visits(), alone.visits());
}

INSTANTIATE_TEST_SUITE_P(Pools, StripsOnThreads, testing::Values(1, 2, 3, 5));

TEST(Strips, AreWideEnoughToReachTheNextOneOnly) {
    Strips strips;
    const std::vector<StripPlace> places = scattered(50, 3);
    strips.divide(places, kCells / 8.5, 100);
    EXPECT_EQ(strips.count(), 2);
    strips.divide(places, kCells, 100);
    EXPECT_EQ(strips.count(), 1);
}

TEST(Strips, NeedNoPoolForOne) {
    Strips strips;
    const std::vector<StripPlace> places = scattered(20, 5);
    strips.divide(places, kRadius, 1);
    std::vector<int> order;
    EXPECT_TRUE(strips.run(nullptr, [&](int element, int) {
        order.push_back(element);
        return true;
    }));
    ASSERT_EQ(order.size(), places.size());
    EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
}

TEST(Strips, MayHaveNothingToDo) {
    core::ThreadPool pool(2);
    Strips strips;
    strips.divide({}, kRadius, 2);
    EXPECT_TRUE(strips.run(&pool, [](int, int) { return true; }));
}

}  // namespace
}  // namespace pastoso::brush
