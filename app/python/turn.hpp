// Who computes: one Python thread at a time for each object, while all others go on.
#pragma once

#include "core/error.hpp"
#include "core/failed_check.hpp"
#include "core/fault.hpp"

#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include <pybind11/pybind11.h>

namespace pastoso::python {

/// Hears of Ctrl+C while the engine computes. Of one call.
class Interruption {
  public:
    /// Whether Python has raised something; asks it 20 times a second at most.
    bool wanted();

    /// Throws what Python has raised, where it has.
    void rethrow() const {
        if (raised_) throw *raised_;
    }

  private:
    std::chrono::steady_clock::time_point asked_ = std::chrono::steady_clock::now();
    std::optional<pybind11::error_already_set> raised_;
};

/// Beside what an object of Python's holds of the engine.
class Turn {
  public:
    /// Calls work() without Python's lock, when no other thread is within one of the same object. What
    /// fails in the middle leaves something half done: the object then refuses all further work, by the
    /// same sentence.
    template <class Work>
    auto take(Work&& work) {
        const pybind11::gil_scoped_release released;
        const std::lock_guard lock(mutex_);
        if (!fault_.empty()) throw core::BrokenInvariant(fault_);
        try {
            return std::forward<Work>(work)();
        } catch (const core::InputError&) {
            throw;
        } catch (const pybind11::error_already_set&) {
            throw;
        } catch (const core::BrokenInvariant& error) {
            fault_ = error.what();
            throw;
        } catch (...) {
            fault_ = core::caught_fault().text();
            throw;
        }
    }

  private:
    std::mutex mutex_;
    std::string fault_;
};

}  // namespace pastoso::python
