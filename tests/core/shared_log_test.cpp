// A list that only grows: whole after any number of values, copies apart from what comes later.
#include "core/shared_log.hpp"

#include <string>

#include <gtest/gtest.h>

namespace pastoso::core {
namespace {

using Log = SharedLog<std::string, 4>;

Log log_of(int count) {
    Log log;
    for (int i = 0; i < count; ++i)
        log.add(std::to_string(i));
    return log;
}

TEST(SharedLog, HoldsWhatWasAddedInItsOrder) {
    for (const int count : {0, 1, 3, 4, 5, 8, 13}) {
        const Log log = log_of(count);
        ASSERT_EQ(log.size(), static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i)
            EXPECT_EQ(log[i], std::to_string(i));
    }
}

TEST(SharedLog, ACopyStaysWhatItIsWhileTheOtherGrows) {
    for (const int count : {0, 3, 4, 6}) {
        Log log = log_of(count);
        Log copy = log;
        for (int i = 0; i < 9; ++i)
            log.add("later");
        EXPECT_EQ(copy.size(), static_cast<std::size_t>(count));
        copy.add("other");
        EXPECT_EQ(copy[count], "other");
        EXPECT_EQ(log[count], "later");
    }
}

TEST(SharedLog, CopiesShareFullBlocks) {
    const Log log = log_of(6);
    const Log copy = log;
    EXPECT_EQ(&copy[3], &log[3]);
    EXPECT_NE(&copy[4], &log[4]);
}

TEST(SharedLogDeathTest, NothingLiesBehindItsEnd) {
    const Log log = log_of(4);
    EXPECT_DEATH(log[4], "index");
}

}  // namespace
}  // namespace pastoso::core
