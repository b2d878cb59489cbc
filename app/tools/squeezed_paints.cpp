#include "tools/squeezed_paints.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::tools {

void SqueezedPaints::note(const document::PaintRecipe& paint) {
    const bool known = std::find(here_.begin(), here_.end(), paint) != here_.end();
    if (!known && here_.size() < kMost) here_.push_back(paint);
}

void SqueezedPaints::begin() {
    last_ = latest();
    here_.clear();
}

void SqueezedPaints::set_last(std::vector<document::PaintRecipe> paints) {
    last_ = std::move(paints);
}

}  // namespace pastoso::tools
