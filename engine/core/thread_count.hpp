// How many threads a pool takes that is not told a number.
#pragma once

namespace pastoso::core {

/// One per processor, at least one.
int processor_count();

/// What set_default_thread_count() said, or else processor_count().
int default_thread_count();

/// For pools made from now on; 0: one per processor. Results do not depend on it.
void set_default_thread_count(int count);

}  // namespace pastoso::core
