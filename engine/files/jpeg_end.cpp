#include "files/jpeg_end.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace pastoso::files {
namespace {

constexpr int kPrefix = 0xFF, kStartOfPicture = 0xD8, kEndOfPicture = 0xD9;

/// The bytes of a file in turn.
class Bytes {
  public:
    explicit Bytes(const core::RegularFile& file) : file_(file) {}

    /// Nothing at the end.
    std::optional<int> next() {
        constexpr std::size_t kBlockBytes = 1 << 16;
        if (next_ == block_.size()) {
            begin_ += block_.size();
            block_ = file_.text_at(begin_, kBlockBytes);
            next_ = 0;
            if (block_.empty()) return std::nullopt;
        }
        return static_cast<unsigned char>(block_[next_++]);
    }

    void skip(std::uint64_t count) {
        const std::uint64_t left = block_.size() - next_;
        if (count <= left) {
            next_ += static_cast<std::size_t>(count);
            return;
        }
        begin_ += block_.size() + (count - left);
        block_.clear();
        next_ = 0;
    }

  private:
    const core::RegularFile& file_;
    std::string block_;
    std::uint64_t begin_ = 0;  ///< of the block in the file
    std::size_t next_ = 0;
};

/// The code of the next marker; coded values, stuffing and fill bytes are passed over.
std::optional<int> next_marker(Bytes& bytes) {
    std::optional<int> byte = bytes.next();
    while (byte) {
        while (byte && *byte != kPrefix)
            byte = bytes.next();
        while (byte && *byte == kPrefix)
            byte = bytes.next();
        if (byte && *byte != 0) return byte;
    }
    return std::nullopt;
}

bool stands_alone(int marker) {
    constexpr int kTemporary = 0x01, kFirstRestart = 0xD0;
    return marker == kTemporary || (marker >= kFirstRestart && marker <= kStartOfPicture);
}

}  // namespace

bool jpeg_has_end(const core::RegularFile& file) {
    Bytes bytes(file);
    while (const std::optional<int> marker = next_marker(bytes)) {
        if (*marker == kEndOfPicture) return true;
        if (stands_alone(*marker)) continue;
        const std::optional<int> high = bytes.next(), low = bytes.next();
        if (!low) return false;
        const int length = 256 * *high + *low;
        if (length > 2) bytes.skip(static_cast<std::uint64_t>(length - 2));
    }
    return false;
}

}  // namespace pastoso::files
