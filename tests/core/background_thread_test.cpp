#include "core/background_thread.hpp"

#include <atomic>
#include <chrono>
#include <future>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::core {
namespace {

TEST(BackgroundThread, DoesJobsInTheirOrder) {
    std::vector<int> done;
    std::atomic<bool> all_done = false;
    BackgroundThread thread;
    for (int job = 0; job < 100; ++job)
        thread.add([&done, job] { done.push_back(job); });
    thread.add([&all_done] {
        all_done = true;
        all_done.notify_all();
    });
    all_done.wait(false);
    ASSERT_EQ(done.size(), 100U);
    for (int job = 0; job < 100; ++job)
        EXPECT_EQ(done[job], job);
}

TEST(BackgroundThread, EndsWithoutEverHavingAJob) {
    const BackgroundThread thread;
}

TEST(BackgroundThread, WaitsForTheJobUnderWayAtItsEnd) {
    std::atomic<bool> begun = false, done = false;
    {
        BackgroundThread thread;
        thread.add([&] {
            begun = true;
            begun.notify_all();
            std::this_thread::yield();
            done = true;
        });
        begun.wait(false);
    }
    EXPECT_TRUE(done);
}

TEST(BackgroundThread, JobsRestWhileItIsHeld) {
    BackgroundThread thread;
    std::promise<void> done;
    std::future<void> end = done.get_future();
    {
        const BackgroundThread::Hold one(thread), another(thread);
        thread.add([&] {
            thread.rest_while_held();
            done.set_value();
        });
        EXPECT_EQ(end.wait_for(std::chrono::milliseconds(20)), std::future_status::timeout);
    }
    end.get();
}

}  // namespace
}  // namespace pastoso::core
