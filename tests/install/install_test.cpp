// `cmake --install`, as packages use it.
#include "core/text_file.hpp"
#include "install/installed.hpp"

#include <algorithm>
#include <regex>

#include <gmock/gmock.h>

namespace pastoso::install {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

TEST_F(Installed, PaintsWhereverItIsMoved) {
    install(folder / "moved");
    const std::string program = path("moved/bin/pastoso-cli");
    const std::vector<std::string> painting =
        cli::small({"replay", short_recording(), "-q", "-o", path("here.png")});
    const cli::RunResult here = run(program, painting);
    ASSERT_EQ(here.status, 0) << here.errors;
    std::vector<std::string> again = painting;
    std::replace(again.begin(), again.end(), path("here.png"), path("built.png"));
    ASSERT_EQ(cli::run_cli(again).status, 0);
    EXPECT_EQ(core::read_text_file(path("here.png")), core::read_text_file(path("built.png")));
    // The module that other formats come with, and what scenes are found by.
    EXPECT_EQ(run(program, cli::small({"replay", short_recording(), "-q", "-o", path("a.webp")})).status,
              0);
    EXPECT_THAT(run(program, {"simulate", "--help"}).output, HasSubstr("paper-fig2"));
}

/// A file that no component has would be in no package.
TEST_F(Installed, EveryFileIsOfOneComponent) {
    install(folder / "all");
    std::set<std::string> together;
    std::size_t count = 0;
    for (const char* component : {"cli", "window", "docs", "development", "python"}) {
        install(folder / component, {component});
        const std::set<std::string> files = files_below(folder / component);
        count += files.size();
        together.insert(files.begin(), files.end());
    }
    EXPECT_EQ(together, files_below(folder / "all"));
    EXPECT_EQ(count, together.size()) << "components share a file";
}

TEST_F(Installed, HasProgramsDataPagesAndNoSources) {
    install(folder / "moved");
    for (const char* file :
         {"bin/pastoso-cli", "lib/pastoso/pastoso-images.so", "share/pastoso/pigments/pigments.csv",
          "share/pastoso/strokes/still-life.json", "share/man/man1/pastoso-cli.1",
          "share/bash-completion/completions/pastoso-cli", "share/zsh/site-functions/_pastoso-cli",
          "share/doc/pastoso/docs/manual/README.md"})
        EXPECT_TRUE(fs::is_regular_file(folder / "moved" / file)) << file;
    const std::set<std::string> files = files_below(folder / "moved");
    for (const std::string& file : files) {
        if (file.starts_with("share/doc/pastoso/example/")) continue;
        EXPECT_FALSE(file.ends_with(".cpp") || file.ends_with("CMakeLists.txt") || file.ends_with(".ts"))
            << file;
    }
}

/// packaging/example, built far from the source tree.
TEST_F(Installed, ProgramsOfOthersAreBuiltWithTheEngine) {
    install(folder / "moved", {"cli", "development"});
    const std::string example = path("moved/share/doc/pastoso/example"), built = path("example");
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"-S", example, "-B", built, "-D",
                                   "CMAKE_PREFIX_PATH=" + path("moved")},
          {"--build", built}}) {
        const cli::RunResult made = run(PASTOSO_CMAKE, words);
        ASSERT_EQ(made.status, 0) << made.output << made.errors;
    }
    const cli::RunResult painted = run("/usr/bin/env", {"-C", built, "ctest", "--output-on-failure"});
    EXPECT_EQ(painted.status, 0) << painted.output;
    EXPECT_TRUE(fs::exists(folder / "example" / "stroke.png"));
}

/// Pages that are read where they are installed; what lies in the source tree alone is left out.
TEST_F(Installed, PagesLinkToPagesThatAreThere) {
    install(folder / "moved", {"docs"});
    static const std::regex kLink("\\]\\(([^)#:]+)(#[^)]*)?\\)");
    const fs::path docs = folder / "moved" / "share" / "doc" / "pastoso";
    int links = 0;
    for (const std::string& file : files_below(docs)) {
        if (!file.ends_with(".md")) continue;
        const std::string text = core::read_text_file(docs / file);
        for (std::sregex_iterator link(text.begin(), text.end(), kLink), end; link != end; ++link) {
            const fs::path target = (docs / file).parent_path() / (*link)[1].str();
            const std::string place = fs::weakly_canonical(target).lexically_relative(docs).string();
            if (place.starts_with("resources") || place.starts_with("tests") ||
                place.starts_with("packaging"))
                continue;
            ++links;
            EXPECT_TRUE(fs::exists(target)) << file << ": " << (*link)[1];
        }
    }
    EXPECT_GT(links, 100);
}

}  // namespace
}  // namespace pastoso::install
