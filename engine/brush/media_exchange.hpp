// Which media a tool lays and takes, on a film of several (film/cell/wet_media.hpp). The paint of a tool
// counts as mixed through: all its hairs hold its media in the same shares.
#pragma once

#include "brush/transfer_kernels.hpp"
#include "film/state.hpp"
#include "grid/shape.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace pastoso::brush {

struct Brush;

/// The media by their places in the film's list.
struct MediaExchange {
    std::array<float, film::kMostMedia> given{};          ///< shares of what is laid, 1 in all
    std::array<std::int64_t, film::kMostMedia> gained{};  ///< by the film, quanta

    /// Gives what this much was of, of each medium; nothing else.
    void give_shares_of(const std::array<double, film::kMostMedia>& amounts);
    /// What most of it is.
    int main() const;
    bool gives_only(int medium) const { return given[medium] == 1.0F; }
};

/// Makes the media that a brush holds media of the film. None where all is of one.
std::optional<MediaExchange> meet_media(Brush& brush, film::FilmState& film);

/// Takes what the film gained from the brush, whose shares are those given from now on.
void settle_exchange(MediaExchange& media, const film::FilmState& film, Brush& brush);

/// Sets the volumes of a brush's media to what it holds after a stroke; where the film is of one, all
/// that the brush has taken is, too.
void weigh_media(const film::FilmState& film, Brush& brush);

/// Makes room for other media in the tiles that paint may be laid in or taken from, before that, and by
/// one thread. What was bare is of what most of the tool's paint is.
void prepare_media(const MediaExchange& media, const grid::Rect& cells, film::FilmState& film);

/// Moves media along with what cells of a tile have gained and lost. Call it when their thickness is new
/// and `cells.held` is still the old one.
void exchange_media(const ApplyRule& rule, const TileCells& cells, int tile, film::FilmState& film,
                    MediaExchange& media);

}  // namespace pastoso::brush
