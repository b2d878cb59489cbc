// FFTW's plans and memory as objects, in single precision.
#pragma once

#include <fftw3.h>
#include <memory>
#include <mutex>
#include <type_traits>

namespace pastoso::liquid {

/// To be held while plans are made and destroyed: FFTW's planner serves one thread at a time. Plans that
/// are there may run on several.
inline std::mutex& fftw_planner() {
    static std::mutex mutex;
    return mutex;
}

struct FreeFftwPlan {
    void operator()(fftwf_plan plan) const {
        const std::lock_guard lock(fftw_planner());
        fftwf_destroy_plan(plan);
    }
};
using FftwPlan = std::unique_ptr<std::remove_pointer_t<fftwf_plan>, FreeFftwPlan>;

struct FreeFftwMemory {
    void operator()(void* memory) const { fftwf_free(memory); }
};
using FftwReals = std::unique_ptr<float[], FreeFftwMemory>;
using FftwComplexes = std::unique_ptr<fftwf_complex[], FreeFftwMemory>;

}  // namespace pastoso::liquid
