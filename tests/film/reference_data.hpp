// Results recorded with another implementation of the same model, and closed-form values beside them:
// tables in ../shared/reference/film next to the repository. Where the folder is absent, tests are
// skipped.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace pastoso::film::test {

std::string reference_path(const std::string& file);

/// One line of a CSV file by the names in its header.
class ReferenceRow {
  public:
    ReferenceRow(const std::vector<std::string>& names, const std::vector<std::string>& values);
    const std::string& text(const std::string& name) const;
    double number(const std::string& name) const;

  private:
    std::map<std::string, std::string> values_;
};

/// All lines of a table; empty when the file is absent.
std::vector<ReferenceRow> reference_table(const std::string& file);

}  // namespace pastoso::film::test

/// Reads a table into `rows`, or skips the test.
#define PASTOSO_REFERENCE_OR_SKIP(rows, file)                     \
    const auto rows = pastoso::film::test::reference_table(file); \
    if (rows.empty())                                             \
    GTEST_SKIP() << "The recorded results are not here: " << pastoso::film::test::reference_path(file)
