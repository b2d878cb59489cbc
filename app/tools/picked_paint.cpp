#include "tools/picked_paint.hpp"

#include "document/paint_reading.hpp"

namespace pastoso::tools {
namespace {

constexpr double kRadius_mm = 0.5;

}  // namespace

std::optional<PickedPaint> paint_at(const film::FilmState& film, std::span<const std::string> names,
                                    const film::Medium& medium, double x_mm, double y_mm) {
    const film::PaintSample sample = film::sample_paint(film, x_mm, y_mm, kRadius_mm);
    if (sample.layer == film::PaintLayer::Bare) return std::nullopt;
    const auto recipe = document::recipe_of(sample.coefficients, names, medium.pigment_share);
    if (!recipe) return std::nullopt;
    return PickedPaint{*recipe, sample.layer};
}

}  // namespace pastoso::tools
