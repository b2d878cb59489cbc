// For the report of a crash.
#pragma once

namespace pastoso::core {

/// What the check that failed (check.hpp) has printed; empty while none has. May be called within a signal.
const char* failed_check();

}  // namespace pastoso::core
