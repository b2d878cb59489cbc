#include "liquid_files/tea_json.hpp"

#include "core/text_file.hpp"
#include "files/bundled_files.hpp"
#include "files/json_place.hpp"
#include "files/number_table.hpp"
#include "liquid_files/cup_json.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>

namespace pastoso::liquid_files {
namespace {

using liquid::TeaSettings;
using liquid::VelocityAdvection;

constexpr const char* kBundled = "tea";  ///< the folder of resources

struct AdvectionName {
    const char* name;
    VelocityAdvection advection;
};
constexpr AdvectionName kAdvections[] = {{"once", VelocityAdvection::Once},
                                         {"reflected", VelocityAdvection::Reflected}};

constexpr files::FileFormat kFormat{"pastoso-tea", core::Pattern<0>("a glass of milk tea"),
                                    core::Pattern<0>("tea format"), kTeaFormatVersion};

/// Numbers of rules that are no more, which scenes may still have.
constexpr const char* kRetired[] = {"cohesion_s", "cohesion_reach", "cohesion_limit_m", "burst_depth_m"};

VelocityAdvection read_advection(const files::JsonPlace& place) {
    const std::string name = place.text();
    for (const AdvectionName& known : kAdvections)
        if (name == known.name) return known.advection;
    place.fail(R"("%1" is neither "once" nor "reflected".)", name);
}

void read_whole_numbers(const files::JsonPlace& place, TeaSettings& settings) {
    if (const auto entry = place.optional_entry("cells"))
        settings.cells = static_cast<int>(entry->integer(liquid::kMinTeaCells, liquid::kMaxTeaCells));
    if (const auto entry = place.optional_entry("parcels"))
        settings.parcels = static_cast<int>(entry->integer(1, liquid::kMaxParcels));
    if (const auto entry = place.optional_entry("seed"))
        settings.seed = static_cast<std::uint32_t>(entry->integer(0, UINT32_MAX));
    if (const auto entry = place.optional_entry("ball_candidates"))
        settings.ball_candidates = static_cast<int>(entry->integer(1, 100000));
}

}  // namespace

liquid::TeaSettings tea_from_json(std::string_view text, const std::string& name) {
    const files::Json json = files::parse_json(text, name);
    const files::JsonPlace place(json, name);
    files::check_format(place, kFormat);
    std::vector<std::string_view> keys = {"format",  "version", "cup",       "cells",
                                          "parcels", "seed",    "advection", "ball_candidates"};
    files::add_keys(keys, liquid::tea_numbers());
    keys.insert(keys.end(), std::begin(kRetired), std::end(kRetired));
    place.allow_only(keys);

    TeaSettings settings;
    if (const auto cup = place.optional_entry("cup")) settings.cup = read_cup(*cup);
    read_whole_numbers(place, settings);
    if (const auto entry = place.optional_entry("advection"))
        settings.advection = read_advection(*entry);
    files::read_numbers(place, liquid::tea_numbers(), settings);
    place.guard([&] { liquid::check_tea(settings); });
    return settings;
}

std::vector<std::string> bundled_tea_names() {
    return files::bundled_names(kBundled);
}

liquid::TeaSettings read_tea(const std::string& path_or_name) {
    const std::filesystem::path path = files::scene_path(path_or_name, kBundled);
    return tea_from_json(core::read_text_file(path), path.string());
}

std::string tea_to_json(const liquid::TeaSettings& settings) {
    files::Json json = {{"format", kFormat.name},  {"version", kTeaFormatVersion},
                        {"cells", settings.cells}, {"parcels", settings.parcels},
                        {"seed", settings.seed},   {"ball_candidates", settings.ball_candidates}};
    for (const AdvectionName& known : kAdvections)
        if (known.advection == settings.advection) json["advection"] = known.name;
    json["cup"] = cup_to_json(settings.cup);
    files::write_numbers(json, liquid::tea_numbers(), settings);
    return json.dump(2) + "\n";
}

int steps_per_frame(const TeaSettings& settings, double fps) {
    return std::max(1, static_cast<int>(std::ceil(1.0 / (fps * settings.step_s) - 1e-6)));
}

TeaSettings stepped_for(TeaSettings settings, double fps) {
    settings.step_s = 1.0 / (fps * steps_per_frame(settings, fps));
    return settings;
}

}  // namespace pastoso::liquid_files
