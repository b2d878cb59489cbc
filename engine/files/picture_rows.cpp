#include "files/picture_rows.hpp"

#include "files/exr_header.hpp"
#include "files/images_library.hpp"
#include "files/jpeg_end.hpp"
#include "files/picture_format.hpp"
#include "files/png_rows.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace pastoso::files {
namespace {

/// Of a WebP file, which is read as a whole.
constexpr std::uint64_t kMostWebpBytes = std::uint64_t{1} << 29;

/// A picture file that OpenImageIO reads.
class ModuleRows final : public PictureRows {
  public:
    ModuleRows(PictureFormat format, const core::RegularFile& file, std::string name)
        : library_(images_library()), name_(std::move(name)) {
        PastosoHead told{};
        check(library_.read_open(reader_name(format), file.descriptor(), &reader_, &told, error_.data(),
                                 error_.size()));
        take(told);
    }
    ~ModuleRows() override { library_.read_close(reader_); }
    ModuleRows(const ModuleRows&) = delete;
    ModuleRows& operator=(const ModuleRows&) = delete;

    void read(int count, float* rows) override {
        check(library_.read_rows(reader_, head_.channels(), count, rows, error_.data(), error_.size()));
    }

    void finish() override { check(library_.read_finish(reader_, error_.data(), error_.size())); }

  private:
    void check(int status) const {
        if (status != 0) throw picture_error(name_, core::message("%1.", error_.data()));
    }

    void take(const PastosoHead& told) {
        head_.width = told.width;
        head_.height = told.height;
        head_.colours = told.channels < 3 ? 1 : 3;
        head_.has_alpha = told.alpha_channel == head_.colours;
        head_.colours_have_alpha = head_.has_alpha && told.colours_have_alpha != 0;
        head_.meaning.linear = told.is_linear != 0;
        if (told.icc_profile != nullptr)
            head_.meaning.profile.assign(static_cast<const char*>(told.icc_profile), told.icc_bytes);
        if (told.has_chromaticities != 0)
            std::copy_n(told.chromaticities, 8, head_.meaning.chromaticities.emplace().begin());
        head_.orientation = told.orientation;
        head_.px_per_mm_x = told.px_per_mm_x;
        head_.px_per_mm_y = told.px_per_mm_y;
        head_.rows_at_once = told.rows_at_once;
    }

    const ImagesLibrary& library_;
    std::string name_;
    PastosoReader* reader_ = nullptr;
    std::array<char, 512> error_{};
};

std::unique_ptr<PictureRows> png_file_rows(std::shared_ptr<core::RegularFile> file,
                                           const std::string& name) {
    return png_rows(
        [file = std::move(file), place = std::uint64_t{0}](void* to, std::size_t count) mutable {
            const std::size_t got = file->read_at(place, to, count);
            place += got;
            return got;
        },
        name);
}

/// What libraries would pass over, or make room for without asking.
void check_before_opening(PictureFormat format, const core::RegularFile& file, const std::string& name) {
    const PictureSize size = told_size(format, file.text_at(0, kPictureHeadBytes));
    check_picture_size(name, static_cast<double>(size.width), static_cast<double>(size.height));
    if (format == PictureFormat::OpenExr) check_exr_header(file, name);
    if (format == PictureFormat::Jpeg && !jpeg_has_end(file))
        throw picture_error(name, core::message("is cut off: the end of the JPEG picture is missing."));
    if (format == PictureFormat::WebP && file.bytes() > kMostWebpBytes) {
        throw picture_error(
            name, core::message("is larger than the %1 bytes that are read of a WebP picture at most.",
                                kMostWebpBytes));
    }
}

}  // namespace

core::InputError picture_error(const std::string& name, const core::Message& predicate) {
    if (name.empty()) return core::InputError("the picture %1", predicate);
    return core::InputError("%1: %2", name, predicate);
}

void check_picture_size(const std::string& name, double width, double height) {
    if (width <= kMaxPictureSide_px && height <= kMaxPictureSide_px &&
        width * height <= kMaxPicturePixels)
        return;
    throw picture_error(
        name,
        core::message("has %1 x %2 pixels, but at most 32768 a side and 100 million in all are read.",
                      static_cast<std::int64_t>(width), static_cast<std::int64_t>(height)));
}

std::unique_ptr<PictureRows> open_picture(const std::filesystem::path& path) {
    auto file = std::make_shared<core::RegularFile>(path);
    const std::string name = path.string();
    const PictureFormat format = picture_format(file->text_at(0, kPictureHeadBytes));
    if (format == PictureFormat::None)
        throw picture_error(name, core::message("is not an image that can be read (it is none of %1).",
                                                kPictureFormats));
    if (format == PictureFormat::Png) return png_file_rows(std::move(file), name);
    check_before_opening(format, *file, name);
    return std::make_unique<ModuleRows>(format, *file, name);
}

}  // namespace pastoso::files
