// How much memory this machine and this process have.
#pragma once

#include <cstddef>

namespace pastoso::core {

/// What programs can still get from this machine (MemAvailable); SIZE_MAX where it is not told.
std::size_t available_memory_bytes();

/// What this process holds at present in the machine's memory, and what it held at most; 0 where it is
/// not told.
std::size_t resident_memory_bytes();
std::size_t peak_memory_bytes();

}  // namespace pastoso::core
