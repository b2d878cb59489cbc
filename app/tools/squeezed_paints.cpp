#include "tools/squeezed_paints.hpp"

#include <algorithm>

namespace pastoso::tools {

void SqueezedPaints::note(const document::PaintRecipe& paint) {
    const bool known = std::find(here_.begin(), here_.end(), paint) != here_.end();
    if (!known && here_.size() < kMost) here_.push_back(paint);
}

void SqueezedPaints::begin(const std::vector<document::Puddle>& puddles) {
    last_ = latest(puddles);
    here_.clear();
}

WellPalette SqueezedPaints::latest(const std::vector<document::Puddle>& puddles) const {
    WellPalette palette{here_.empty() ? last_.squeezed : here_, puddles};
    std::erase_if(palette.puddles, [&](const document::Puddle& puddle) {
        return std::any_of(here_.begin(), here_.end(), [&](const document::PaintRecipe& paint) {
            return document::are_alike(puddle.paint, paint);
        });
    });
    return here_.empty() && palette.puddles.empty() ? last_ : palette;
}

}  // namespace pastoso::tools
