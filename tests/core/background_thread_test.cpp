#include "core/background_thread.hpp"

#include <atomic>
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
    std::atomic<bool> begun = false, may_go_on = false;
    std::promise<bool> rested;
    std::future<bool> end = rested.get_future();
    {
        const BackgroundThread::Hold one(thread);
        {
            const BackgroundThread::Hold another(thread);
            thread.add([&] {
                begun = true;
                begun.notify_all();
                thread.rest_while_held();
                rested.set_value(may_go_on.load());
            });
            begun.wait(false);
        }
        // The job has every opportunity to go on too early.
        for (int turn = 0; turn < 1000; ++turn)
            std::this_thread::yield();
        may_go_on = true;
    }
    EXPECT_TRUE(end.get());
}

}  // namespace
}  // namespace pastoso::core
