// Results recorded with another implementation of the same model, and closed-form values beside them:
// the tables in tests/data/film.
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

/// All lines of a table. Throws core::InputError when there is none.
std::vector<ReferenceRow> reference_table(const std::string& file);

}  // namespace pastoso::film::test
