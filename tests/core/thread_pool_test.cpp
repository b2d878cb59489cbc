#include "core/thread_pool.hpp"

#include <atomic>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace {

using pastoso::core::ThreadPool;

class Pool : public testing::TestWithParam<int> {
  protected:
    ThreadPool pool_{GetParam()};
};

TEST_P(Pool, HasAsManyThreadsAsAskedFor) {
    EXPECT_EQ(pool_.thread_count(), GetParam());
}

TEST_P(Pool, TakesEveryIndexOnce) {
    for (const std::size_t count : {0U, 1U, 2U, 3U, 7U, 64U, 1000U}) {
        std::vector<std::atomic<int>> calls(count);
        pool_.run(count, [&](std::size_t index, int) { ++calls[index]; });
        for (std::size_t index = 0; index < count; ++index)
            EXPECT_EQ(calls[index], 1) << index << " of " << count;
    }
}

TEST_P(Pool, WorkersHaveTheirOwnNumbers) {
    // Plain counters: two threads with one number would race, which the thread sanitizer reports.
    std::vector<long> calls(static_cast<std::size_t>(pool_.thread_count()));
    pool_.run(5000, [&](std::size_t, int worker) { ++calls.at(static_cast<std::size_t>(worker)); });
    EXPECT_EQ(std::accumulate(calls.begin(), calls.end(), 0L), 5000);
}

TEST_P(Pool, ManyShortRunsFollowEachOther) {
    // Each run reads what the one before wrote: run() must not return early, nor start anything late.
    constexpr int kRuns = 3000;
    std::vector<int> values(8, 0);
    for (int run = 0; run < kRuns; ++run) {
        pool_.run(values.size(), [&](std::size_t index, int) {
            ASSERT_EQ(values[index], run);
            values[index] = run + 1;
        });
    }
    EXPECT_EQ(values, std::vector<int>(8, kRuns));
}

TEST_P(Pool, ThrowsWhatItsBodyThrowsAndGoesOn) {
    for (int run = 0; run < 100; ++run) {
        EXPECT_THROW(pool_.run(64,
                               [&](std::size_t index, int) {
                                   if (index % 8 == 7) throw std::runtime_error("broken");
                               }),
                     std::runtime_error);
        std::atomic<int> calls = 0;
        pool_.run(64, [&](std::size_t, int) { ++calls; });
        EXPECT_EQ(calls, 64);
    }
}

TEST_P(Pool, TheCallersMemoryIsSeenByTheWorkersAndBack) {
    std::vector<double> input(1000);
    std::iota(input.begin(), input.end(), 1.0);
    std::vector<double> output(input.size());
    pool_.run(input.size(), [&](std::size_t index, int) { output[index] = 2.0 * input[index]; });
    EXPECT_EQ(std::accumulate(output.begin(), output.end(), 0.0), 1000.0 * 1001.0);
}

TEST_P(Pool, SeveralThreadsRunLoopsAtOnce) {
    // More threads than there is room for loops, each of which reads what its loop before wrote.
    static constexpr int kThreads = 7, kRuns = 400;
    std::vector<std::thread> threads;
    for (int thread = 0; thread < kThreads; ++thread)
        threads.emplace_back([this] {
            std::vector<int> values(16, 0);
            for (int run = 0; run < kRuns; ++run)
                pool_.run(values.size(), [&](std::size_t index, int) {
                    ASSERT_EQ(values[index], run);
                    values[index] = run + 1;
                });
            EXPECT_EQ(values, std::vector<int>(16, kRuns));
        });
    for (std::thread& thread : threads)
        thread.join();
}

TEST_P(Pool, NumbersOfWorkersBelongToTheirLoop) {
    // Plain counters, as above, while another loop is under way.
    std::atomic<bool> over = false;
    std::thread other([&] {
        while (!over)
            pool_.run(50, [](std::size_t, int) {});
    });
    for (int run = 0; run < 100; ++run) {
        std::vector<long> calls(static_cast<std::size_t>(pool_.thread_count()));
        pool_.run(200, [&](std::size_t, int worker) { ++calls.at(static_cast<std::size_t>(worker)); });
        EXPECT_EQ(std::accumulate(calls.begin(), calls.end(), 0L), 200);
    }
    over = true;
    other.join();
}

TEST_P(Pool, ALoopMayRunLoops) {
    std::vector<std::atomic<int>> calls(30 * 20);
    pool_.run(30, [&](std::size_t outer, int) {
        pool_.run(20, [&](std::size_t inner, int) { ++calls[20 * outer + inner]; });
    });
    for (const std::atomic<int>& count : calls)
        EXPECT_EQ(count, 1);
}

TEST_P(Pool, AFaultStaysWithItsLoop) {
    std::atomic<bool> over = false;
    std::thread broken([&] {
        while (!over)
            EXPECT_THROW(pool_.run(20, [](std::size_t, int) { throw std::runtime_error("broken"); }),
                         std::runtime_error);
    });
    for (int run = 0; run < 200; ++run) {
        std::atomic<int> calls = 0;
        EXPECT_NO_THROW(pool_.run(20, [&](std::size_t, int) { ++calls; }));
        EXPECT_EQ(calls, 20);
    }
    over = true;
    broken.join();
}

INSTANTIATE_TEST_SUITE_P(Threads, Pool, testing::Values(1, 2, 3, 4));

TEST(ThreadPool, TakesTheMachinesThreadsByDefault) {
    EXPECT_GE(ThreadPool().thread_count(), 1);
}

TEST(ThreadPool, MayBeMadeAndDroppedWithoutWork) {
    for (int i = 0; i < 50; ++i)
        const ThreadPool pool(4);
}

TEST(ThreadPool, TwoPoolsWorkSideBySide) {
    std::atomic<int> calls = 0;
    std::thread other([&] {
        ThreadPool pool(2);
        for (int run = 0; run < 200; ++run)
            pool.run(16, [&](std::size_t, int) { ++calls; });
    });
    ThreadPool pool(2);
    for (int run = 0; run < 200; ++run)
        pool.run(16, [&](std::size_t, int) { ++calls; });
    other.join();
    EXPECT_EQ(calls, 2 * 200 * 16);
}

}  // namespace
