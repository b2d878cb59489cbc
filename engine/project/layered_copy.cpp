#include "project/layered_copy.hpp"

#include "core/error.hpp"
#include "core/output_file.hpp"
#include "files/file_access.hpp"
#include "files/psd_file.hpp"
#include "pigment/colour.hpp"
#include "pigment/image.hpp"
#include "project/pictures.hpp"
#include "project/project_layout.hpp"
#include "project/zip_file.hpp"

#include <optional>
#include <utility>

namespace pastoso::project {
namespace {

/// The share of the time that the pictures take; the rest is packing and writing.
constexpr double kRendering = 0.7;

bool is_photoshop(const std::filesystem::path& path) {
    return path.extension() == ".psd";
}

void write_open_raster(const Pictures& pictures, core::OutputFile& file) {
    ZipWriter archive;
    archive.add("mimetype", std::string(kMimeType));
    archive.add("stack.xml", stack_xml(pictures));
    for (PictureFile& picture : picture_files(pictures))
        archive.add(picture.entry, std::move(picture.content));
    archive.write(file);
}

void write_photoshop(Pictures pictures, core::OutputFile& file) {
    files::PsdPicture picture{pigment::encode_srgb8(pictures.merged), {}, pictures.px_per_mm};
    for (LayerPicture& layer : pictures.layers)
        picture.layers.push_back(
            {layer.name, layer.visible, std::move(layer.picture), std::move(layer.covered)});
    files::write_psd(picture, file);
}

}  // namespace

bool is_layered_copy_path(const std::filesystem::path& path) {
    return path.extension() == ".ora" || is_photoshop(path);
}

void check_layered_copy(const LayeredCopy& copy) {
    if (!is_layered_copy_path(copy.path))
        throw core::InputError(
            "%1: a copy in layers is saved as .ora or .psd; this name ends in neither.",
            copy.path.string());
    files::check_writable(copy.path);
}

LayeredCopyReport save_layered_copy(const LayeredCopy& copy, const document::PaintingState& painting,
                                    core::ThreadPool& pool, const files::KeepGoing& keep_going) {
    check_layered_copy(copy);
    std::optional<Pictures> pictures =
        pictures_of(painting, pigment::kMostPictureSide_px, pool,
                    [&](double done) { return keep_going(kRendering * done); });
    if (!pictures || !keep_going(kRendering)) return {};
    LayeredCopyReport report{files::ExportStatus::Written, pictures->merged.width,
                             pictures->merged.height, pictures->layers.size()};
    const auto write = [&](core::OutputFile& file) {
        if (is_photoshop(copy.path))
            write_photoshop(*std::move(pictures), file);
        else
            write_open_raster(*pictures, file);
        return keep_going(1.0);
    };
    if (!core::write_aside_unless(copy.path, write)) report.status = files::ExportStatus::Stopped;
    return report;
}

}  // namespace pastoso::project
