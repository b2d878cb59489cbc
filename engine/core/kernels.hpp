// The choice among kernels, which are compiled once per instruction set (pastoso_add_kernels in
// packaging/cmake). A header declares a table of functions, and that there is one for each set:
//
//     struct MotionKernels {
//         void (*move)(const StepFlex&, const FerrulePose&, MotionColumns&);
//         static const MotionKernels baseline, avx2, avx512;
//     };
//
// A source that is compiled for each of them puts its code into namespace PASTOSO_ISA and fills the
// table in one line:
//
//     PASTOSO_REGISTER_KERNELS(pastoso::brush, MotionKernels, move)
//
// Everybody else calls core::kernels<MotionKernels>().move(...).
#pragma once

#include "core/isa.hpp"

namespace pastoso::core {

/// The kernels of an instruction set, which the processor must have; the baseline's stand for all where
/// the build holds no others.
template <class Table>
const Table& kernels(Isa isa) {
    switch (isa) {
        case Isa::Avx512:
            return Table::avx512;
        case Isa::Avx2:
            return Table::avx2;
        default:
            return Table::baseline;
    }
}

/// Those for best_isa().
template <class Table>
const Table& kernels() {
    static const Table& best = kernels<Table>(best_isa());
    return best;
}

}  // namespace pastoso::core

/// Fills `Table` of namespace `place` with functions of place::PASTOSO_ISA, in the table's order. At
/// global scope, in a source of pastoso_add_kernels().
#define PASTOSO_REGISTER_KERNELS(place, Table, ...) \
    namespace place::PASTOSO_ISA {                  \
    constexpr Table k##Table = {__VA_ARGS__};       \
    }                                               \
    PASTOSO_KERNELS_ARE(place, Table, PASTOSO_ISA)  \
    PASTOSO_KERNELS_ALSO_ARE(place, Table)
#define PASTOSO_KERNELS_ARE(place, Table, isa) \
    constinit const place::Table place::Table::isa = place::PASTOSO_ISA::k##Table;
#ifdef PASTOSO_ONE_ISA
#define PASTOSO_KERNELS_ALSO_ARE(place, Table) \
    PASTOSO_KERNELS_ARE(place, Table, avx2)    \
    PASTOSO_KERNELS_ARE(place, Table, avx512)
#else
#define PASTOSO_KERNELS_ALSO_ARE(place, Table)
#endif
