// What two windows remember, put together.
#include "tools/memory_merge.hpp"

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

using files::Json;

Json json(const char* text) {
    return files::parse_json(text, "test");
}

TEST(MemoryMerge, WhatOneHasChangedIsTaken) {
    const Json before = json(R"({"a": 1, "b": {"c": 2, "d": 3}})");
    const Json mine = json(R"({"a": 5, "b": {"c": 2, "d": 3}})");
    const Json theirs = json(R"({"a": 1, "b": {"c": 2, "d": 7}, "e": 9})");
    EXPECT_EQ(merged(before, mine, theirs), json(R"({"a": 5, "b": {"c": 2, "d": 7}, "e": 9})"));
    EXPECT_EQ(merged(before, before, theirs), theirs);
    EXPECT_EQ(merged(before, mine, before), mine);
    EXPECT_EQ(merged(before, mine, mine), mine);
}

TEST(MemoryMerge, WhereBothHaveChangedTheSameItIsMine) {
    EXPECT_EQ(merged(json("[1, 2]"), json("[2, 1]"), json("[1, 2, 3]")), json("[2, 1]"));
    EXPECT_EQ(merged(json(R"({"a": 1})"), json(R"({"a": 2})"), json(R"({"a": 3})")),
              json(R"({"a": 2})"));
    EXPECT_EQ(merged(Json(), json(R"({"a": 2})"), json(R"({"a": 3, "b": 4})")),
              json(R"({"a": 2, "b": 4})"));
}

TEST(MemoryMerge, WordsAreAddedAndTakenAwayByBoth) {
    const Json before = json(R"(["a", "b", "c"])");
    const Json mine = json(R"(["a", "c", "mine"])");
    const Json theirs = json(R"(["theirs", "b", "a"])");
    EXPECT_EQ(merged(before, mine, theirs), json(R"(["a", "mine", "theirs"])"));
    EXPECT_EQ(merged(before, theirs, mine), json(R"(["theirs", "a", "mine"])"));
}

TEST(MemoryMerge, NamedOnesAreTheSameByTheirNames) {
    const Json before = json(R"([{"name": "sea", "tubes": ["x"]}, {"name": "sky", "tubes": ["y"]}])");
    const Json mine = json(R"([{"name": "sea", "tubes": ["x", "m"]}, {"name": "sky", "tubes": ["y"]}])");
    const Json theirs = json(R"([{"name": "sea", "tubes": ["t", "x"]}, {"name": "hay", "tubes": []}])");
    EXPECT_EQ(merged(before, mine, theirs),
              json(R"([{"name": "sea", "tubes": ["x", "m", "t"]}, {"name": "hay", "tubes": []}])"));
}

TEST(MemoryMerge, WhatOneRemovedAndTheOtherChangedStays) {
    const Json before = json(R"({"list": [{"name": "a", "n": 1}], "k": 1})");
    const Json mine = json(R"({"list": [{"name": "a", "n": 2}], "k": 2})");
    const Json theirs = json(R"({"list": []})");
    EXPECT_EQ(merged(before, mine, theirs), mine);
}

}  // namespace
}  // namespace pastoso::tools
