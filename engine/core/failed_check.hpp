// What comes of a check that failed (check.hpp).
#pragma once

#include <stdexcept>

namespace pastoso::core {

/// For the report of a crash: what the check that failed has printed; empty while none has. May be
/// called within a signal.
const char* failed_check();

/// What failed checks throw after throw_failed_checks(): what they would have printed. Whatever was
/// being changed is not to be used any more.
class BrokenInvariant : public std::logic_error {
  public:
    using std::logic_error::logic_error;
};

/// From now on checks that fail throw, on all threads, and do not abort: for programs of others that the
/// engine is only a part of.
void throw_failed_checks();

}  // namespace pastoso::core
