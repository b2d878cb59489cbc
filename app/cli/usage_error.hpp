// A command line that cannot be carried out as it stands (exit status 2).
#pragma once

#include <stdexcept>

namespace pastoso::cli {

class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace pastoso::cli
