// What an export would come to, in a sentence, or why there can be none.
#pragma once

#include "tools/export_settings.hpp"

#include <filesystem>

#include <QString>

namespace pastoso::dialogs {

/// The painting, as far as one has to know it to choose an export.
struct ExportSubject {
    recordings::ExportedCells canvas;
    document::Recording film;  ///< what a time-lapse would show, without the events
    bool has_strokes = true;   ///< to be shown by a time-lapse
    tools::ExportLight light{};
};

/// The canvas that a time-lapse is painted on.
document::CanvasSettings film_canvas(const ExportSubject& subject,
                                     const tools::ExportSettings& settings);

/// Columns and rows of a picture, a relief or a frame. Throws InputError where there are too many.
grid::Shape exported_size(const ExportSubject& subject, const tools::ExportSettings& settings,
                          const std::filesystem::path& path);

/// Throws InputError for what cannot be exported like this. An empty path is none.
QString export_summary(const ExportSubject& subject, const tools::ExportSettings& settings,
                       const std::filesystem::path& path);

}  // namespace pastoso::dialogs
