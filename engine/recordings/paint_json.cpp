#include "recordings/paint_json.hpp"

#include <utility>

namespace pastoso::recordings {
namespace {

document::Ingredient read_ingredient(const files::JsonPlace& place) {
    if (place.size() != 2) place.fail("expected a pigment and its parts, for example [\"PB29\", 1].");
    return {place.element(0).text(), place.element(1).number()};
}

}  // namespace

files::Json paint_json(const document::PaintRecipe& paint) {
    files::Json mix = files::Json::array();
    for (const document::Ingredient& ingredient : paint.ingredients) {
        mix.push_back(files::Json::array({ingredient.pigment, ingredient.parts}));
    }
    files::Json json{{"mix", std::move(mix)}};
    if (paint.strength != 1.0) json["strength"] = paint.strength;
    return json;
}

document::PaintRecipe read_paint(const files::JsonPlace& place) {
    place.allow_only({"mix", "strength"});
    document::PaintRecipe paint;
    const files::JsonPlace mix = place.entry("mix");
    for (std::size_t i = 0; i < mix.size(); ++i)
        paint.ingredients.push_back(read_ingredient(mix.element(i)));
    paint.strength = place.number_or("strength", 1.0);
    return paint;
}

film::Medium read_medium_numbers(const files::JsonPlace& place, const film::Medium& like,
                                 std::string_view skipped) {
    if (!place.value().is_object()) place.fail("this must be an object in braces.");
    files::Json numbers = files::Json::object();
    for (const auto& item : place.value().items()) {
        if (item.key() == skipped) continue;
        place.entry(item.key().c_str()).number();
        numbers[item.key()] = item.value();
    }
    film::Medium medium;
    place.guard([&] { medium = film::parse_medium(numbers.dump(), core::message("this paint"), like); });
    return medium;
}

}  // namespace pastoso::recordings
