#include "files/new_head.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::files {

NewHead::NewHead(std::size_t head_bytes, std::function<std::string(std::string_view)> make, ByteSink next)
    : head_bytes_(head_bytes), make_(std::move(make)), next_(std::move(next)) {}

void NewHead::write_at(std::uint64_t place, std::span<const std::byte> bytes) {
    const std::size_t in_head = head_.size() < head_bytes_ ? take_head(place, bytes) : 0;
    if (in_head == bytes.size()) return;
    PASTOSO_CHECK_OP(place + in_head, >=, head_bytes_);
    next_(place + in_head - head_bytes_ + new_bytes_, bytes.subspan(in_head));
}

/// How many of the bytes belong to the head.
std::size_t NewHead::take_head(std::uint64_t place, std::span<const std::byte> bytes) {
    PASTOSO_CHECK_OP(place, ==, head_.size());
    const std::size_t count = std::min(bytes.size(), head_bytes_ - head_.size());
    head_.append(reinterpret_cast<const char*>(bytes.data()), count);
    if (head_.size() < head_bytes_) return count;
    const std::string made = make_(head_);
    new_bytes_ = made.size();
    next_(0, std::as_bytes(std::span(made)));
    return count;
}

}  // namespace pastoso::files
