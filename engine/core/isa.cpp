#include "core/isa.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace pastoso::core {
namespace {

Isa processor_isa() {
// Clang knows these names from version 18 on.
#if defined(__x86_64__) && !defined(__clang__)
    if (__builtin_cpu_supports("x86-64-v4")) return Isa::Avx512;
    if (__builtin_cpu_supports("x86-64-v3")) return Isa::Avx2;
#endif
    return Isa::Baseline;
}

Isa requested_isa() {
    const char* request = std::getenv("PASTOSO_ISA");
    if (request == nullptr) return Isa::Avx512;
    if (std::string_view(request) == "baseline") return Isa::Baseline;
    if (std::string_view(request) == "avx2") return Isa::Avx2;
    return Isa::Avx512;
}

}  // namespace

Isa best_isa() {
    static const Isa isa = std::min(processor_isa(), requested_isa());
    return isa;
}

const char* name_of(Isa isa) {
    switch (isa) {
        case Isa::Avx512: return "avx512";
        case Isa::Avx2: return "avx2";
        default: return "baseline";
    }
}

}  // namespace pastoso::core
