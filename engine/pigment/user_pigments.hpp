// Pigments of the painter's own, measured or made up, beside those that come with the program.
#pragma once

#include "core/message.hpp"
#include "pigment/palette.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace pastoso::pigment {

struct UserPigments {
    std::vector<Pigment> pigments;      ///< of the files without a fault, in the order of their names
    std::vector<core::Message> faults;  ///< a sentence on every file that was left out, with the place
};

/// Reads every *.csv of the folder (resources/pigments/pigments.csv shows the form), in the order of the
/// names. A file with a fault, or with a pigment whose name is taken by another, is left out as a whole.
/// A folder that does not exist holds nothing.
UserPigments read_user_pigments(const std::filesystem::path& folder);

/// Those of $XDG_DATA_HOME/pastoso/pigments, read at the first call (core/user_data.hpp).
const UserPigments& user_pigments();

}  // namespace pastoso::pigment
