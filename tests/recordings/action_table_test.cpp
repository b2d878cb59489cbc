// What is told of actions outside the code is what their tables say.
#include "recordings/action_table.hpp"

#include "core/text_file.hpp"
#include "source_file.hpp"

#include <gmock/gmock.h>

namespace pastoso::recordings {
namespace {

TEST(ActionTable, IsOnThePageOfTheFormat) {
    EXPECT_THAT(core::read_text_file(tests::source_file("docs/stroke-format.md")),
                testing::HasSubstr("\n\n" + action_table() + "\n"))
        << "put what write_action_table prints onto the page";
}

TEST(ActionTable, IsTheDictionaryOfTheFuzzer) {
    EXPECT_EQ(core::read_text_file(tests::source_file("tests/fuzz/strokes.dict")), action_dictionary())
        << "write_action_table --dictionary > tests/fuzz/strokes.dict";
}

}  // namespace
}  // namespace pastoso::recordings
