#include "document/moment.hpp"

#include "document/well.hpp"

#include <functional>
#include <mutex>
#include <type_traits>
#include <utility>

namespace pastoso::document {
namespace {

/// Fields whose bytes are those of the struct, or shared by every moment.
template <class Field>
constexpr bool kCountedByItsSize =
    std::is_trivially_copyable_v<Field> || std::is_same_v<Field, UseMedium> ||
    std::is_same_v<Field, std::shared_ptr<const BareCanvas>>;

/// Of all layers and of the well.
template <class Tiles>
struct AllFilms {
    std::vector<std::optional<Tiles>> layers;  ///< none: the film is the newer moment's, shared
    std::optional<Tiles> well;                 ///< none: it was bare

    std::size_t bytes() const {
        std::size_t sum = well ? well->bytes() : 0;
        for (const auto& layer : layers)
            sum += layer ? layer->bytes() : 0;
        return sum;
    }
};

const Layer* layer_of(const Moment& moment, LayerId id) {
    for (const Layer& layer : moment.value.layers.layers)
        if (layer.id == id) return &layer;
    return nullptr;
}

bool is_active(const Moment& moment, std::size_t place) {
    return place == moment.value.layers.active;
}

/// Whether both have the very same film, inactive.
bool is_shared(const Moment& older, std::size_t place, const Moment& newer) {
    const Layer& layer = older.value.layers.layers[place];
    const Layer* then = layer_of(newer, layer.id);
    return !is_active(older, place) && then != nullptr && then->inactive == layer.inactive;
}

const film::FilmState& film_of(const Moment& moment, std::size_t place) {
    return is_active(moment, place) ? moment.value.film : *moment.value.layers.layers[place].inactive;
}

CanvasCells cells_of(const Moment& moment) {
    return {moment.value.film.shape, moment.value.film.cell_mm};
}

film::FilmState film_of_layer(const Moment& moment, LayerId id) {
    const film::FilmState& canvas = moment.value.film;
    const Layer* layer = layer_of(moment, id);
    if (layer == nullptr) return {canvas.shape, canvas.cell_mm};
    return layer->inactive ? *layer->inactive : canvas;
}

/// What the tiles of an older moment's layer are told against: the newer moment's film of that layer, if
/// there is one of such cells. The support of the active layer is the canvas, of one that is inactive
/// its own relief: they have no tile in common.
film::FilmState counterpart(const Layer& layer, bool active, const CanvasCells& cells,
                            const Moment& newer) {
    if (cells != cells_of(newer)) return {cells.shape, cells.cell_mm};
    film::FilmState film = film_of_layer(newer, layer.id);
    const Layer* then = layer_of(newer, layer.id);
    if (active)
        film.support_mm = newer.value.film.support_mm;
    else if (then != nullptr && !then->inactive)
        film.support_mm = film::SupportHeights(film.shape);
    return film;
}

const film::FilmState& well_of(const Moment& moment, const film::FilmState& bare) {
    return moment.value.well ? *moment.value.well : bare;
}

/// Takes the films out of a value, tiles and all.
struct FilmRemover {
    void operator()(film::FilmState& film) const { film = {}; }
    void operator()(LayerStack& stack) const {
        for (Layer& layer : stack.layers)
            layer.inactive.reset();
    }
    void operator()(std::optional<film::FilmState>& well) const {
        if (well) *well = {};
    }
    /// Undo does not return to it.
    void operator()(CopiedPaint& copied) const { copied.reset(); }
    void operator()(auto&) const {}
};

Moment without_films(const Moment& moment) {
    Moment rest = moment;
    for_each_field(FilmRemover{}, rest.value);
    return rest;
}

/// What a field of the older value takes besides films and besides what the newer one shares with it.
struct FieldBytes {
    std::size_t sum = 0;

    void operator()(const std::optional<BrushInHand>& brush, const std::optional<BrushInHand>&) {
        if (brush) add(brush->brush);
    }
    void operator()(const BrushAside& older, const BrushAside& newer) {
        if (older && older != newer) add(older->brush);
    }
    void operator()(const LayerStack& stack, const LayerStack&) {
        sum += stack.layers.size() * sizeof(Layer) + stack.groups.size() * sizeof(LayerGroup);
    }
    void operator()(const SharedTracing& older, const SharedTracing& newer) {
        if (older && !(newer && older->picture == newer->picture)) sum += older->picture->rgba.size();
    }
    void operator()(const SharedReferences& older, const SharedReferences& newer) {
        if (!older || older == newer) return;
        for (const Reference& reference : older->references) {
            const Reference* still = find_reference(newer, reference.id);
            sum += sizeof(Reference);
            if (still == nullptr || still->picture != reference.picture)
                sum += reference.picture->pixels.rgba.size() + reference.picture->png.size();
        }
    }
    void operator()(const Selection& older, const Selection& newer) {
        if (older && older != newer) sum += grid::bytes_in_part(*older);
    }
    void operator()(const Masking& older, const Masking& newer) {
        (*this)(older.cells, newer.cells);
        (*this)(older.tape, newer.tape);
    }
    void operator()(const film::FilmState&, const film::FilmState&) {}
    void operator()(const CopiedPaint&, const CopiedPaint&) {}
    void operator()(const std::optional<film::FilmState>&, const std::optional<film::FilmState>&) {}
    template <class Plain>
    void operator()(const Plain&, const Plain&) {
        static_assert(kCountedByItsSize<Plain>, "say what this field of a painting takes");
    }

