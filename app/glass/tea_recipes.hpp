// The glasses of tea that come with the program, to be chosen by their pictures.
#pragma once

#include <filesystem>
#include <vector>

#include <QString>

namespace pastoso::glass {

struct TeaRecipe {
    QString scene;  ///< its name in files
    QString words, hint;
    std::filesystem::path picture;
};

/// Those that are there, with their pictures.
std::vector<TeaRecipe> tea_recipes();

}  // namespace pastoso::glass
