#include "core/thread.hpp"

#include <sys/resource.h>
#include <unistd.h>
#include <utility>

namespace pastoso::core {

void lower_priority(int nice) {
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), nice);
}

Thread::Thread(std::function<void()> body, Tell tell)
    : thread_([body = std::move(body), tell = std::move(tell)] { guarded(body, tell); }) {}

void Thread::join() {
    if (thread_.joinable()) thread_.join();
}

}  // namespace pastoso::core
