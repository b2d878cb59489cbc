#include "python/pools.hpp"

#include "core/thread_count.hpp"
#include "document/actions/field_checks.hpp"

#include <map>

namespace pastoso::python {

std::shared_ptr<core::ThreadPool> pool_of(int threads) {
    document::check_between("number of threads", "", threads, 0, 256);
    static std::map<int, std::weak_ptr<core::ThreadPool>> pools;
    const int count = threads == 0 ? core::default_thread_count() : threads;
    std::shared_ptr<core::ThreadPool> pool = pools[count].lock();
    if (!pool) {
        pool = std::make_shared<core::ThreadPool>(count);
        pools[count] = pool;
    }
    return pool;
}

}  // namespace pastoso::python
