#include "pigment/box.hpp"

#include "core/error.hpp"
#include "core/resources.hpp"
#include "core/text_file.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace pastoso::pigment {
namespace {

constexpr const char* kKey = "box";

std::vector<Pigment> load_default_box() {
    const auto path = core::resource_path("pigments/box.json");
    std::vector<Pigment> box;
    for (const std::string& ci_name :
         parse_box(core::read_text_file(path), path.string(), bundled_palette()))
        box.push_back(find_pigment(ci_name));
    return box;
}

}  // namespace

std::vector<std::string> parse_box(std::string_view json_text, const std::string& name,
                                   std::span<const Pigment> palette) {
    const nlohmann::json root = nlohmann::json::parse(json_text, nullptr, false);
    if (root.is_discarded()) throw core::InputError("%1: this is not valid JSON.", name);
    if (!root.is_object() || !root.contains(kKey) || !root[kKey].is_array() || root[kKey].empty())
        throw core::InputError("%1: the list \"%2\" of paints is missing.", name, kKey);
    std::vector<std::string> box;
    for (const nlohmann::json& entry : root[kKey]) {
        const std::string place = name + ", " + kKey + "[" + std::to_string(box.size()) + "]";
        if (!entry.is_string()) throw core::InputError("%1: expected the name of a pigment.", place);
        const auto ci_name = entry.get<std::string>();
        const bool exists = std::any_of(palette.begin(), palette.end(), [&](const Pigment& pigment) {
            return pigment.ci_name == ci_name;
        });
        if (!exists) throw core::InputError("%1: there is no pigment \"%2\".", place, ci_name);
        if (std::find(box.begin(), box.end(), ci_name) != box.end())
            throw core::InputError("%1: \"%2\" stands there twice.", place, ci_name);
        box.push_back(ci_name);
    }
    return box;
}

const std::vector<Pigment>& default_box() {
    static const std::vector<Pigment> box = load_default_box();
    return box;
}

}  // namespace pastoso::pigment
