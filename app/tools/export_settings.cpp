#include "tools/export_settings.hpp"

#include "document/canvas.hpp"
#include "tools/marked_words.hpp"
#include "tools/memory_file.hpp"

#include <utility>

namespace pastoso::tools {
namespace {

using files::Json;
using files::JsonPlace;

constexpr int kVersion = 1;

constexpr ExportFormat kPictures[] = {
    {"png8", PASTOSO_WORDS("PNG, 8 bits"), ".png", 8},
    {"png16", PASTOSO_WORDS("PNG, 16 bits"), ".png", 16},
    {"jpeg", PASTOSO_WORDS("JPEG"), ".jpg", 8},
    {"tiff8", PASTOSO_WORDS("TIFF, 8 bits"), ".tif", 8},
    {"tiff16", PASTOSO_WORDS("TIFF, 16 bits"), ".tif", 16},
    {"tiff32", PASTOSO_WORDS("TIFF, 32 bits of linear light"), ".tif", 32},
    {"webp", PASTOSO_WORDS("WebP"), ".webp", 8},
    {"exr", PASTOSO_WORDS("OpenEXR, linear light"), ".exr", 8}};
constexpr ExportFormat kLayers[] = {{"exr", PASTOSO_WORDS("OpenEXR, linear light"), ".exr", 8}};
constexpr ExportFormat kMaps[] = {{"png8", PASTOSO_WORDS("PNG, 8 bits, heights in 16"), ".png", 8},
                                  {"png16", PASTOSO_WORDS("PNG, 16 bits"), ".png", 16},
                                  {"tiff16", PASTOSO_WORDS("TIFF, 16 bits"), ".tif", 16},
                                  {"tiff32", PASTOSO_WORDS("TIFF, 32 bits, heights in mm"), ".tif", 32},
                                  {"exr", PASTOSO_WORDS("OpenEXR, heights in mm"), ".exr", 8}};
constexpr ExportFormat kReliefs[] = {{"stl", PASTOSO_WORDS("STL"), ".stl"},
                                     {"ply", PASTOSO_WORDS("PLY"), ".ply"},
                                     {"obj", PASTOSO_WORDS("Wavefront OBJ"), ".obj"}};
constexpr ExportFormat kFilms[] = {
    {"frames8", PASTOSO_WORDS("Numbered pictures, PNG of 8 bits"), "", 8},
    {"frames16", PASTOSO_WORDS("Numbered pictures, PNG of 16 bits"), "", 16},
    {"mp4", PASTOSO_WORDS("Video, MP4"), ".mp4", 8},
    {"mkv", PASTOSO_WORDS("Video, Matroska"), ".mkv", 8},
    {"webm", PASTOSO_WORDS("Video, WebM"), ".webm", 8}};

struct NamedForm {
    const char* name;
    std::span<const ExportFormat> formats;
};
constexpr std::array<NamedForm, kExportForms> kForms = {{{"picture", kPictures},
                                                         {"layers", kLayers},
                                                         {"maps", kMaps},
                                                         {"relief", kReliefs},
                                                         {"timelapse", kFilms}}};

/// The place of a name in a table; fails where it is not there.
template <class Table>
std::size_t place_of(const Table& table, const JsonPlace& place) {
    const std::string text = place.text();
    std::string names;
    for (std::size_t i = 0; i < std::size(table); ++i) {
        if (text == table[i].name) return i;
        names += (i == 0 ? "" : ", ") + std::string(table[i].name);
    }
    place.fail("\"%1\" is not one of %2.", text, names);
}

double read_number(const JsonPlace& place, double least, double most) {
    const double number = place.number();
    if (!(number >= least && number <= most))
        place.fail("%1 is not from %2 to %3.", place.value().dump(), Json(least).dump(), Json(most).dump());
    return number;
}

void read_formats(const JsonPlace& place, ExportSettings& settings) {
    place.allow_only({"picture", "layers", "maps", "relief", "timelapse"});
    for (std::size_t form = 0; form < kExportForms; ++form)
        settings.formats[form] = place_of(kForms[form].formats, place.entry(kForms[form].name));
}

recordings::ReliefOptions read_relief(const JsonPlace& place) {
    place.allow_only({"base_mm", "exaggeration", "resolution_mm"});
    return {read_number(place.entry("base_mm"), 0.1, 100.0),
            read_number(place.entry("exaggeration"), 0.01, 100.0),
            read_number(place.entry("resolution_mm"), 0.0, 100.0)};
}

void read_film(const JsonPlace& place, ExportSettings& settings) {
    place.allow_only({"fps", "speed", "px_per_mm"});
    settings.fps = read_number(place.entry("fps"), 1.0, kMostFps);
    settings.speed = read_number(place.entry("speed"), kLeastSpeed, kMostSpeed);
    if (const auto finer = place.optional_entry("px_per_mm"))
        settings.film_px_per_mm = read_number(*finer, 0.0, document::kMaxPxPerMm);
}

Json formats_json(const ExportSettings& settings) {
    Json formats = Json::object();
    for (std::size_t form = 0; form < kExportForms; ++form)
        formats[kForms[form].name] = kForms[form].formats[settings.formats[form]].name;
    return formats;
}

recordings::PictureOptions picture_options(const ExportSettings& settings, const ExportLight& light) {
    const bool is_video = settings.form == ExportForm::Timelapse && *settings.format().ending != '\0';
    return {light.light, is_video ? "srgb" : settings.profile, settings.format().depth_bits,
            settings.quality};
}

}  // namespace

std::span<const ExportFormat> export_formats(ExportForm form) {
    return kForms[static_cast<std::size_t>(form)].formats;
}

const ExportFormat& ExportSettings::format() const {
    return export_formats(form)[formats[static_cast<std::size_t>(form)]];
}

recordings::ExportChoice export_choice(const ExportSettings& settings, const std::filesystem::path& path,
                                       const ExportLight& light) {
    recordings::ExportChoice choice;
    choice.kind = static_cast<recordings::ExportKind>(settings.form);
    choice.path = path;
    choice.of_well = settings.of_well && settings.form == ExportForm::Picture;
    choice.lit = settings.lit;
    choice.scale = settings.scale;
    choice.picture = picture_options(settings, light);
    choice.lighting = light.lighting;
    choice.varnish = light.varnish;
    choice.relief = settings.relief;
    return choice;
}

recordings::TimelapseChoice timelapse_choice(const ExportSettings& settings,
                                             const std::filesystem::path& path,
                                             const ExportLight& light) {
    recordings::TimelapseChoice choice;
    choice.path = path;
    choice.fps = settings.fps;
    choice.speed = settings.speed;
    if (settings.film_px_per_mm > 0.0) choice.px_per_mm = settings.film_px_per_mm;
    choice.lit = settings.lit;
    choice.scale = settings.scale;
    choice.picture = picture_options(settings, light);
    choice.lighting = light.lighting;
    choice.varnish = light.varnish;
    return choice;
}

ExportSettings read_export_settings(const std::filesystem::path& file) {
    ExportSettings settings;
    read_memory(file, kVersion, [&](const JsonPlace& root) {
        root.allow_only({"version", "form", "formats", "folder", "of_well", "lit", "scale", "profile",
                         "quality", "relief", "timelapse"});
        settings.form = static_cast<ExportForm>(place_of(kForms, root.entry("form")));
        read_formats(root.entry("formats"), settings);
        settings.folder = root.entry("folder").text();
        settings.of_well = root.entry("of_well").boolean();
        settings.lit = root.entry("lit").boolean();
        settings.scale = read_number(root.entry("scale"), kLeastExportScale, kMostExportScale);
        settings.profile = root.entry("profile").text();
        settings.quality = static_cast<int>(root.entry("quality").integer(1, 100));
        settings.relief = read_relief(root.entry("relief"));
        read_film(root.entry("timelapse"), settings);
    });
    return settings;
}

void write_export_settings(const ExportSettings& settings, const std::filesystem::path& file) {
    write_memory(
        {{"version", kVersion},
         {"form", kForms[static_cast<std::size_t>(settings.form)].name},
         {"formats", formats_json(settings)},
         {"folder", settings.folder},
         {"of_well", settings.of_well},
         {"lit", settings.lit},
         {"scale", settings.scale},
         {"profile", settings.profile},
         {"quality", settings.quality},
         {"relief",
          {{"base_mm", settings.relief.base_mm},
           {"exaggeration", settings.relief.exaggeration},
           {"resolution_mm", settings.relief.resolution_mm}}},
         {"timelapse",
          {{"fps", settings.fps}, {"speed", settings.speed}, {"px_per_mm", settings.film_px_per_mm}}}},
        file);
}

}  // namespace pastoso::tools
