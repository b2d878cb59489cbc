#include "core/version.hpp"

#include "core/text_file.hpp"
#include "source_file.hpp"

#include <string>

#include <gmock/gmock.h>

namespace pastoso::core {
namespace {

TEST(Version, IsThatOfTheProject) {
    const std::string project = read_text_file(tests::source_file("CMakeLists.txt"));
    EXPECT_THAT(project, testing::HasSubstr(std::string("project(Pastoso VERSION ") + version() + " "));
}

}  // namespace
}  // namespace pastoso::core
