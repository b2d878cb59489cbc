// What was chosen for the window's last export: kept between two starts.
#pragma once

#include "recordings/painting_export.hpp"
#include "recordings/timelapse.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace pastoso::tools {

enum class ExportForm { Picture, Layers, Maps, Relief, Timelapse };
inline constexpr std::size_t kExportForms = 5;

/// What a form is kept in.
struct ExportFormat {
    const char* name;    ///< in the file of the settings
    const char* words;   ///< for the painter
    const char* ending;  ///< of the file's name, with its dot; "": a folder
    int depth_bits = 8;
};

/// At least one.
std::span<const ExportFormat> export_formats(ExportForm form);

inline constexpr double kLeastExportScale = 1.0 / 16.0;
inline constexpr double kMostExportScale = 64.0;
inline constexpr double kMostFps = 120.0;
inline constexpr double kLeastSpeed = 0.01;
inline constexpr double kMostSpeed = 1e5;

struct ExportSettings {
    ExportForm form = ExportForm::Picture;
    std::array<std::size_t, kExportForms> formats{};  ///< the one of each form
    std::string folder;                               ///< of the last file; empty: none yet
    bool of_well = false;                             ///< a picture of the mixing well
    bool lit = true;
    double scale = 1.0;            ///< pixels of a cell
    std::string profile = "srgb";  ///< files::picture_colours()
    int quality = 95;
    recordings::ReliefOptions relief;
    double fps = 25.0;            ///< of a time-lapse
    double speed = 10.0;          ///< seconds of painting in a second of film
    double film_px_per_mm = 0.0;  ///< cells of the canvas that it is painted on; 0: as they were

    const ExportFormat& format() const;  ///< of the form
    friend bool operator==(const ExportSettings&, const ExportSettings&) = default;
};

/// The light that an export is seen in: the window's.
struct ExportLight {
    std::string light = "D65";  ///< pigment::find_illuminant()
    shade::Lighting lighting;
    shade::Varnish varnish;
};

/// A picture, layers, maps or a relief as the settings say.
recordings::ExportChoice export_choice(const ExportSettings& settings, const std::filesystem::path& path,
                                       const ExportLight& light);

/// The same of a time-lapse.
recordings::TimelapseChoice timelapse_choice(const ExportSettings& settings,
                                             const std::filesystem::path& path,
                                             const ExportLight& light);

/// The settings at first where there is no such file. Throws InputError that names the file, the place
/// in it and the value for anything malformed or out of range.
ExportSettings read_export_settings(const std::filesystem::path& file);

/// Written aside, its folder made where there is none. Throws InputError where that cannot be written.
void write_export_settings(const ExportSettings& settings, const std::filesystem::path& file);

}  // namespace pastoso::tools
