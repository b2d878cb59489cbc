#include "document/contents.hpp"

#include <algorithm>

namespace pastoso::document {
namespace {

/// Of a sum of quanta over cells, in mm3 times what is counted per mm.
double carried(std::int64_t quanta, double cell_mm) {
    return static_cast<double>(quanta) * film::kPaintQuantum * cell_mm * cell_mm;
}

}  // namespace

brush::Contents contents_of(const film::Totals& totals, double cell_mm) {
    brush::Contents contents;
    contents.volume_mm3 = film::volume_mm3(totals.thickness, cell_mm);
    for (int k = 0; k < film::kPaintChannels; ++k)
        contents.paint[k] = carried(totals.paint[k], cell_mm);
    return contents;
}

brush::Contents contents_of(const film::DriedTotals& totals, double cell_mm) {
    brush::Contents contents;
    contents.volume_mm3 = film::volume_mm3(totals.thickness, cell_mm);
    for (int k = 0; k < film::kPigmentChannels; ++k)
        contents.paint[k] = carried(totals.pigment[k], cell_mm);
    return contents;
}

film::Totals difference(film::Totals a, const film::Totals& b) {
    a.thickness -= b.thickness;
    for (int k = 0; k < film::kPaintChannels; ++k)
        a.paint[k] -= b.paint[k];
    return a;
}

Account::Amount amount(const brush::Contents& contents) {
    Account::Amount result{.volume_mm3 = contents.volume_mm3};
    std::copy_n(contents.paint.begin(), pigment::kChannels, result.pigment.begin());
    return result;
}

}  // namespace pastoso::document
