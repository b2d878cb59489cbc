// What a cell of amounts is expected to hold, all channels in registers: for the kernels of one
// instruction set, all of which round alike.
#pragma once

#include "core/lane_memory.hpp"
#include "grid/shape.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace pastoso::packing::PASTOSO_ISA {
namespace {

namespace lanes = core::lanes;

using Numbers = lanes::Widest<double>;
using Counts = lanes::As<std::int64_t, Numbers>;
using Words = lanes::As<std::uint32_t, Numbers>;
constexpr int kLanes = Numbers::kLanes;

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

template <int kBy, int... kLane>
PASTOSO_LANE_FUNCTION Counts turned(Counts counts, std::integer_sequence<int, kLane...>) {
    return lanes::permuted<((kLane + kBy) % kLanes)...>(counts);
}

/// In every lane what `better` leaves of all.
template <class Better, int kBy = kLanes / 2>
PASTOSO_LANE_FUNCTION Counts reduced(Counts counts, const Better& better) {
    counts = better(counts, turned<kBy>(counts, std::make_integer_sequence<int, kLanes>()));
    if constexpr (kBy > 1) return reduced<Better, kBy / 2>(counts, better);
    return counts;
}

/// The first of the numbers that are farthest from 0. Magnitudes are compared as bits, which are in the
/// same order.
template <std::size_t kCount>
PASTOSO_LANE_FUNCTION int place_of_farthest(const std::array<Numbers, kCount>& numbers) {
    constexpr std::int64_t kMagnitude = 0x7fffffffffffffff;
    constexpr std::int64_t kNowhere = kCount * kLanes;
    const auto larger = [](Counts a, Counts b) { return lanes::max(a, b); };
    const auto smaller = [](Counts a, Counts b) { return lanes::min(a, b); };
    std::array<Counts, kCount> magnitudes;
    Counts largest(0);
    for (std::size_t i = 0; i < kCount; ++i) {
        magnitudes[i] = lanes::bits<std::int64_t>(numbers[i]) & kMagnitude;
        largest = larger(largest, magnitudes[i]);
    }
    largest = reduced(largest, larger);
    Counts place(kNowhere);
    for (std::size_t i = kCount; i-- > 0;) {
        const Counts channels = lanes::counting<Counts>() + static_cast<std::int64_t>(i) * kLanes;
        place = lanes::select(magnitudes[i] == largest, channels, place);
    }
    return static_cast<int>(reduced(place, smaller)[0]);
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
            const Numbers exact = lanes::min(Numbers(kMost), lanes::max(Numbers(kLeast), guess_[i]));
            words[i] = lanes::bits<std::uint32_t>(lanes::convert<std::int32_t>(exact));
        }
        return words;
    }
    /// Puts what is known of the first channel among the others.
    void put_first(std::uint32_t word, Cell<Words, kChannels>& words) const {
        for (std::size_t i = 0; i < words.size(); ++i) {
            const Words channels = lanes::counting<Words>() + static_cast<std::uint32_t>(i) * kLanes;
            words[i] =
                lanes::select(channels == static_cast<std::uint32_t>(first_), Words(word), words[i]);
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
            scaled[i] = lanes::convert<double>(lanes::bits<std::int32_t>(cell[i])) * factor;
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
