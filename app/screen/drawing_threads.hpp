// The threads that all views draw with.
#pragma once

#include "core/thread_pool.hpp"

namespace pastoso::screen {

/// One for each processor, which come with the first loop and go with the program. Paint has threads of
/// its own: they give way to these, and no thread can take back that it gives way.
core::ThreadPool& drawing_threads();

}  // namespace pastoso::screen
