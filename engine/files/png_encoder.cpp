#include "files/png_encoder.hpp"

#include "core/check.hpp"
#include "core/error.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <new>
#include <png.h>
#include <span>
#include <utility>

namespace pastoso::files {

/// What the functions that libpng calls know.
struct PngEncoder::Talk {
    core::Message name;
    ByteSink sink;
    std::uint64_t place = 0;  ///< of the next byte
    std::array<char, 256> complaint{};
    std::exception_ptr failure{};  ///< of the sink

    /// No exception may pass through libpng.
    bool hand_on(std::span<const std::byte> bytes) noexcept {
        try {
            sink(place, bytes);
            place += bytes.size();
            return true;
        } catch (...) {
            failure = std::current_exception();
            return false;
        }
    }

    [[noreturn]] static void fail(png_structp png, png_const_charp complaint) {
        std::array<char, 256>& told = static_cast<Talk*>(png_get_error_ptr(png))->complaint;
        std::snprintf(told.data(), told.size(), "%s", complaint);
        png_longjmp(png, 1);
    }
    static void warn(png_structp, png_const_charp) {}

    static void take(png_structp png, png_bytep bytes, std::size_t count) {
        auto& talk = *static_cast<Talk*>(png_get_io_ptr(png));
        if (!talk.hand_on(std::as_bytes(std::span(bytes, count)))) png_error(png, "no room for it");
    }
    static void flush(png_structp) {}
};

namespace {

constexpr int kColourTypes[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                PNG_COLOR_TYPE_RGB_ALPHA};

int bits_of(const PastosoPicture& picture) {
    PASTOSO_CHECK(picture.sample_type == kPastosoUint8 || picture.sample_type == kPastosoUint16);
    return picture.sample_type == kPastosoUint8 ? 8 : 16;
}

int colour_type(const PastosoPicture& picture) {
    PASTOSO_CHECK(picture.channels >= 1 && picture.channels <= 4);
    return kColourTypes[picture.channels - 1];
}

void set_text(png_structp png, png_infop info, const char* key, const char* text) {
    if (text == nullptr) return;
    png_text entry{};
    entry.compression = PNG_TEXT_COMPRESSION_NONE;
    entry.key = const_cast<char*>(key);
    entry.text = const_cast<char*>(text);
    png_set_text(png, info, &entry, 1);
}

void set_place_and_meaning(png_structp png, png_infop info, const PastosoPicture& picture) {
    if (picture.icc_profile != nullptr) {
        png_set_iCCP(png, info, "Embedded Profile", PNG_COMPRESSION_TYPE_BASE,
                     static_cast<png_const_bytep>(picture.icc_profile),
                     static_cast<png_uint_32>(picture.icc_bytes));
    }
    if (picture.px_per_mm > 0.0) {
        const auto px_per_m = static_cast<png_uint_32>(std::lround(1000.0 * picture.px_per_mm));
        png_set_pHYs(png, info, px_per_m, px_per_m, PNG_RESOLUTION_METER);
    }
}

}  // namespace

PngEncoder::PngEncoder(core::Message name, const PastosoPicture& picture, ByteSink sink)
    : talk_(std::make_unique<Talk>()),
      row_bytes_(std::size_t{1} * static_cast<unsigned>(picture.width) *
                 static_cast<unsigned>(picture.channels * bits_of(picture) / 8)) {
    talk_->name = std::move(name);
    talk_->sink = std::move(sink);
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, talk_.get(), &Talk::fail, &Talk::warn);
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
    try {
        if (info_ == nullptr) throw std::bad_alloc();
        write_head(picture);
    } catch (...) {
        png_destroy_write_struct(&png_, &info_);
        throw;
    }
}

PngEncoder::~PngEncoder() {
    png_destroy_write_struct(&png_, &info_);
}

/// Does what libpng leaves with a jump where something is wrong: the work may hold nothing that must be
/// freed.
template <class Work>
void PngEncoder::attempt(Work&& work) {
    if (setjmp(png_jmpbuf(png_)) == 0) {
        work();
        return;
    }
    if (talk_->failure) std::rethrow_exception(std::exchange(talk_->failure, nullptr));
    throw core::InputError("%1: cannot be written (%2).", talk_->name, talk_->complaint.data());
}

void PngEncoder::write_head(const PastosoPicture& picture) {
    const int bits = bits_of(picture), type = colour_type(picture);
    attempt([&] {
        png_set_write_fn(png_, talk_.get(), &Talk::take, &Talk::flush);
        png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
        png_set_compression_level(png_, picture.png_effort);
        png_set_IHDR(png_, info_, static_cast<png_uint_32>(picture.width),
                     static_cast<png_uint_32>(picture.height), bits, type, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        set_place_and_meaning(png_, info_, picture);
        set_text(png_, info_, "Software", picture.software);
        set_text(png_, info_, "Description", picture.description);
        png_write_info(png_, info_);
        if (bits == 16 && std::endian::native == std::endian::little) png_set_swap(png_);
    });
}

void PngEncoder::write_rows(const void* rows, int count) {
    const auto* row = static_cast<const png_byte*>(rows);
    attempt([this, row, count] {
        for (int y = 0; y < count; ++y)
            png_write_row(png_, row + row_bytes_ * static_cast<std::size_t>(y));
    });
}

void PngEncoder::finish() {
    attempt([this] { png_write_end(png_, nullptr); });
}

}  // namespace pastoso::files
