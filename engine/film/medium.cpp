#include "film/medium.hpp"

#include "core/error.hpp"
#include "core/resources.hpp"
#include "core/text.hpp"
#include "core/text_file.hpp"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

namespace pastoso::film {
namespace {

using Json = nlohmann::json;

constexpr std::array kNumbers = {
    MediumNumber{"density_kg_m3", &Medium::density_kg_m3, 800.0, 2500.0},
    MediumNumber{"viscosity_m2_s", &Medium::viscosity_m2_s, 1e-6, 1.0},
    MediumNumber{"flow_index", &Medium::flow_index, 0.2, 1.0, true},
    MediumNumber{"yield_stress_Pa", &Medium::yield_stress_Pa, 0.0, 200.0},
    MediumNumber{"structure_share", &Medium::structure_share, 0.0, 0.95, true},
    MediumNumber{"recovery_s", &Medium::recovery_s, 0.1, 1000.0, true},
    MediumNumber{"breakdown_strain", &Medium::breakdown_strain, 0.1, 1000.0, true},
    MediumNumber{"surface_tension_N_m", &Medium::surface_tension_N_m, 0.02, 0.07},
    MediumNumber{"advancing_angle_deg", &Medium::advancing_angle_deg, 0.0, 60.0},
    MediumNumber{"receding_angle_deg", &Medium::receding_angle_deg, 0.0, 60.0},
    MediumNumber{"slip_cells", &Medium::slip_cells, 0.0, 1.0},
    MediumNumber{"alpha_min", &Medium::alpha_min, 0.4, 2.0},
    MediumNumber{"alpha_max", &Medium::alpha_max, 0.4, 2.0},
    MediumNumber{"typical_thickness_mm", &Medium::typical_thickness_mm, 0.01, 10.0},
    MediumNumber{"solid_fraction", &Medium::solid_fraction, 0.0, 1.0},
    MediumNumber{"touch_dry_s", &Medium::touch_dry_s, 1.0, 1e7},
    MediumNumber{"pigment_share", &Medium::pigment_share, 0.0005, 1.0, true},
};

std::string number_text(double value) {
    return Json(value).dump();
}

/// Reads the fields of one entry; `place` says in errors which entry it is.
class EntryReader {
  public:
    EntryReader(const Json& entry, core::Message place) : entry_(entry), place_(std::move(place)) {}

    std::string text(const char* key) const {
        const Json& value = field(key);
        if (!value.is_string() || value.get_ref<const std::string&>().empty()) {
            fail("%1 is %2, it must be a text.", key, value.dump());
        }
        return value.get<std::string>();
    }

    double number(const MediumNumber& wanted) const {
        const Json& value = field(wanted.key);
        if (!value.is_number() || value.get<double>() < wanted.least ||
            value.get<double>() > wanted.most) {
            fail("%1 is %2, it must be a number from %3 to %4.", wanted.key, value.dump(),
                 number_text(wanted.least), number_text(wanted.most));
        }
        return value.get<double>();
    }

    bool has(const char* key) const { return entry_.contains(key); }

    void refuse_unknown_fields() const {
        for (const auto& [key, value] : entry_.items()) {
            const bool known =
                key == "name" || key == "family" || key == "description" || key == "thinned_with" ||
                std::any_of(kNumbers.begin(), kNumbers.end(),
                            [&name = key](const MediumNumber& field) { return name == field.key; });
            if (!known) fail("there is no field %1.", Json(key).dump());
        }
    }

    template <class... Arguments>
    [[noreturn]] void fail(core::Pattern<sizeof...(Arguments)> pattern,
                           const Arguments&... arguments) const {
        throw core::InputError("%1: %2", place_, core::message(pattern, arguments...));
    }

  private:
    const Json& field(const char* key) const {
        const auto found = entry_.find(key);
        if (found == entry_.end()) fail("the field \"%1\" is missing.", key);
        return *found;
    }

