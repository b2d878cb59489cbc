#include "film/media_families.hpp"

#include "core/error.hpp"
#include "core/resources.hpp"
#include "core/text_file.hpp"

#include <nlohmann/json.hpp>

namespace pastoso::film {
namespace {

/// The form of the file is checked where the media themselves are read.
std::vector<MediaFamily> read_families() {
    const std::vector<Medium>& media = bundled_media();
    const auto path = core::resource_path("media.json");
    const auto json = nlohmann::json::parse(core::read_text_file(path));
    std::vector<MediaFamily> families;
    for (std::size_t i = 0; i < media.size(); ++i) {
        const std::string name = json[i].value("family", "");
        if (name.empty())
            throw core::InputError("%1 (\"%2\"): the field \"family\" is missing.", path.string(),
                                   media[i].name);
        if (families.empty() || families.back().name != name) families.push_back({name, {}});
        families.back().media.push_back(media[i]);
    }
    return families;
}

}  // namespace

const std::vector<MediaFamily>& bundled_media_families() {
    static const std::vector<MediaFamily> families = read_families();
    return families;
}

}  // namespace pastoso::film
