#include "document/packed_moves.hpp"

#include "core/check.hpp"

#include <bit>
#include <span>
#include <utility>

namespace pastoso::document {
namespace {

using Numbers = PackedMoves::Numbers;

constexpr std::size_t kBlockBytes = 64 * 1024;

/// The lengths of the nine differences in bytes, 0 to 8, four bits each; then their bytes, the lowest
/// first.
constexpr std::size_t kLengthsBytes = 5;
constexpr std::size_t kMostMoveBytes = kLengthsBytes + PackedMoves::kNumbers * sizeof(std::uint64_t);

Numbers numbers_of(const TimedSample& move) {
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    const brush::PenSample& sample = move.sample;
    return {static_cast<std::uint64_t>(move.tick),
            bits(sample.time_s),
            bits(sample.x_mm),
            bits(sample.y_mm),
            bits(sample.pressure),
            bits(sample.tilt_x_deg),
            bits(sample.tilt_y_deg),
            bits(sample.rotation_deg),
            bits(sample.wheel)};
}

TimedSample move_of(const Numbers& numbers) {
    const auto value = [&](int i) { return std::bit_cast<double>(numbers[i]); };
    return {static_cast<std::int64_t>(numbers[0]),
            {value(1), value(2), value(3), value(4), value(5), value(6), value(7), value(8)}};
}

/// Small differences of either sign become small numbers: 0, -1, 1, -2 ... are 0, 1, 2, 3 ...
std::uint64_t folded(std::uint64_t difference) {
    return (difference << 1) ^ (std::uint64_t{0} - (difference >> 63));
}
std::uint64_t unfolded(std::uint64_t number) {
    return (number >> 1) ^ (std::uint64_t{0} - (number & 1));
}

int bytes_needed(std::uint64_t number) {
    return (std::bit_width(number) + 7) / 8;
}

void append(std::uint64_t number, std::size_t count, std::vector<std::byte>& bytes) {
    for (std::size_t i = 0; i < count; ++i)
        bytes.push_back(static_cast<std::byte>(number >> (8 * i)));
}

std::uint64_t taken(std::span<const std::byte> bytes, std::size_t count, std::size_t& place) {
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < count; ++i)
        number |= std::to_integer<std::uint64_t>(bytes[place++]) << (8 * i);
    return number;
}

void go_on(Numbers next, Numbers& last, Numbers& before) {
    before = last;
    last = next;
}

}  // namespace

void PackedMoves::add(const TimedSample& move) {
    if (open_.size() + kMostMoveBytes > kBlockBytes)
        full_.push_back(std::make_shared<const Block>(std::exchange(open_, {})));
    open_.reserve(kBlockBytes);
    const Numbers numbers = numbers_of(move);
    Numbers differences{};
    std::uint64_t lengths = 0;
    for (int i = 0; i < kNumbers; ++i) {
        differences[i] = folded(numbers[i] - (2 * last_[i] - before_[i]));
        lengths |= static_cast<std::uint64_t>(bytes_needed(differences[i])) << (4 * i);
    }
    append(lengths, kLengthsBytes, open_);
    for (int i = 0; i < kNumbers; ++i)
        append(differences[i], lengths >> (4 * i) & 15, open_);
    go_on(numbers, last_, before_);
    ++size_;
}

std::size_t PackedMoves::bytes() const {
    return (full_.size() + (open_.empty() ? 0 : 1)) * kBlockBytes;
}

const PackedMoves::Block& PackedMoves::block(std::size_t index) const {
    return index < full_.size() ? *full_[index] : open_;
}

TimedSample PackedMoves::Reader::next() {
    if (place_ == moves_.block(block_).size()) {
        ++block_;
        place_ = 0;
    }
    PASTOSO_CHECK_OP(block_, <=, moves_.full_.size());
    const std::span<const std::byte> block(moves_.block(block_));
    PASTOSO_CHECK_OP(place_, <, block.size());
    const std::uint64_t lengths = taken(block, kLengthsBytes, place_);
    Numbers numbers{};
    for (int i = 0; i < kNumbers; ++i)
        numbers[i] = 2 * last_[i] - before_[i] + unfolded(taken(block, lengths >> (4 * i) & 15, place_));
    go_on(numbers, last_, before_);
    return move_of(numbers);
}

}  // namespace pastoso::document
