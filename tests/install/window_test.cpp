#include "core/text_file.hpp"
#include "install/installed.hpp"

#include <gmock/gmock.h>

namespace pastoso::install {
namespace {

TEST_F(Installed, TheWindowOpensWhereverItIsMoved) {
    install(folder / "moved");
    const cli::RunResult result =
        run(path("moved/bin/pastoso"), {"--screenshot", path("window.png"), "--after", "0.2"});
    EXPECT_EQ(result.status, 0) << result.errors;
    EXPECT_EQ(result.errors, "");
    EXPECT_THAT(core::read_text_file(path("window.png")), testing::StartsWith("\x89PNG"));
}

}  // namespace
}  // namespace pastoso::install
