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

/// peak_memory_bytes() in MiB.
double peak_rss_mib();

/// From now on the process keeps up to 512 MiB that were freed for what it allocates next,
/// instead of handing it back to the machine at once: tiles come and go by the megabyte, and new pages
/// cost more than what is done with them. For a whole program, at its start.
void keep_freed_memory();

}  // namespace pastoso::core
