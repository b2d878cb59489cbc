#include "film/cell/consistency.hpp"

namespace pastoso::film {

Consistency consistency_of(const PaintCoefficients& paint) {
    return {paint[kViscosityChannel], paint[kYieldChannel]};
}

Consistency consistency_of(const Medium& medium) {
    return consistency_of(paint_coefficients({}, medium));
}

Consistencies Consistencies::several() {
    Consistencies all;
    all.several_ = true;
    return all;
}

void Consistencies::add(const Consistencies& more) {
    if (more == Consistencies{} || more == *this) return;
    *this = *this == Consistencies{} ? more : several();
}

}  // namespace pastoso::film
