// The paintings that come with the program, as recordings of their strokes.
#pragma once

#include <filesystem>
#include <vector>

#include <QString>

namespace pastoso::start {

struct ExamplePainting {
    QString name;
    QString detail;
    std::filesystem::path strokes;  ///< a recording
    std::filesystem::path picture;  ///< a PNG file
};

/// Those that are there, with their pictures.
std::vector<ExamplePainting> example_paintings();

}  // namespace pastoso::start
