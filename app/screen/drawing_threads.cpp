#include "screen/drawing_threads.hpp"

namespace pastoso::screen {

core::ThreadPool& drawing_threads() {
    static core::ThreadPool threads;
    return threads;
}

}  // namespace pastoso::screen
