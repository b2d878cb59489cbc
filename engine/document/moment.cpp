#include "document/moment.hpp"

#include "document/well.hpp"

#include <mutex>
#include <utility>

namespace pastoso::document {
namespace {

/// Of the canvas and of the well.
template <class Tiles>
struct BothSurfaces {
    Tiles canvas;
    std::optional<Tiles> well;

    std::size_t bytes() const { return canvas.bytes() + (well ? well->bytes() : 0); }
};

const film::FilmState& well_of(const Moment& moment, const film::FilmState& bare) {
    return moment.well ? moment.well->film : bare;
}

Moment without_films(const Moment& moment) {
    Moment rest = moment;
    rest.canvas.film = {};
    if (rest.well) rest.well->film = {};
    return rest;
}

std::size_t bytes_without_films(const Moment& moment) {
    std::size_t bytes = sizeof(Moment) + moment.canvas.awake.size() / 8;
    if (moment.brush)
        bytes += moment.brush->held.size() * sizeof(brush::Contents) +
                 moment.brush->tip.bristles.size() * sizeof(brush::Bristle);
    return bytes;
}

/// Makes the older moment's films of the newer one's.
template <class Tiles>
void put(const BothSurfaces<Tiles>& both, Moment& moment) {
    both.canvas.put_into(moment.canvas.film);
    if (both.well) both.well->put_into(moment.well->film);
}

}  // namespace

/// Either as they are or packed.
struct MomentDifference::Tiles {
    /// The older films as well, for what they are packed with.
    struct Raw {
        BothSurfaces<FilmTiles> tiles;
        film::FilmState canvas, well;
    };
    using Packed = BothSurfaces<PackedFilmTiles>;

    static std::shared_ptr<const Raw> taken(const Moment& older, const Moment& newer) {
        const film::FilmState bare = bare_well();
        auto raw = std::make_shared<Raw>();
        raw->tiles.canvas = FilmTiles(older.canvas.film, newer.canvas.film);
        raw->canvas = older.canvas.film;
        if (!older.well) return raw;
        raw->tiles.well = FilmTiles(older.well->film, well_of(newer, bare));
        raw->well = older.well->film;
        return raw;
    }

    static std::shared_ptr<const Packed> packed_of(const Raw& raw) {
        auto packed = std::make_shared<Packed>();
        packed->canvas = PackedFilmTiles(raw.tiles.canvas, raw.canvas);
        if (raw.tiles.well) packed->well = PackedFilmTiles(*raw.tiles.well, raw.well);
        return packed;
    }

    template <class Form>
    Form locked(Form Tiles::*form) const {
        const std::lock_guard lock(mutex);
        return this->*form;
    }

    /// Two threads may do this at once: the first that is ready has done it.
    void pack() {
        const auto source = locked(&Tiles::raw);
        if (source == nullptr) return;
        auto result = packed_of(*source);
        const std::lock_guard lock(mutex);
        if (packed == nullptr) packed = std::move(result);
        raw.reset();
    }

    mutable std::mutex mutex;
    std::shared_ptr<const Raw> raw;        ///< null once they are packed
    std::shared_ptr<const Packed> packed;  ///< null until then
};

MomentDifference::MomentDifference(const Moment& older, const Moment& newer)
    : rest_(without_films(older)),
      rest_bytes_(bytes_without_films(older)),
      tiles_(std::make_shared<Tiles>()) {
    tiles_->raw = Tiles::taken(older, newer);
    bytes_ = rest_bytes_ + tiles_->raw->tiles.bytes();
}

Moment MomentDifference::applied_to(const Moment& newer) const {
    Moment older = rest_;
    older.canvas.film = newer.canvas.film;
    if (older.well) older.well->film = newer.well ? newer.well->film : bare_well();
    if (const auto raw = tiles_->locked(&Tiles::raw))
        put(raw->tiles, older);
    else
        put(*tiles_->locked(&Tiles::packed), older);
    return older;
}

void MomentDifference::pack_on(core::BackgroundThread& thread) {
    if (packing_) return;
    packing_ = true;
    thread.add([weak = std::weak_ptr(tiles_)] {
        if (const auto tiles = weak.lock()) tiles->pack();
    });
}

void MomentDifference::pack() {
    tiles_->pack();
}

std::optional<std::size_t> MomentDifference::packed_bytes() const {
    const auto packed = tiles_->locked(&Tiles::packed);
    if (packed == nullptr) return std::nullopt;
    return rest_bytes_ + packed->bytes();
}

}  // namespace pastoso::document
