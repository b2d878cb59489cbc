// The bundled media under the headings that painters look for them by.
#pragma once

#include "film/medium.hpp"

#include <string>
#include <vector>

namespace pastoso::film {

struct MediaFamily {
    std::string name;  ///< "family" in the file
    std::vector<Medium> media;
};

/// Every bundled medium once, in the order of the file; media of one family stand there one after the
/// other. Throws InputError where one has no family.
const std::vector<MediaFamily>& bundled_media_families();

}  // namespace pastoso::film
