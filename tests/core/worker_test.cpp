#include "core/worker.hpp"

#include "core/error.hpp"

#include <filesystem>
#include <future>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::core {
namespace {

/// Notes numbers in the order in which they are done; the first waits until it is let go.
class Numbers : public testing::Test {
  protected:
    /// Returns once the first job is under way, so that all others wait.
    void begin() {
        worker_.add(0);
        begun_.get_future().wait();
    }
    std::vector<int> done() {
        go_.set_value();
        worker_.wait();
        return done_;
    }

    std::promise<void> begun_, go_;
    std::vector<int> done_;
    bool cancelled_ = false;
    Worker<int> worker_{[this](int& number) {
                            if (number == 0) {
                                begun_.set_value();
                                go_.get_future().wait();
                                cancelled_ = worker_.cancelled();
                            }
                            done_.push_back(number);
                        },
                        [](int&, const Message&) {}};
};

TEST_F(Numbers, AreDoneInTheirOrder) {
    begin();
    for (int number = 1; number < 50; ++number)
        worker_.add(number);
    const std::vector<int> numbers = done();
    ASSERT_EQ(numbers.size(), 50U);
    for (int number = 0; number < 50; ++number)
        EXPECT_EQ(numbers[number], number);
}

TEST_F(Numbers, TheLatestTakesThePlaceOfThoseThatWait) {
    begin();
    worker_.add(1);
    worker_.replace(2);
    worker_.replace(3);
    EXPECT_EQ(done(), (std::vector{0, 3}));
}

TEST_F(Numbers, ThoseThatWaitCanBeChanged) {
    begin();
    worker_.add(1);
    worker_.change([](std::deque<int>& waiting) { waiting.push_front(2); });
    EXPECT_EQ(done(), (std::vector{0, 2, 1}));
}

TEST_F(Numbers, DroppedOnesAreNotDone) {
    begin();
    worker_.add(1);
    worker_.drop();
    EXPECT_EQ(done(), std::vector{0});
    EXPECT_FALSE(cancelled_);
}

TEST_F(Numbers, CancellingAsksTheOneUnderWayAlone) {
    begin();
    worker_.add(1);
    worker_.cancel();
    worker_.add(2);
    EXPECT_EQ(done(), (std::vector{0, 2}));
    EXPECT_TRUE(cancelled_);
    EXPECT_FALSE(worker_.cancelled());
}

TEST_F(Numbers, KeepItBusyUntilTheyAreDone) {
    EXPECT_FALSE(worker_.busy());
    worker_.wait();
    begin();
    EXPECT_TRUE(worker_.busy());
    done();
    EXPECT_FALSE(worker_.busy());
}

TEST(Worker, CancelsTheJobUnderWayAtItsEndAndDropsTheOthers) {
    std::promise<void> begun;
    std::vector<int> done;
    {
        Worker<int> worker(
            [&](int& number) {
                if (number == 0) begun.set_value();
                while (!worker.cancelled())
                    std::this_thread::yield();
                done.push_back(number);
            },
            [](int&, const Message&) {});
        worker.add(0);
        worker.add(1);
        begun.get_future().wait();
    }
    EXPECT_EQ(done, std::vector{0});
}

TEST(Worker, HasFreedAJobOnceItIsDone) {
    using Shared = std::shared_ptr<int>;
    Worker<Shared> worker([](Shared&) {}, [](Shared&, const Message&) {});
    const auto held = std::make_shared<int>(1);
    worker.add(held);
    worker.wait();
    EXPECT_EQ(held.use_count(), 1);
}

TEST(Worker, TellsWhatJobsThrowAndGoesOn) {
    using Job = std::function<void()>;
    std::vector<std::string> told;
    bool last_done = false;
    Worker<Job> worker([](Job& job) { job(); },
                       [&](Job&, const Message& sentence) { told.push_back(sentence.text()); });
    worker.add([] { throw InputError("a.png: no picture."); });
    worker.add([] { throw std::bad_alloc(); });
    worker.add([] { std::filesystem::create_directory("/missing/more"); });
    worker.add([] { throw std::runtime_error("broken"); });
    worker.add([] { throw 7; });
    worker.add([&] { last_done = true; });
    worker.wait();
    EXPECT_EQ(told, (std::vector<std::string>{
                        "a.png: no picture.",
                        "memory ran out: what was asked for last is not done, or not whole.",
                        "/missing/more: the system refuses this (No such file or directory).",
                        "something went wrong within the program (broken).",
                        "something went wrong within the program (an exception of an unknown kind)."}));
    EXPECT_TRUE(last_done);
}

TEST(Worker, OutlivesWhoCannotEvenTell) {
    bool done = false;
    Worker<int> worker(
        [&](int& number) {
            if (number == 0) throw 7;
            done = true;
        },
        [](int&, const Message&) { throw std::bad_alloc(); });
    worker.add(0);
    worker.add(1);
    worker.wait();
    EXPECT_TRUE(done);
}

TEST(Thread, TellsWhatEndedIt) {
    std::string told;
    Thread thread([] { throw InputError("a.png: no picture."); },
                  [&](const Message& sentence) { told = sentence.text(); });
    thread.join();
    EXPECT_FALSE(thread.exists());
    EXPECT_EQ(told, "a.png: no picture.");
}

}  // namespace
}  // namespace pastoso::core
