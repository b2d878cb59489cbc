#include "document/history.hpp"

#include "core/check.hpp"
#include "document/well.hpp"

namespace pastoso::document {
namespace {

template <class T>
std::size_t unshared_field_bytes(const grid::TiledField<T>& older, const grid::TiledField<T>& newer) {
    std::size_t tiles = 0;
    for (int tile = 0; tile < older.tile_count(); ++tile) {
        tiles += !older.is_background(tile) && !older.shares_tile(newer, tile) ? 1 : 0;
    }
    return tiles * sizeof(T) * grid::kTileCells;
}

std::size_t unshared_field_bytes(const film::SupportHeights& older, const film::SupportHeights& newer) {
    std::size_t bytes = 0;
    for (int tile = 0; tile < older.tile_count(); ++tile)
        if (!older.is_background(tile) && !older.shares_tile(newer, tile))
            bytes += older.block(tile).bytes();
    return bytes;
}

}  // namespace

std::size_t unshared_bytes(const film::FilmState& older, const film::FilmState& newer) {
    return unshared_field_bytes(older.thickness, newer.thickness) +
           unshared_field_bytes(older.paint, newer.paint) +
           unshared_field_bytes(older.velocity_x, newer.velocity_x) +
           unshared_field_bytes(older.velocity_y, newer.velocity_y) +
           unshared_field_bytes(older.support_mm, newer.support_mm) +
           unshared_field_bytes(older.strata.soluble_thickness, newer.strata.soluble_thickness) +
           unshared_field_bytes(older.strata.soluble_pigment, newer.strata.soluble_pigment) +
           unshared_field_bytes(older.strata.ground, newer.strata.ground) +
           unshared_field_bytes(older.strata.uppermost, newer.strata.uppermost);
}

std::size_t unshared_bytes(const Moment& older, const Moment& newer) {
    const std::size_t canvas = unshared_bytes(older.film, newer.film);
    if (!older.well) return canvas;
    return canvas + unshared_bytes(*older.well, newer.well ? *newer.well : bare_well());
}

void History::set_budget(std::size_t bytes) {
    budget_bytes_ = bytes;
    if (bytes == 0) future_.clear();
    drop_oldest_beyond_budget();
}

void History::remember(Moment before) {
    future_.clear();
    push(std::move(before));
    drop_oldest_beyond_budget();
}

Moment History::step_back(Moment now) {
    PASTOSO_CHECK(can_undo());
    Moment moment = std::move(past_.back().moment);
    past_.pop_back();
    if (!past_.empty()) {
        past_bytes_ -= past_.back().bytes;
        past_.back().bytes = 0;
    }
    future_.push_back(std::move(now));
    return moment;
}

Moment History::step_forward(Moment now) {
    PASTOSO_CHECK(can_redo());
    Moment moment = std::move(future_.back());
    future_.pop_back();
    push(std::move(now));
    return moment;
}

/// The newest moment shares its tiles with the living painting and counts nothing until the next one
/// comes.
void History::push(Moment moment) {
    if (!past_.empty()) {
        past_.back().bytes = unshared_bytes(past_.back().moment, moment);
        past_bytes_ += past_.back().bytes;
    }
    past_.push_back({std::move(moment), 0});
}

void History::drop_oldest_beyond_budget() {
    const auto too_much = [&] {
        return past_bytes_ > budget_bytes_ || past_.size() > kMostMoments || budget_bytes_ == 0;
    };
    while (!past_.empty() && too_much()) {
        past_bytes_ -= past_.front().bytes;
        past_.pop_front();
    }
}

}  // namespace pastoso::document
