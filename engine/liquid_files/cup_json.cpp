#include "liquid_files/cup_json.hpp"

#include "files/number_table.hpp"

namespace pastoso::liquid_files {
namespace {

using liquid::Cup;

struct CupNumber {
    const char* key;
    float Cup::*value;
};
constexpr CupNumber kCupNumbers[] = {
    {"floor_m", &Cup::floor_m}, {"floor_radius_m", &Cup::floor_radius_m},
    {"slope", &Cup::slope},     {"level_m", &Cup::level_m},
    {"wall_m", &Cup::wall_m},   {"foot_m", &Cup::foot_m},
    {"rim_m", &Cup::rim_m},
};

}  // namespace

Cup read_cup(const files::JsonPlace& place) {
    std::vector<std::string_view> keys = {"x_m", "y_m"};
    files::add_keys(keys, kCupNumbers);
    place.allow_only(keys);
    Cup cup;
    files::read_numbers(place, kCupNumbers, cup);
    if (const auto entry = place.optional_entry("x_m"))
        cup.axis_m.x = static_cast<float>(entry->number());
    if (const auto entry = place.optional_entry("y_m"))
        cup.axis_m.y = static_cast<float>(entry->number());
    return cup;
}

files::Json cup_to_json(const Cup& cup) {
    files::Json json = {{"x_m", cup.axis_m.x}, {"y_m", cup.axis_m.y}};
    files::write_numbers(json, kCupNumbers, cup);
    return json;
}

}  // namespace pastoso::liquid_files
