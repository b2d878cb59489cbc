#include "cli/run_program.hpp"
#include "core/text_file.hpp"
#include "film/validation/case.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include <gmock/gmock.h>

namespace pastoso::cli {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class CliValidate : public CliTest {
  protected:
    std::string text(const std::string& name) const { return core::read_text_file(path(name)); }
};

TEST_F(CliValidate, ListsEveryCaseWithItsLaw) {
    const RunResult run = run_cli({"validate", "--list"});
    EXPECT_EQ(run.status, 0) << run.errors;
    for (const film::validation::Case& known : film::validation::cases()) {
        EXPECT_THAT(run.output, HasSubstr(known.name + "\n    " + known.law + "\n    " + known.source));
        EXPECT_EQ(known.cells_mm.size(), 3U) << known.name;
        EXPECT_TRUE(std::is_sorted(known.cells_mm.rbegin(), known.cells_mm.rend())) << known.name;
    }
}

TEST_F(CliValidate, CaseNamesAreUnique) {
    std::set<std::string> names;
    for (const film::validation::Case& known : film::validation::cases())
        EXPECT_TRUE(names.insert(known.name).second) << known.name;
    EXPECT_GE(names.size(), 17U);
}

TEST_F(CliValidate, ACaseComesAsATableAndAPlot) {
    const RunResult run = run_cli(
        {"validate", "nusselt-film", "--scheme", "large", "-o", path("out"), "-q", "--threads", "1"});
    ASSERT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(run.errors, "");
    EXPECT_THAT(run.output, StartsWith("case          quantity"));
    std::istringstream lines(text("out/validation.csv"));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "case,quantity,scheme,cell_mm,angle_deg,measured,exact,error_percent,at_least");
    int rows = 0;
    for (; std::getline(lines, line); ++rows)
        EXPECT_THAT(line, StartsWith("nusselt-film,\"speed, alpha "));
    EXPECT_EQ(rows, 2 * 3 * 3);  // two figures at three cell sizes and three angles
    EXPECT_THAT(text("out/nusselt-film.svg"), StartsWith("<svg xmlns=\"http://www.w3.org/2000/svg\""));
}

TEST_F(CliValidate, ThreadsDoNotShow) {
    for (const char* threads : {"1", "2"})
        ASSERT_EQ(run_cli({"validate", "bingham-film", "--scheme", "explicit", "-o", path(threads), "-q",
                           "--threads", threads})
                      .status,
                  0);
    EXPECT_EQ(text("1/validation.csv"), text("2/validation.csv"));
    EXPECT_EQ(text("1/bingham-film.svg"), text("2/bingham-film.svg"));
}

TEST_F(CliValidate, UnknownCasesAreRefusedBeforeAnythingRuns) {
    const RunResult run = run_cli({"validate", "nusselt-film", "soup", "-o", path("out")});
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(run.output, "");
    EXPECT_THAT(run.errors, StartsWith("pastoso-cli: There is no case \"soup\", only nusselt-film, "));
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1);
    EXPECT_FALSE(std::filesystem::exists(path("out")));
}

TEST_F(CliValidate, LongRunsAreAskedFor) {
    const RunResult run = run_cli({"validate", "fingers"});
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(run.output, "");
    EXPECT_EQ(run.errors,
              "pastoso-cli: All runs of these cases take minutes: --long carries them out.\n");
}

}  // namespace
}  // namespace pastoso::cli
