#include "files/png_rows.hpp"

#include "files/exif_orientation.hpp"

#include <array>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <new>
#include <png.h>
#include <string_view>
#include <utility>
#include <vector>

namespace pastoso::files {
namespace {

constexpr png_alloc_size_t kMaxChunkBytes = png_alloc_size_t{1} << 26;

/// What the functions that libpng calls know.
struct Talk {
    NextBytes source;
    std::array<char, 256> complaint{};
    bool complains_of_profile = false;
    bool ends_early = false;

    core::Message reason() const {
        if (ends_early) return core::message("its end is missing");
        return core::Message::verbatim(complaint.data());
    }
};

Talk& talk_of(png_structp png) {
    return *static_cast<Talk*>(png_get_error_ptr(png));
}

[[noreturn]] void fail(png_structp png, png_const_charp complaint) {
    Talk& talk = talk_of(png);
    std::snprintf(talk.complaint.data(), talk.complaint.size(), "%s", complaint);
    png_longjmp(png, 1);
}

void warn(png_structp png, png_const_charp complaint) {
    if (std::string_view(complaint).starts_with("iCCP")) talk_of(png).complains_of_profile = true;
}

/// No exception may pass through libpng.
std::size_t taken(Talk& talk, void* to, std::size_t count) noexcept {
    try {
        return talk.source(to, count);
    } catch (...) {
        return 0;
    }
}

void give(png_structp png, png_bytep to, std::size_t count) {
    Talk& talk = talk_of(png);
    talk.ends_early = taken(talk, to, count) != count;
    if (talk.ends_early) png_error(png, "its end is missing");
}

/// A PNG file that libpng reads.
class PngRows final : public PictureRows {
  public:
    PngRows(NextBytes source, std::string name) : name_(std::move(name)) {
        talk_.source = std::move(source);
        png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &talk_, fail, warn);
        info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
        if (info_ == nullptr) {
            png_destroy_read_struct(&png_, &info_, nullptr);
            throw std::bad_alloc();
        }
    }
    ~PngRows() override { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngRows(const PngRows&) = delete;
    PngRows& operator=(const PngRows&) = delete;

    void open();
    void read(int count, float* rows) override;
    void finish() override;

  private:
    /// Calls work(), which libpng leaves with a jump where something is wrong: it may hold nothing that
    /// must be freed.
    template <class Work>
    void attempt(core::Pattern<0> failure, Work&& work) {
        if (setjmp(png_jmpbuf(png_)) == 0) {
            work();
            return;
        }
        throw picture_error(name_, core::message("%1 (%2).", core::message(failure), talk_.reason()));
    }

    void tell_meaning();
    void tell_place();
    void read_all();
    void widen(const png_byte* row, float* values) const;

    std::string name_;
    Talk talk_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    std::size_t row_bytes_ = 0;
    bool is_deep_ = false;  ///< 16 bits a value
    bool is_interlaced_ = false;
    int next_row_ = 0;
    std::vector<png_byte> stored_;  ///< a row; all of them where they are interlaced
};

void PngRows::open() {
    attempt(core::Pattern<0>("is no PNG picture"), [this] {
        png_set_read_fn(png_, &talk_, give);
        png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
        png_set_chunk_malloc_max(png_, kMaxChunkBytes);
        // Texts may unpack to any size, and nobody reads them.
        constexpr png_byte kUnread[] = "tEXt\0zTXt\0iTXt\0sPLT";
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, kUnread, 4);
        png_read_info(png_, info_);
    });
    check_picture_size(name_, png_get_image_width(png_, info_), png_get_image_height(png_, info_));
    attempt(core::Pattern<0>("is no PNG picture"), [this] {
        png_set_expand(png_);  // palettes, less than eight bits, a colour that stands for transparency
        png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
    });
    const int channels = png_get_channels(png_, info_);
    head_.width = static_cast<int>(png_get_image_width(png_, info_));
    head_.height = static_cast<int>(png_get_image_height(png_, info_));
    head_.colours = channels < 3 ? 1 : 3;
    head_.has_alpha = channels % 2 == 0;
    is_deep_ = png_get_bit_depth(png_, info_) == 16;
    is_interlaced_ = png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE;
    row_bytes_ = png_get_rowbytes(png_, info_);
    tell_meaning();
    tell_place();
    stored_.resize(row_bytes_ * (is_interlaced_ ? static_cast<std::size_t>(head_.height) : 1));
}

void PngRows::tell_meaning() {
    double gamma = 0.0;
    // A file of linear values says so by a gamma of 1, written with five digits.
    head_.meaning.linear = png_get_gAMA(png_, info_, &gamma) != 0 && std::abs(gamma - 1.0) < 0.005;
    png_charp profile_name = nullptr;
    png_bytep profile = nullptr;
    png_uint_32 bytes = 0;
    int compression = 0;
    if (png_get_iCCP(png_, info_, &profile_name, &compression, &profile, &bytes) != 0)
        head_.meaning.profile.assign(reinterpret_cast<const char*>(profile), bytes);
    head_.profile_is_damaged = head_.meaning.profile.empty() && talk_.complains_of_profile;
}

void PngRows::tell_place() {
    png_uint_32 x = 0, y = 0;
    int unit = PNG_RESOLUTION_UNKNOWN;
    if (png_get_pHYs(png_, info_, &x, &y, &unit) != 0 && unit == PNG_RESOLUTION_METER) {
        head_.px_per_mm_x = x / 1000.0;
        head_.px_per_mm_y = y / 1000.0;
    }
    png_bytep exif = nullptr;
    png_uint_32 bytes = 0;
    if (png_get_eXIf_1(png_, info_, &bytes, &exif) != 0)
        head_.orientation = exif_orientation({reinterpret_cast<const char*>(exif), bytes});
}

/// Interlaced rows are whole after the last pass only.
void PngRows::read_all() {
    attempt(core::Pattern<0>("cannot be read to its end"), [this] {
        for (int pass = png_set_interlace_handling(png_); pass > 0; --pass)
            for (int y = 0; y < head_.height; ++y)
                png_read_row(png_, &stored_[row_bytes_ * static_cast<std::size_t>(y)], nullptr);
    });
}

void PngRows::widen(const png_byte* row, float* values) const {
    const int count = head_.width * head_.channels();
    for (int i = 0; i < count; ++i)
        values[i] = is_deep_ ? static_cast<float>(256 * row[2 * i] + row[2 * i + 1]) / 65535.0F
                             : static_cast<float>(row[i]) / 255.0F;
}

void PngRows::read(int count, float* rows) {
    const std::size_t values = std::size_t{1} * head_.width * head_.channels();
    if (is_interlaced_ && next_row_ == 0) read_all();
    for (int y = 0; y < count; ++y, ++next_row_) {
        const std::size_t place = is_interlaced_ ? row_bytes_ * static_cast<std::size_t>(next_row_) : 0;
        if (!is_interlaced_)
            attempt(core::Pattern<0>("cannot be read to its end"),
                    [this] { png_read_row(png_, stored_.data(), nullptr); });
        widen(&stored_[place], rows + values * static_cast<std::size_t>(y));
    }
}

void PngRows::finish() {
    attempt(core::Pattern<0>("cannot be read to its end"), [this] { png_read_end(png_, nullptr); });
}

}  // namespace

std::unique_ptr<PictureRows> png_rows(NextBytes source, std::string name) {
    auto rows = std::make_unique<PngRows>(std::move(source), std::move(name));
    rows->open();
    return rows;
}

}  // namespace pastoso::files
