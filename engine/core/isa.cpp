#include "core/isa.hpp"

#include "core/error.hpp"
#include "core/isa_request.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
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

constexpr Isa kAll[] = {Isa::Baseline, Isa::Avx2, Isa::Avx512};

/// Nothing where no set there is is asked for.
std::optional<Isa> requested_isa() {
    const char* request = std::getenv("PASTOSO_ISA");
    for (const Isa isa : kAll)
        if (request != nullptr && std::string_view(request) == name_of(isa)) return isa;
    return std::nullopt;
}

}  // namespace

Isa best_isa() {
    static const Isa isa = std::min(processor_isa(), requested_isa().value_or(Isa::Avx512));
    return isa;
}

const char* name_of(Isa isa) {
    switch (isa) {
        case Isa::Avx512: return "avx512";
        case Isa::Avx2: return "avx2";
        default: return "baseline";
    }
}

void check_isa_request() {
    const char* request = std::getenv("PASTOSO_ISA");
    if (request == nullptr || requested_isa()) return;
    throw InputError("PASTOSO_ISA is \"%1\", but there are baseline, avx2 and avx512.", request);
}

}  // namespace pastoso::core
