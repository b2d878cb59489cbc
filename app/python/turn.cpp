#include "python/turn.hpp"

namespace pastoso::python {

bool Interruption::wanted() {
    constexpr std::chrono::milliseconds kBetween{50};
    if (raised_) return true;
    const auto now = std::chrono::steady_clock::now();
    if (now - asked_ < kBetween) return false;
    asked_ = now;
    const pybind11::gil_scoped_acquire acquired;
    if (PyErr_CheckSignals() != 0) raised_.emplace();
    return raised_.has_value();
}

}  // namespace pastoso::python
