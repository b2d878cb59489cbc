// What a cell of amounts is expected to hold, all channels in registers: for the kernels of one
// instruction set, all of which round alike.
#pragma once

#include "grid/shape.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace pastoso::packing::PASTOSO_ISA {
namespace {

#define PASTOSO_LANE_FUNCTION [[gnu::always_inline]] inline

/// The doubles that a register holds.
#if defined(__AVX512F__)
constexpr int kLanes = 8;
#elif defined(__AVX2__)
constexpr int kLanes = 4;
#else
constexpr int kLanes = 2;
#endif
using Numbers [[gnu::vector_size(8 * kLanes)]] = double;
using Counts [[gnu::vector_size(8 * kLanes)]] = std::int64_t;
using Wholes [[gnu::vector_size(4 * kLanes)]] = std::int32_t;
using Words [[gnu::vector_size(4 * kLanes)]] = std::uint32_t;

/// A number for each channel; lanes beyond the last hold 0.
template <int kChannels>
constexpr int kRegisters = (kChannels + kLanes - 1) / kLanes;
template <class Lanes, int kChannels>
using Cell = std::array<Lanes, kRegisters<kChannels>>;

template <int kChannels>
PASTOSO_LANE_FUNCTION Cell<Words, kChannels> load(const std::uint32_t* words) {
    Cell<Words, kChannels> cell{};
    std::memcpy(cell.data(), words, sizeof(std::uint32_t) * kChannels);
    return cell;
}

template <int kChannels>
PASTOSO_LANE_FUNCTION void store(const Cell<Words, kChannels>& cell, std::uint32_t* words) {
    std::memcpy(words, cell.data(), sizeof(std::uint32_t) * kChannels);
}

template <int kBy, std::size_t... kLane>
PASTOSO_LANE_FUNCTION void turn(Counts& lanes, std::index_sequence<kLane...>) {
    lanes = __builtin_shufflevector(lanes, lanes, ((kLane + kBy) % kLanes)...);
}

/// Every lane becomes what `better` leaves of all.
template <class Better, int kBy = kLanes / 2>
PASTOSO_LANE_FUNCTION void reduce(Counts& lanes, const Better& better) {
    Counts others = lanes;
    turn<kBy>(others, std::make_index_sequence<kLanes>());
    better(lanes, others);
    if constexpr (kBy > 1) reduce<Better, kBy / 2>(lanes, better);
}

/// The channels of a register.
template <class Lanes>
PASTOSO_LANE_FUNCTION void count_from(int first, Lanes& lanes) {
    for (int lane = 0; lane < kLanes; ++lane)
        lanes[lane] = static_cast<std::remove_cvref_t<decltype(lanes[0])>>(first + lane);
}

/// The first of the numbers that are farthest from 0. Magnitudes are compared as bits, which are in the
/// same order.
template <std::size_t kCount>
PASTOSO_LANE_FUNCTION int place_of_farthest(const std::array<Numbers, kCount>& numbers) {
    constexpr std::int64_t kMagnitude = 0x7fffffffffffffff;
    constexpr std::int64_t kNowhere = kCount * kLanes;
    const auto larger = [](Counts& a, const Counts& b) { a = a > b ? a : b; };
    const auto smaller = [](Counts& a, const Counts& b) { a = a < b ? a : b; };
    std::array<Counts, kCount> magnitudes;
    Counts largest{};
    for (std::size_t i = 0; i < kCount; ++i) {
        magnitudes[i] = reinterpret_cast<const Counts&>(numbers[i]) & kMagnitude;
        larger(largest, magnitudes[i]);
    }
    reduce(largest, larger);
    Counts place = Counts{} + kNowhere, channels{};
    for (std::size_t i = kCount; i-- > 0;) {
        count_from(static_cast<int>(i) * kLanes, channels);
        place = magnitudes[i] == largest ? channels : place;
    }
    reduce(place, smaller);
    return static_cast<int>(place[0]);
}

/// Where there are a cell to the left and one above, paints mix on the line between the two: how far
/// along it the cell lies is learned of the channel in which they differ most.
template <int kChannels>
class AmountGuess {
  public:
    AmountGuess(const std::uint32_t* words, const std::int32_t* amount, int cell) {
        if (cell == 0) return;
        const int above = cell - grid::kTileSize;
        const bool is_first = cell % grid::kTileSize == 0;
        const int neighbour = is_first ? above : cell - 1;
        guess_ = scaled(words + neighbour * kChannels, growth(amount, cell, neighbour));
        if (above < 0 || is_first) return;
        way_ = scaled(words + above * kChannels, growth(amount, cell, above));
        for (std::size_t i = 0; i < way_.size(); ++i)
            way_[i] -= guess_[i];
        first_ = place_of_farthest(way_);
    }

    /// The channel that is told first, and its word.
    int first() const { return first_; }
    std::uint32_t first_word() const {
        return static_cast<std::uint32_t>(
            static_cast<std::int32_t>(std::clamp(of_first(guess_), kLeast, kMost)));
    }
    /// What it is in truth; the guess is for the others from now on.
    void learn(std::uint32_t first_word) {
        const double way = of_first(way_);
        if (way == 0.0) return;
        const double gone =
            static_cast<double>(static_cast<std::int32_t>(first_word)) - of_first(guess_);
        const double share = std::min(std::max(gone / way, -1.0), 1.0);
        for (std::size_t i = 0; i < way_.size(); ++i)
            guess_[i] += share * way_[i];
    }
    Cell<Words, kChannels> words() const {
        Cell<Words, kChannels> words;
        for (std::size_t i = 0; i < words.size(); ++i) {
            Numbers exact = guess_[i];
            exact = exact < kLeast ? Numbers{} + kLeast : exact;
            exact = exact > kMost ? Numbers{} + kMost : exact;
            const Wholes rounded = __builtin_convertvector(exact, Wholes);
            words[i] = reinterpret_cast<const Words&>(rounded);
        }
        return words;
    }
    /// Puts what is known of the first channel among the others.
    void put_first(std::uint32_t word, Cell<Words, kChannels>& words) const {
        Words channels{};
        for (std::size_t i = 0; i < words.size(); ++i) {
            count_from(static_cast<int>(i) * kLanes, channels);
            words[i] = channels == static_cast<std::uint32_t>(first_) ? Words{} + word : words[i];
        }
    }

  private:
    static constexpr double kLeast = -2147483648.0, kMost = 2147483647.0;

    /// amount / neighbour's amount; 1 where the neighbour has none.
    static double growth(const std::int32_t* amount, int cell, int neighbour) {
        if (amount[neighbour] == 0) return 1.0;
        return static_cast<double>(amount[cell]) / static_cast<double>(amount[neighbour]);
    }
    static Cell<Numbers, kChannels> scaled(const std::uint32_t* words, double factor) {
        const Cell<Words, kChannels> cell = load<kChannels>(words);
        Cell<Numbers, kChannels> scaled;
        for (std::size_t i = 0; i < cell.size(); ++i)
            scaled[i] =
                __builtin_convertvector(reinterpret_cast<const Wholes&>(cell[i]), Numbers) * factor;
        return scaled;
    }
    double of_first(const Cell<Numbers, kChannels>& numbers) const {
        double number;
        std::memcpy(&number, reinterpret_cast<const std::byte*>(numbers.data()) + sizeof number * first_,
                    sizeof number);
        return number;
    }

    Cell<Numbers, kChannels> guess_{}, way_{};
    int first_ = 0;
};

}  // namespace
}  // namespace pastoso::packing::PASTOSO_ISA
