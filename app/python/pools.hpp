// Threads that objects of Python's compute with.
#pragma once

#include "core/thread_pool.hpp"

#include <memory>

namespace pastoso::python {

/// A pool of so many threads, 0 for one per processor; objects that ask for the same number share it. To
/// be called with Python's lock. Throws InputError unless the number is 0 to 256.
std::shared_ptr<core::ThreadPool> pool_of(int threads);

}  // namespace pastoso::python
