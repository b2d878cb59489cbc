#include "packing/packed_bytes.hpp"

#include "core/check.hpp"
#include "core/error.hpp"

#include <zstd.h>

namespace pastoso::packing {
namespace {

/// The fastest that still finds the long runs of zeros in tiles; higher ones gain little on the rest,
/// which is noise.
constexpr int kLevel = 1;

}  // namespace

struct Packer::Context {
    ZSTD_CCtx* zstd = ZSTD_createCCtx();
    ~Context() { ZSTD_freeCCtx(zstd); }
};

Packer::Packer() : context_(std::make_unique<Context>()) {
    PASTOSO_CHECK(context_->zstd != nullptr);
    ZSTD_CCtx_setParameter(context_->zstd, ZSTD_c_compressionLevel, kLevel);
    ZSTD_CCtx_setParameter(context_->zstd, ZSTD_c_checksumFlag, 1);
}

Packer::~Packer() = default;

Bytes Packer::packed(std::span<const std::byte> bytes) {
    const std::size_t most = ZSTD_compressBound(bytes.size());
    if (room_.size() < most) room_.resize(most);
    const std::size_t size =
        ZSTD_compress2(context_->zstd, room_.data(), room_.size(), bytes.data(), bytes.size());
    PASTOSO_CHECK(!ZSTD_isError(size));
    return {room_.begin(), room_.begin() + static_cast<std::ptrdiff_t>(size)};
}

Bytes packed(std::span<const std::byte> bytes) {
    return Packer().packed(bytes);
}

struct Unpacker::Context {
    ZSTD_DCtx* zstd = ZSTD_createDCtx();
    ~Context() { ZSTD_freeDCtx(zstd); }
};

Unpacker::Unpacker() : context_(std::make_unique<Context>()) {
    PASTOSO_CHECK(context_->zstd != nullptr);
}

Unpacker::~Unpacker() = default;

std::span<const std::byte> Unpacker::unpacked(std::span<const std::byte> frame, std::size_t size) {
    if (ZSTD_getFrameContentSize(frame.data(), frame.size()) != size)
        throw core::InputError("is damaged (its length is not the one that is noted).");
    if (room_.size() < size) room_.resize(size);
    const std::size_t found =
        ZSTD_decompressDCtx(context_->zstd, room_.data(), size, frame.data(), frame.size());
    if (ZSTD_isError(found) || found != size)
        throw core::InputError("is damaged (it cannot be decompressed, or its checksum is another).");
    return std::span(room_).first(size);
}

Bytes unpacked(std::span<const std::byte> frame, std::size_t size) {
    Unpacker unpacker;
    const std::span<const std::byte> content = unpacker.unpacked(frame, size);
    return {content.begin(), content.end()};
}

std::size_t most_packed_bytes(std::size_t size) {
    return ZSTD_compressBound(size);
}

std::span<const std::byte> bytes_of(const std::string& text) {
    return std::as_bytes(std::span(text));
}

}  // namespace pastoso::packing
