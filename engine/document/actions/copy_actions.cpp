#include "document/actions/copy_actions.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "document/living_painting.hpp"

#include <memory>

namespace pastoso::document {

void apply(const CopyPaint& copy, LivingPainting& painting) {
    PaintingValue& value = painting.value;
    value.copied =
        std::make_shared<const film::FilmState>(painting.canvas.copy(copy, value.selection.get()));
}

void check_whole(const BringPaint& bring) {
    PASTOSO_CHECK(bring.paint != nullptr);
}

void apply(const BringPaint& bring, LivingPainting& painting) {
    painting.value.copied = bring.paint;
}

void check_possible(const PastePaint&, const LivingPainting& painting) {
    if (!painting.value.copied) throw core::InputError("no paint has been copied that could be pasted.");
}

void apply(const PastePaint& paste, LivingPainting& painting) {
    const LayerPaint taken = painting.canvas.paste(paste, *painting.value.copied);
    painting.value.flows.taken += painting.contents_of(taken);
}

}  // namespace pastoso::document
