#include "document/painting.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::document {
namespace {

/// What is missing or surplus, in parts of what was taken; absolute as long as nothing was taken.
double relative_error(double found, double taken) {
    const double difference = std::abs(found - taken);
    return taken > 0.0 ? difference / taken : difference;
}

}  // namespace

double Account::volume_error_rel() const {
    const double found_mm3 =
        canvas.volume_mm3 + dried.volume_mm3 + brush.volume_mm3 + ledger.volume_mm3 + well.volume_mm3;
    return relative_error(found_mm3, taken.volume_mm3);
}

double Account::pigment_error_rel() const {
    double largest = 0.0;
    for (int k = 0; k < pigment::kChannels; ++k) {
        const double found = canvas.pigment[k] + dried.pigment[k] + brush.pigment[k] +
                             ledger.pigment[k] + well.pigment[k];
        largest = std::max(largest, relative_error(found, taken.pigment[k]));
    }
    return largest;
}

}  // namespace pastoso::document
