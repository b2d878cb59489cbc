#include "project/import_open_raster.hpp"

#include "core/error.hpp"
#include "document/canvas.hpp"
#include "files/image.hpp"
#include "project/project_layout.hpp"
#include "project/stack_reader.hpp"
#include "project/zip_file.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace pastoso::project {
namespace {

constexpr const char* kStackEntry = "stack.xml";

/// A whole picture, packed or not.
constexpr std::size_t kMostPictureBytes = std::size_t{1} << 29;

/// The recording of the canvas can be read again (document::kMostRecordedPixels).
constexpr double kMostPixelsInAll = 4e8;
/// As the file has them: a few bytes can unfold to many, and a picture can be named again and again.
constexpr double kMostPixelsUnpacked = 2e9;

std::string text_of(const Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

RasterStack stack_of(const ZipReader& archive) {
    if (!archive.has(kStackEntry))
        throw core::InputError("%1: is no OpenRaster file, which would hold %2.", archive.name(),
                               kStackEntry);
    return read_stack(text_of(archive.read(kStackEntry, kMostStackBytes)),
                      archive.name() + ", " + kStackEntry);
}

/// Brings the pictures of an archive onto a canvas, from below.
class Importer {
  public:
    Importer(const ZipReader& archive, RasterStack stack, const ImportSettings& settings,
             core::ThreadPool& pool)
        : archive_(archive), stack_(std::move(stack)), canvas_(settings_of(settings), pool) {}

    LoadedProject run() {
        document::LayerId next = 2;
        for (const StackPicture& picture : stack_.pictures) {
            add(picture, next);
            if (picture.group > 0) grouped_.resize(std::max(grouped_.size(), picture.group));
            if (picture.group > 0) grouped_[picture.group - 1].push_back(next);
            ++next;
        }
        if (!stack_.pictures.empty()) canvas_.apply(document::RemoveLayer{1});
        make_groups();
        LoadedProject project;
        static_cast<Project&>(project) = canvas_.take();
        project.notes = std::move(stack_.notes);
        return project;
    }

  private:
    document::CanvasSettings settings_of(const ImportSettings& settings) {
        CanvasSize said;
        if (stack_.px_per_mm_x > 0.0)
            said = {stack_.width / stack_.px_per_mm_x, stack_.height / stack_.px_per_mm_y};
        const CanvasSize size = canvas_size(stack_.width, stack_.height, said, settings.width_mm);
        document::CanvasSettings canvas;
        canvas.width_mm = size.width_mm;
        canvas.height_mm = size.height_mm;
        canvas.px_per_mm = settings.px_per_mm;
        canvas.support = settings.support;
        canvas.support_relief_mm = settings.support_relief_mm;
        document::check_canvas(canvas);
        mm_per_px_x_ = size.width_mm / stack_.width;
        mm_per_px_y_ = size.height_mm / stack_.height;
        px_per_mm_ = settings.px_per_mm;
        return canvas;
    }

    void add(const StackPicture& picture, document::LayerId id) {
        try {
            const Bytes file = archive_.read(picture.source, kMostPictureBytes);
            pigment::Picture pixels =
                files::decode_png_to_srgb({reinterpret_cast<const char*>(file.data()), file.size()});
            unpacked_ += 1.0 * pixels.width * pixels.height;
            const layers::PicturePlace place{picture.x * mm_per_px_x_, picture.y * mm_per_px_y_,
                                             pixels.width * mm_per_px_x_, pixels.height * mm_per_px_y_};
            auto paint = paint_of_picture(std::move(pixels), picture.look.name, place, px_per_mm_);
            pixels_ += 1.0 * paint.picture->width * paint.picture->height;
            if (pixels_ > kMostPixelsInAll || unpacked_ > kMostPixelsUnpacked)
                throw core::InputError("the layers are too large in all.");
            canvas_.apply(paint);
        } catch (const core::InputError& error) {
            if (std::string_view(error.what()).starts_with(archive_.name())) throw;
            archive_.fail(picture.source, error.message());
        }
        const document::LayerLook plain{.name = picture.look.name};
        if (picture.look != plain) canvas_.apply(document::SetLayer{id, picture.look});
    }

    void make_groups() {
        document::GroupId next = 1;
        for (std::size_t group = 0; group < grouped_.size(); ++group) {
            if (grouped_[group].empty()) continue;
            const document::LayerLook& look = stack_.groups[group];
            canvas_.apply(document::GroupLayers{look.name, grouped_[group]});
            const document::LayerLook plain{.name = look.name};
            if (look != plain) canvas_.apply(document::SetGroup{next, look});
            ++next;
        }
    }

    const ZipReader& archive_;
    RasterStack stack_;
    double mm_per_px_x_ = 1.0, mm_per_px_y_ = 1.0, px_per_mm_ = 1.0;
    double pixels_ = 0.0, unpacked_ = 0.0;  ///< of all pictures until now, with and without reduction
    std::vector<std::vector<document::LayerId>> grouped_;  ///< the layers of every group
    PictureCanvas canvas_;
};

LoadedProject imported(const ZipReader& archive, const ImportSettings& settings,
                       core::ThreadPool& pool) {
    return Importer(archive, stack_of(archive), settings, pool).run();
}

}  // namespace

LoadedProject import_open_raster(const std::filesystem::path& path, const ImportSettings& settings,
                                 core::ThreadPool& pool, const core::Progress& progress) {
    const ZipReader archive(path, progress);
    if (archive.has(kIndexEntry)) return load_project(path, pool, progress);
    return imported(archive, settings, pool);
}

LoadedProject parse_open_raster(std::span<const std::byte> file, const std::string& name,
                                const ImportSettings& settings, core::ThreadPool& pool) {
    return imported(ZipReader(file, name), settings, pool);
}

bool is_open_raster_path(const std::filesystem::path& path) {
    return path.extension() == ".ora";
}

}  // namespace pastoso::project
