// docs/stroke-format.md tells of the version that is written.
#include "core/text_file.hpp"
#include "recordings/recording_json.hpp"
#include "source_file.hpp"

#include <gmock/gmock.h>

namespace pastoso::recordings {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(StrokeFormatPage, IsOfTheVersionThatIsWritten) {
    const std::string page = core::read_text_file(tests::source_file("docs/stroke-format.md"));
    const auto row = [](int version) { return "\n| " + std::to_string(version) + " | "; };
    EXPECT_THAT(page,
                HasSubstr("\n## JSON form, version " + std::to_string(kStrokeFormatVersion) + "\n"));
    EXPECT_THAT(page, HasSubstr(row(kStrokeFormatVersion)));
    EXPECT_THAT(page, Not(HasSubstr(row(kStrokeFormatVersion + 1))));
}

}  // namespace
}  // namespace pastoso::recordings
