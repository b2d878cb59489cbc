#include "core/thread_count.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <atomic>
#include <thread>

namespace pastoso::core {
namespace {

std::atomic<int>& chosen_count() {
    static std::atomic<int> count = 0;
    return count;
}

}  // namespace

int processor_count() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

int default_thread_count() {
    const int chosen = chosen_count();
    return chosen > 0 ? chosen : processor_count();
}

void set_default_thread_count(int count) {
    PASTOSO_CHECK_OP(count, >=, 0);
    chosen_count() = count;
}

}  // namespace pastoso::core