  private:
    void add(const brush::Brush& brush) {
        sum += brush.held.size() * sizeof(brush::Contents) +
               brush.tip.bristles.size() * sizeof(brush::Bristle);
    }
};

std::size_t bytes_without_films(const Moment& older, const Moment& newer) {
    FieldBytes bytes;
    for_each_field(bytes, older.value, newer.value);
    return sizeof(Moment) + (older.awake.size() + older.well_awake.size()) / 8 + bytes.sum;
}

/// Makes the older moment's films of the newer one's.
template <class Tiles>
void put(const AllFilms<Tiles>& films, const CanvasCells& cells, const Moment& newer, Moment& older) {
    for (std::size_t place = 0; place < films.layers.size(); ++place) {
        Layer& layer = older.value.layers.layers[place];
        if (!films.layers[place]) {
            layer.inactive = layer_of(newer, layer.id)->inactive;
            continue;
        }
        film::FilmState film = counterpart(layer, is_active(older, place), cells, newer);
        films.layers[place]->put_into(film);
        if (is_active(older, place))
            older.value.film = std::move(film);
        else
            layer.inactive = std::make_shared<const film::FilmState>(std::move(film));
    }
    if (!films.well) return;
    older.value.well = well_of(newer, bare_well());
    films.well->put_into(*older.value.well);
}

}  // namespace

/// As they are, packed, or both.
struct MomentDifference::Tiles {
    using Raw = AllFilms<FilmTiles>;
    using Packed = AllFilms<PackedFilmTiles>;

    static std::shared_ptr<const Raw> taken(const Moment& older, const Moment& newer) {
        auto raw = std::make_shared<Raw>();
        for (std::size_t place = 0; place < older.value.layers.layers.size(); ++place) {
            auto& tiles = raw->layers.emplace_back();
            if (is_shared(older, place, newer)) continue;
            const Layer& layer = older.value.layers.layers[place];
            tiles.emplace(film_of(older, place),
                          counterpart(layer, is_active(older, place), cells_of(older), newer));
        }
        if (older.value.well) raw->well.emplace(*older.value.well, well_of(newer, bare_well()));
        return raw;
    }

    static std::shared_ptr<const Packed> packed_of(const Raw& raw, const Moment& older,
                                                   const std::function<void()>& rest) {
        auto packed = std::make_shared<Packed>();
        for (std::size_t place = 0; place < raw.layers.size(); ++place) {
            const auto& tiles = raw.layers[place];
            auto& layer = packed->layers.emplace_back();
            if (tiles) layer.emplace(*tiles, film_of(older, place), rest);
        }
        if (raw.well) packed->well.emplace(*raw.well, *older.value.well, rest);
        return packed;
    }

    template <class Form>
    Form locked(Form Tiles::*form) const {
        const std::lock_guard lock(mutex);
        return this->*form;
    }

    /// Two threads may do this at once: the first that is ready has done it. `rest` is called between
    /// tiles.
    void pack(const std::function<void()>& rest) {
        std::unique_lock lock(mutex);
        const auto source = raw;
        const auto whole = older;
        if (whole == nullptr) return;
        lock.unlock();
        auto result = packed_of(*source, *whole, rest);
        lock.lock();
        if (packed == nullptr) packed = std::move(result);
        older.reset();
    }

    mutable std::mutex mutex;
    std::shared_ptr<const Raw> raw;        ///< may be null once they are packed
    std::shared_ptr<const Packed> packed;  ///< null until then
    std::shared_ptr<const Moment> older;   ///< for what the tiles are packed with; null once they are
};

MomentDifference::MomentDifference(const Moment& older, const Moment& newer)
    : rest_(without_films(older)),
      cells_(cells_of(older)),
      rest_bytes_(bytes_without_films(older, newer)),
      tiles_(std::make_shared<Tiles>()) {
    tiles_->raw = Tiles::taken(older, newer);
    tiles_->older = std::make_shared<const Moment>(older);
    bytes_ = rest_bytes_ + tiles_->raw->bytes();
}

Moment MomentDifference::applied_to(const Moment& newer) const {
    Moment older = rest_;
    if (const auto raw = tiles_->locked(&Tiles::raw))
        put(*raw, cells_, newer, older);
    else
        put(*tiles_->locked(&Tiles::packed), cells_, newer, older);
    return older;
}

void MomentDifference::pack_on(core::BackgroundThread& thread) {
    if (packing_) return;
    packing_ = true;
    thread.add([weak = std::weak_ptr(tiles_), &thread] {
        if (const auto tiles = weak.lock()) tiles->pack([&thread] { thread.rest_while_held(); });
    });
}

void MomentDifference::pack() {
    tiles_->pack([] {});
}

bool MomentDifference::is_unpacked() const {
    return tiles_->locked(&Tiles::raw) != nullptr;
}

void MomentDifference::drop_unpacked() {
    std::shared_ptr<const Tiles::Raw> unused;  // freed after the lock
    const std::lock_guard lock(tiles_->mutex);
    if (tiles_->packed != nullptr) unused = std::exchange(tiles_->raw, nullptr);
}

std::optional<std::size_t> MomentDifference::packed_bytes() const {
    const auto packed = tiles_->locked(&Tiles::packed);
    if (packed == nullptr) return std::nullopt;
    return rest_bytes_ + packed->bytes();
}

}  // namespace pastoso::document
