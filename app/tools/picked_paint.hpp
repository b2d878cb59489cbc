// The eyedropper: the paint that lies at a place, as the tubes that it was mixed of.
#pragma once

#include "document/events.hpp"
#include "film/cell/paint_sample.hpp"
#include "film/medium.hpp"

#include <optional>
#include <span>
#include <string>

namespace pastoso::tools {

/// What of a place is picked.
enum class Pick {
    Paint,  ///< the mixture that lies there
    Seen    ///< the colour that it has to the eye
};

struct PickedPaint {
    document::PaintRecipe recipe;
    film::PaintLayer layer = film::PaintLayer::Bare;  ///< that it came from, wet or dry
};

/// The paint within half a millimetre, mixed of some of the paints named, as strong as it is mixed in
/// the medium. Nothing where none lies, and where they do not mix to it.
std::optional<PickedPaint> paint_at(const film::FilmState& film, std::span<const std::string> names,
                                    const film::Medium& medium, double x_mm, double y_mm);

}  // namespace pastoso::tools