    const Json& entry_;
    core::Message place_;
};

Medium read_medium(const Json& entry, const core::Message& place) {
    if (!entry.is_object()) throw core::InputError("%1: is not an object in braces.", place);
    const EntryReader reader(entry, place);
    Medium medium;
    medium.name = reader.text("name");
    const EntryReader named(entry, core::message("%1 (\"%2\")", place, medium.name));
    medium.description = named.text("description");
    for (const MediumNumber& field : kNumbers)
        if (!field.optional || named.has(field.key)) medium.*field.member = named.number(field);
    if (named.has("thinned_with")) medium.thinned_with = named.text("thinned_with");
    if (named.has("family")) named.text("family");
    named.refuse_unknown_fields();
    if (medium.receding_angle_deg > medium.advancing_angle_deg) {
        named.fail("receding_angle_deg is %1, it must not be larger than advancing_angle_deg, %2.",
                   number_text(medium.receding_angle_deg), number_text(medium.advancing_angle_deg));
    }
    if (medium.alpha_min > medium.alpha_max) {
        named.fail("alpha_min is %1, it must not be larger than alpha_max, %2.",
                   number_text(medium.alpha_min), number_text(medium.alpha_max));
    }
    if (medium.touch_dry_s > kSlowestDrying_s_mm * medium.typical_thickness_mm) {
        named.fail("touch_dry_s is %1, it must not be larger than typical_thickness_mm times %2.",
                   number_text(medium.touch_dry_s), number_text(kSlowestDrying_s_mm));
    }
    return medium;
}

/// Throws InputError unless every medium that thins another is one of them.
void check_thinners(const std::vector<Medium>& media, const std::string& name) {
    for (const Medium& medium : media) {
        const auto thins = [&](const Medium& other) {
            return other.name == medium.thinned_with && other.name != medium.name;
        };
        if (medium.thinned_with.empty() || std::any_of(media.begin(), media.end(), thins)) continue;
        throw core::InputError(
            "%1 (\"%2\"): thinned_with is \"%3\", it must be the name of another medium here.", name,
            medium.name, medium.thinned_with);
    }
}

Json parse_json(std::string_view text, const core::Message& name) {
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        const long line = 1 + std::count(text.begin(), end, '\n');
        throw core::InputError("%1, line %2: this is not JSON, or it is cut off here.", name, line);
    } catch (const Json::out_of_range&) {
        throw core::InputError("%1: holds a number that is too large.", name);
    }
}

}  // namespace

std::vector<Medium> parse_media(std::string_view json_text, const std::string& name) {
    const Json json = parse_json(json_text, core::Message::verbatim(name));
    if (!json.is_array()) throw core::InputError("%1: is not a list of media in square brackets.", name);
    std::vector<Medium> media;
    for (const Json& entry : json) {
        media.push_back(read_medium(entry, core::message("%1, entry %2", name, media.size() + 1)));
    }
    check_thinners(media, name);
    return media;
}

Medium parse_medium(std::string_view json_object, const core::Message& place, const Medium& otherwise) {
    const Json given = parse_json(json_object, place);
    if (!given.is_object()) throw core::InputError("%1: is not an object in braces.", place);
    Json entry = {{"name", otherwise.name.empty() ? "by numbers" : otherwise.name},
                  {"description",
                   otherwise.description.empty() ? "Given by its numbers." : otherwise.description}};
    for (const MediumNumber& field : kNumbers)
        entry[field.key] = otherwise.*field.member;
    if (!otherwise.thinned_with.empty()) entry["thinned_with"] = otherwise.thinned_with;
    entry.update(given);
    return read_medium(entry, place);
}

std::span<const MediumNumber> medium_numbers() {
    return kNumbers;
}

std::string numbers_to_json(const Medium& medium) {
    Json numbers = Json::object();
    for (const MediumNumber& number : kNumbers)
        numbers[number.key] = medium.*number.member;
    return numbers.dump();
}

void check_numbers(const Medium& medium, const core::Message& place) {
    parse_medium(numbers_to_json(medium), place, medium);
}

const std::vector<Medium>& bundled_media() {
    static const std::vector<Medium> media = [] {
        const auto path = core::resource_path("media.json");
        return parse_media(core::read_text_file(path), path.string());
    }();
    return media;
}

const Medium& find_medium(std::string_view name) {
    std::string names;
    for (const Medium& medium : bundled_media()) {
        if (core::lower_case(medium.name) == core::lower_case(name)) return medium;
        names += (names.empty() ? "" : ", ") + medium.name;
    }
    throw core::InputError("There is no medium \"%1\"; the media are: %2.", name, names);
}

}  // namespace pastoso::film
