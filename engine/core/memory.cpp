#include "core/memory.hpp"

#include <cstdint>
#include <fstream>
#include <malloc.h>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace pastoso::core {

std::size_t available_memory_bytes() {
    std::ifstream stream("/proc/meminfo");
    std::string key;
    std::size_t kibibytes = 0;
    std::string unit;
    while (stream >> key >> kibibytes) {
        if (key == "MemAvailable:") return kibibytes * 1024;
        std::getline(stream, unit);
    }
    return SIZE_MAX;
}

std::size_t resident_memory_bytes() {
    std::ifstream stream("/proc/self/statm");
    std::size_t total_pages = 0, resident_pages = 0;
    if (!(stream >> total_pages >> resident_pages)) return 0;
    return resident_pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

std::size_t peak_memory_bytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

double peak_rss_mib() {
    return static_cast<double>(peak_memory_bytes()) / (1 << 20);
}

void keep_freed_memory() {
    constexpr int kMiB = 1 << 20;
    // A canvas of 4096 x 4096 cells that flows all over frees 200 MB in each step.
    ::mallopt(M_TRIM_THRESHOLD, 512 * kMiB);
    ::mallopt(M_MMAP_THRESHOLD, 32 * kMiB);
    // What one thread frees another can take.
    ::mallopt(M_ARENA_MAX, 1);
}

}  // namespace pastoso::core
