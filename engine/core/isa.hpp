// Which instruction set the hot kernels use. They are compiled once per set (pastoso_add_kernels in
// packaging/cmake) and give the same bits in every one of them.
#pragma once

namespace pastoso::core {

enum class Isa { Baseline, Avx2, Avx512 };

/// The widest set this processor has. The environment variable PASTOSO_ISA=baseline|avx2|avx512 can only
/// narrow it (for tests and measurements).
Isa best_isa();

const char* name_of(Isa isa);

}  // namespace pastoso::core
