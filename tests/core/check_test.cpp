#include "core/check.hpp"

#include "core/error.hpp"
#include "core/failed_check.hpp"

#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

namespace {

TEST(CheckDeathTest, NamesTheExpressionThatFailed) {
    const int cells = 3;
    EXPECT_DEATH(PASTOSO_CHECK(cells == 4), "check_test.cpp:[0-9]+: broken invariant: cells == 4");
}

TEST(CheckDeathTest, PrintsBothValues) {
    const int cells = 3;
    EXPECT_DEATH(PASTOSO_CHECK_OP(cells, >=, 4), "broken invariant: cells >= 4 \\(3 against 4\\)");
}

/// In a process of its own: nothing takes it back.
TEST(CheckDeathTest, ThrowsWhereThatWasAskedFor) {
    const auto caught = [] {
        pastoso::core::throw_failed_checks();
        try {
            PASTOSO_CHECK_OP(3, >=, 4);
        } catch (const pastoso::core::BrokenInvariant& error) {
            std::fprintf(stderr, "caught %s", error.what());
            std::exit(3);
        }
    };
    EXPECT_EXIT(caught(), testing::ExitedWithCode(3),
                "caught .*broken invariant: 3 >= 4 \\(3 against 4\\)");
}

TEST(Check, EvaluatesItsOperandsOnce) {
    int calls = 0;
    PASTOSO_CHECK_OP(++calls, ==, 1);
    EXPECT_EQ(calls, 1);
}

TEST(InputError, NamesFileAndLine) {
    EXPECT_STREQ(pastoso::core::located_error("a.txt", 7, "x is -1.").what(), "a.txt, line 7: x is -1.");
    EXPECT_STREQ(pastoso::core::located_error("a.txt", 0, "is empty.").what(), "a.txt: is empty.");
}

}  // namespace
