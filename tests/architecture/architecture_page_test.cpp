// The reader of ARCHITECTURE.md, on small pages and on those that say something wrong.
#include "architecture/architecture_page.hpp"

#include "core/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::tests {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string kFolders =
    "# A page\n"
    "| level | folder | is | may use |\n"
    "| --- | --- | --- | --- |\n"
    "| 0 | `engine/core` | what is below all | - |\n"
    "| 1 | `engine/grid` | fields | core |\n"
    "| - | `app/cli` | a program | engine |\n"
    "| a | `app/tools`, `app/commands` | pens; keys | grid |\n"
    "| b | `app/main` | the window | all of app but cli |\n";
const std::string kLibraries =
    "\nBetween the tables.\n\n"
    "| library | headers | known to |\n"
    "| --- | --- | --- |\n"
    "| zstd | `zstd.h` | grid |\n"
    "| Qt | `Q*`, `q*.h` | all of app but tools and cli |\n";

ArchitecturePage with_row(const std::string& row) {
    return read_architecture_page(kFolders + row + "\n" + kLibraries);
}

std::string error_of_row(const std::string& row) {
    try {
        with_row(row);
    } catch (const core::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(ArchitecturePage, FoldersMayUseWhatTheirRowsNameAndWhatThoseNameInTurn) {
    const ArchitecturePage page = read_architecture_page(kFolders + kLibraries);
    EXPECT_EQ(page.folders.size(), 6U);
    EXPECT_EQ(page.folders.at("core").may_use, Folders{});
    EXPECT_EQ(page.folders.at("cli").may_use, (Folders{"core", "grid"}));
    EXPECT_EQ(page.folders.at("commands").may_use, (Folders{"core", "grid"}));
    EXPECT_EQ(page.folders.at("main").named, (Folders{"commands", "tools"}));
    EXPECT_EQ(page.folders.at("main").may_use, (Folders{"commands", "core", "grid", "tools"}));
    EXPECT_EQ(page.folders.at("main").line, 8);
}

TEST(ArchitecturePage, LibrariesAreKnownToThoseTheirRowsName) {
    const ArchitecturePage page = read_architecture_page(kFolders + kLibraries);
    ASSERT_EQ(page.libraries.size(), 2U);
    EXPECT_EQ(page.libraries[0].known_to, Folders{"grid"});
    EXPECT_EQ(page.libraries[1].name, "Qt");
    EXPECT_THAT(page.libraries[1].headers, ElementsAre("Q*", "q*.h"));
    EXPECT_EQ(page.libraries[1].known_to, (Folders{"commands", "main"}));
}

TEST(ArchitecturePage, RowsAndFoldersMeet) {
    const ArchitecturePage page = with_row("| 2 | `engine/plasma` | hot | grid |");
    const std::vector<std::string> present = {"engine/core", "engine/grid",  "engine/foam", "app/cli",
                                              "app/tools",   "app/commands", "app/main"};
    EXPECT_THAT(folder_violations(page, present),
                ElementsAre("ARCHITECTURE.md, line 9: there is no folder engine/plasma",
                            "engine/foam: the folder has no row in the table of ARCHITECTURE.md"));
    EXPECT_THAT(folder_violations(page, {"engine/core", "engine/grid", "engine/plasma", "app/cli",
                                         "app/tools", "app/commands", "app/main"}),
                IsEmpty());
}

TEST(ArchitecturePage, NamesTheLineOfARowThatIsWrong) {
    EXPECT_EQ(error_of_row("| 2 | `engine/film` | paint | core, gird |"),
              "ARCHITECTURE.md, line 9: gird has no row in the table");
    EXPECT_EQ(error_of_row("| 2 | `engine/film` | core |"),
              "ARCHITECTURE.md, line 9: the row has 3 cells, its table 4");
    EXPECT_EQ(error_of_row("| 2 | engine/film | paint | core |"),
              "ARCHITECTURE.md, line 9: \"engine/film\" does not stand between ` and `");
    EXPECT_EQ(error_of_row("| 2 | `tests/film` | paint | core |"),
              "ARCHITECTURE.md, line 9: tests/film lies neither in engine nor in app");
    EXPECT_EQ(error_of_row("| low | `engine/film` | paint | core |"),
              "ARCHITECTURE.md, line 9: \"low\" is no level");
    EXPECT_EQ(error_of_row("| a | `app/grid` | lines | core |"),
              "ARCHITECTURE.md, line 9: app/grid has the name of engine/grid in line 5");
    EXPECT_EQ(error_of_row("| c | `app/view` | canvas | all of apps |"),
              "ARCHITECTURE.md, line 9: \"apps\" is neither engine nor app");
}

TEST(ArchitecturePage, RefusesARowThatDoesNotPointDown) {
    EXPECT_EQ(
        error_of_row("| 1 | `engine/film` | paint | grid |"),
        "ARCHITECTURE.md, line 9: engine/film may not name engine/grid, which is not on a lower level");
    EXPECT_EQ(
        error_of_row("| 2 | `engine/film` | paint | tools |"),
        "ARCHITECTURE.md, line 9: engine/film may not name app/tools, which is not on a lower level");
    EXPECT_NE(error_of_row("| - | `app/view` | canvas | screens |\n| - | `app/screens` | more | view |")
                  .find("uses itself"),
              std::string::npos);
}

TEST(ArchitecturePage, RefusesAPageWithoutItsTables) {
    EXPECT_THROW(read_architecture_page(kFolders), core::InputError);
    EXPECT_THROW(read_architecture_page(kLibraries), core::InputError);
}

}  // namespace
}  // namespace pastoso::tests
