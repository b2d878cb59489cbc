#include "document/layered_canvas.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "grid/turning.hpp"
#include "layers/clipping.hpp"
#include "layers/cutting.hpp"
#include "layers/dry_cells.hpp"
#include "layers/extent.hpp"
#include "layers/flat_paint.hpp"
#include "layers/merging.hpp"
#include "layers/turning.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/vec2.hpp>

namespace pastoso::document {
namespace {

/// Paint that hardly moves is brought up to date once a second.
constexpr film::SolverOptions kSolving{.longest_wait_s = 64.0 / 60.0};

using InactiveFilm = std::shared_ptr<const film::FilmState>;

InactiveFilm inactive_film(film::FilmState film) {
    return std::make_shared<const film::FilmState>(std::move(film));
}

LayerPaint paint_on(const film::FilmState& film) {
    return {film::totals(film), film::dried_totals(film.strata), film.strata.evaporated};
}

void add(const LayerPaint& more, LayerPaint& sums) {
    sums.wet.thickness += more.wet.thickness;
    for (std::size_t k = 0; k < sums.wet.paint.size(); ++k)
        sums.wet.paint[k] += more.wet.paint[k];
    sums.dried += more.dried;
    sums.evaporated += more.evaporated;
}

bool have_same_heights(const film::TileHeights& a, const film::TileHeights& b) {
    for (int cell = 0; cell < grid::kTileCells; ++cell)
        if (a[cell] != b[cell]) return false;
    return true;
}

/// Tiles that are equal are shared with those of before, so that they count as unchanged.
void share_equal_tiles(const film::SupportHeights& before, film::SupportHeights& after) {
    if (before.shape() != after.shape()) return;
    for (int tile = 0; tile < after.tile_count(); ++tile) {
        if (!after.shares_tile(before, tile) && have_same_heights(after.read(tile), before.read(tile)))
            layers::share_tile(before, tile, after);
    }
}

bool shares_all_tiles(const film::SupportHeights& a, const film::SupportHeights& b) {
    for (int tile = 0; tile < a.tile_count(); ++tile)
        if (!a.shares_tile(b, tile)) return false;
    return true;
}

void check_room(const LayerStack& stack) {
    if (stack.layers.size() < kMostLayers) return;
    throw core::InputError("a painting has at most %1 layers.", kMostLayers);
}

/// How a new layer over the one at `place` shows. What is clipped and lies above goes on being clipped
/// to what it was, and not to the new layer.
LayerLook new_look(const LayerStack& stack, std::size_t place, const std::string& name) {
    const auto above = stack.layers.begin() + static_cast<std::ptrdiff_t>(place) + 1;
    const auto next = std::find_if(above, stack.layers.end(), [&](const Layer& layer) {
        return layer.group == stack.layers[place].group;
    });
    return {.name = name, .clipped = next != stack.layers.end() && next->look.clipped};
}

/// Puts a new layer over the one at `place`, into the same group, and makes it active.
void insert_above(LayerStack& stack, std::size_t place, LayerLook look, InactiveFilm film) {
    const Layer layer{stack.next_layer++, stack.layers[place].group, std::move(look), std::move(film)};
    stack.active = place + 1;
    stack.layers.insert(stack.layers.begin() + static_cast<std::ptrdiff_t>(stack.active), layer);
}

/// The layer below stands for it if it was active.
void erase_layer(LayerStack& stack, std::size_t place) {
    stack.layers.erase(stack.layers.begin() + static_cast<std::ptrdiff_t>(place));
    if (stack.active > place || stack.active == stack.layers.size()) --stack.active;
    drop_empty_groups(stack);
}

/// A layer as it looks through its opacity, fully opaque.
film::FilmState opaque(const film::FilmState& layer, double opacity, core::ThreadPool& pool) {
    if (opacity == 1.0) return layer;
    return layers::merged(film::FilmState(layer.shape, layer.cell_mm), layer, opacity, pool);
}

/// Of a layer of a stack in which all are inactive. What is hidden of it is added to `wiped`.
film::FilmState take_shown(const LayerStack& stack, std::size_t place, LayerPaint& wiped) {
    const film::FilmState& layer = *stack.layers[place].inactive;
    const auto onto = clipped_to(stack, place);
    if (!onto) return layer;
    layers::ClippedLayer parts = layers::clipped(layer, *stack.layers[*onto].inactive);
    add(paint_on(parts.hidden), wiped);
    return std::move(parts.shown);
}

/// In one group, what the group says holds for the result as well; otherwise the result is in none. Of
/// two that are clipped to the same layer, the result is so as well, and nothing is lost; otherwise only
/// what shows is merged. Returns what is wiped off.
LayerPaint merge_onto_lower(LayerStack& stack, std::size_t upper, core::ThreadPool& pool) {
    const std::size_t lower = upper - 1;
    const Layer& above = stack.layers[upper];
    Layer& below = stack.layers[lower];
    const bool same_group = above.group == below.group;
    const bool stays_clipped = same_group && above.look.clipped && below.look.clipped;
    const auto opacity = [&](std::size_t place) {
        if (stays_clipped) return stack.layers[place].look.opacity;
        return (same_group ? look_in_group(stack, place) : effective_look(stack, place)).opacity;
    };
    LayerPaint wiped;
    const auto taken = [&](std::size_t place) {
        return stays_clipped ? *stack.layers[place].inactive : take_shown(stack, place, wiped);
    };
    const film::FilmState ground = opaque(taken(lower), opacity(lower), pool);
    below.inactive = inactive_film(layers::merged(ground, taken(upper), opacity(upper), pool));
    below.look.opacity = 1.0;
    below.look.clipped = stays_clipped;
    if (!same_group) below.group = 0;
    const bool was_active = stack.active == upper;
    erase_layer(stack, upper);
    if (was_active) stack.active = lower;
    return wiped;
}

/// Paint that comes from elsewhere lies on masking fluid and tape, and is gone with them.
film::FilmState off_masking(film::FilmState paint, const Masking& masking) {
    return masking.cells ? layers::cut(paint, *masking.cells).outside : paint;
}

film::FilmState transformed(const film::FilmState& layer, const layers::Projective& map_cells,
                            const grid::Mask* unmasked, const Masking& masking, core::ThreadPool& pool) {
    if (unmasked == nullptr) return layers::transformed(layer, map_cells, pool);
    const layers::CutLayer parts = layers::cut(layer, *unmasked);
    const film::FilmState moved =
        off_masking(layers::transformed(parts.inside, map_cells, pool), masking);
    return layers::merged(parts.outside, moved, 1.0, pool);
}

std::vector<std::size_t> visible_places(const LayerStack& stack) {
    std::vector<std::size_t> places;
    for (std::size_t place = 0; place < stack.layers.size(); ++place)
        if (effective_look(stack, place).visible) places.push_back(place);
    return places;
}

/// What shows of them, merged; what does not is added to `hidden`.
film::FilmState flattened(const LayerStack& stack, const std::vector<std::size_t>& places,
                          LayerPaint& hidden, core::ThreadPool& pool) {
    const auto opacity = [&](std::size_t place) { return effective_look(stack, place).opacity; };
    film::FilmState sum = opaque(take_shown(stack, places[0], hidden), opacity(places[0]), pool);
    for (std::size_t i = 1; i < places.size(); ++i)
        sum = layers::merged(sum, take_shown(stack, places[i], hidden), opacity(places[i]), pool);
    return sum;
}

/// At that place or, where that would tear a group apart, below the group.
void insert_between_groups(LayerStack& stack, std::size_t place, Layer layer) {
    auto& list = stack.layers;
    while (place > 0 && place < list.size() && list[place].group != 0 &&
           list[place - 1].group == list[place].group)
        --place;
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(place), std::move(layer));
    stack.active = place;
}

void add_to_hash(const film::FilmState& film, const Layer& layer, core::Hash64& hash) {
    hash.add_value(film::state_hash(film));
    hash.add_value(layer.id);
    hash.add_value(layer.group);
    hash.add_value(layer.look.visible);
    hash.add_value(layer.look.locked);
    hash.add_value(layer.look.bare_locked);
    hash.add_value(layer.look.clipped);
    hash.add_value(layer.look.opacity);
}

/// What was copied as it lies on a canvas so many cells from where it was; other cells are made anew.
film::FilmState laid_at(const glm::ivec2& move_cells, const film::FilmState& copied,
                        const film::FilmState& canvas, core::ThreadPool& pool) {
    if (copied.cell_mm == canvas.cell_mm)
        return layers::on_extent(copied, {canvas.shape, -move_cells.x, -move_cells.y});
    const double finer = copied.cell_mm / canvas.cell_mm;
    return layers::resampled(copied,
                             {.map = {finer, 0.0, 1.0 * move_cells.x, 0.0, finer, 1.0 * move_cells.y},
                              .shape = canvas.shape,
                              .cell_mm = canvas.cell_mm},
                             pool);
}

std::vector<layers::SeenLayer> seen_layers(const LayerStack& stack, const film::FilmState& active) {
    const auto film_at = [&](std::size_t place) {
        return place == stack.active ? &active : stack.layers[place].inactive.get();
    };
    std::vector<layers::SeenLayer> seen;
    for (std::size_t place = 0; place < stack.layers.size(); ++place) {
        const LayerLook look = effective_look(stack, place);
        const auto onto = clipped_to(stack, place);
        if (look.visible)
            seen.push_back({film_at(place), look.opacity, onto ? film_at(*onto) : nullptr});
    }
    return seen;
}

/// A layer and what it is clipped to; null: nothing.
struct ClippedFilm {
    InactiveFilm film, onto;
    friend bool operator==(const ClippedFilm&, const ClippedFilm&) = default;
};

/// What the active layer lies on besides the bare support.
std::vector<ClippedFilm> films_below_active(const LayerStack& stack) {
    std::vector<ClippedFilm> films;
    for (std::size_t place = 0; place < stack.active; ++place) {
        if (!effective_look(stack, place).visible) continue;
        const auto onto = clipped_to(stack, place);
        films.push_back(
            {stack.layers[place].inactive, onto ? stack.layers[*onto].inactive : InactiveFilm()});
    }
    return films;
}

film::FilmState bare_canvas_like(const film::FilmState& film, const film::SupportHeights& bare_mm) {
    film::FilmState bare(film.shape, film.cell_mm);
    bare.support_mm = bare_mm;
    return bare;
}

}  // namespace

LayerFilms layers_apart(const film::FilmState& film, const film::SupportHeights& bare_mm,
                        const LayerStack& stack) {
    LayerFilms films;
    for (const Layer& layer : stack.layers)
        films.push_back(layer.inactive);
    films[stack.active] = inactive_film(layers::lifted_off(film, base_below_active(stack, bare_mm)));
    return films;
}

LayerFilms shown_layers(LayerFilms films, const LayerStack& stack) {
    const LayerFilms whole = films;
    for (std::size_t place = 0; place < films.size(); ++place)
        if (const auto onto = clipped_to(stack, place))
            films[place] = inactive_film(layers::clipped(*whole[place], *whole[*onto]).shown);
    return films;
}

film::SupportHeights base_below_active(const LayerStack& stack, film::SupportHeights bare_mm) {
    for (const auto& [film, onto] : films_below_active(stack))
        layers::raise_by(onto ? layers::clipped(*film, *onto).shown : *film, bare_mm);
    return bare_mm;
}

film::FilmState seen_by(layers::View& view, const film::FilmState& active,
                        const film::SupportHeights& bare_mm, const LayerStack& stack,
                        core::ThreadPool& pool) {
    return view.of(bare_canvas_like(active, bare_mm), seen_layers(stack, active), pool);
}

film::FilmState view_of(const film::FilmState& film, const film::SupportHeights& bare_mm,
                        const LayerStack& stack, core::ThreadPool& pool) {
    if (is_single(stack)) return film;
    const film::FilmState active = layers::lifted_off(film, base_below_active(stack, bare_mm));
    layers::View view;
    return seen_by(view, active, bare_mm, stack, pool);
}

LayeredCanvas::LayeredCanvas(PaintingValue& painting, const film::Medium& medium, core::ThreadPool& pool)
    : solver(painting.film, medium, kSolving, pool), pool_(pool), painting_(painting) {
    base_mm_ = base_of(painting.layers);
    expect_medium();
}

void LayeredCanvas::set_medium(const film::Medium& medium) {
    solver.set_medium(medium);
    expect_medium();
}

/// The medium in hand may come onto the active layer.
void LayeredCanvas::expect_medium() {
    painting_.film.consistencies.add(solver.consistency());
}

LayerChange LayeredCanvas::resize(const grid::Extent& extent, std::shared_ptr<const BareCanvas> bare) {
    PASTOSO_CHECK(bare->support_mm.shape() == extent.shape);
    LayerChange change{.before = paint(), .after = {}};
    lay_out_on(std::move(bare),
               [&](const film::FilmState& layer) { return layers::on_extent(layer, extent); });
    change.after = paint();
    return change;
}

void LayeredCanvas::turn(const core::Orientation& turn, std::shared_ptr<const BareCanvas> bare) {
    const std::vector<bool> awake = grid::turned_tiles(solver.awake_tiles(), painting_.film.shape, turn);
    lay_out_on(std::move(bare),
               [&](const film::FilmState& layer) { return layers::turned(layer, turn, pool_); });
    solver.restart(awake);
}

void LayeredCanvas::resample(const layers::Resampling& resampling,
                             std::shared_ptr<const BareCanvas> bare) {
    lay_out_on(std::move(bare), [&](const film::FilmState& layer) {
        return layers::resampled(layer, resampling, pool_);
    });
}

void LayeredCanvas::lay_out_on(std::shared_ptr<const BareCanvas> bare,
                               const std::function<film::FilmState(const film::FilmState&)>& changed) {
    LayerStack stack = all_inactive();
    for (Layer& layer : stack.layers)
        layer.inactive = inactive_film(changed(*layer.inactive));
    base_mm_ = base_below_active(stack, bare->support_mm);
    painting_.bare = std::move(bare);
    painting_.film = layers::laid_on(*stack.layers[stack.active].inactive, base_mm_);
    expect_medium();
    stack.layers[stack.active].inactive.reset();
    painting_.layers = std::move(stack);
    solver.reshape();
}

void LayeredCanvas::restore(const PaintingValue& then) {
    painting_.film = then.film;
    expect_medium();
    const bool same_below = films_below_active(then.layers) == films_below_active(painting_.layers);
    painting_.layers = then.layers;
    if (then.bare != painting_.bare) {
        painting_.bare = then.bare;
        base_mm_ = base_below_active(painting_.layers, painting_.bare->support_mm);
        solver.reshape();
    } else if (!same_below) {
        base_mm_ = base_of(painting_.layers);
    }
}

film::SupportHeights LayeredCanvas::base_of(const LayerStack& stack) const {
    film::SupportHeights base = base_below_active(stack, painting_.bare->support_mm);
    share_equal_tiles(base_mm_, base);
    return base;
}

LayerStack LayeredCanvas::all_inactive() {
    LayerStack stack = painting_.layers;
    stack.layers[stack.active].inactive = inactive_film(lifter_.lifted_off(painting_.film, base_mm_));
    return stack;
}

void LayeredCanvas::rearrange(const std::function<void(LayerStack&)>& change) {
    LayerStack stack = all_inactive();
    const InactiveFilm active = stack.layers[stack.active].inactive;
    change(stack);
    const bool same_paint = stack.layers[stack.active].inactive == active;
    film::SupportHeights base = base_of(stack);
    const bool same_base = shares_all_tiles(base, base_mm_);
    base_mm_ = std::move(base);
    if (!same_paint || !same_base) {
        painting_.film = layers::laid_on(*stack.layers[stack.active].inactive, base_mm_);
        painting_.film.consistencies = film::wet_consistencies(painting_.film);
        expect_medium();
        solver.wake_all();
    }
    stack.layers[stack.active].inactive.reset();
    painting_.layers = std::move(stack);
}

void LayeredCanvas::add(const AddLayer& added) {
    rearrange([&](LayerStack& stack) {
        check_room(stack);
        insert_above(stack, stack.active, new_look(stack, stack.active, added.name),
                     inactive_film(film::FilmState(painting_.film.shape, painting_.film.cell_mm)));
    });
}

void LayeredCanvas::select(const SelectLayer& selected) {
    const std::size_t place = place_of(painting_.layers, selected.layer);
    if (place == painting_.layers.active) return;
    rearrange([&](LayerStack& stack) { stack.active = place; });
}

void LayeredCanvas::set(const SetLayer& set) {
    rearrange([&](LayerStack& stack) { stack.layers[place_of(stack, set.layer)].look = set.look; });
}

void LayeredCanvas::set_group(const SetGroup& set) {
    rearrange([&](LayerStack& stack) { group_of(stack, set.group).look = set.look; });
}

void LayeredCanvas::move(const MoveLayer& move) {
    rearrange([&](LayerStack& stack) { move_layer(stack, move); });
}

void LayeredCanvas::group(const GroupLayers& group) {
    rearrange([&](LayerStack& stack) { group_layers(stack, group); });
}

void LayeredCanvas::move_group(const MoveGroup& move) {
    rearrange([&](LayerStack& stack) { document::move_group(stack, move); });
}

void LayeredCanvas::ungroup(const UngroupLayers& ungroup) {
    rearrange([&](LayerStack& stack) { ungroup_layers(stack, ungroup.group); });
}

LayerPaint LayeredCanvas::merge_down(const MergeDown& merge) {
    const std::size_t place = place_of(painting_.layers, merge.layer);
    if (place == 0)
        throw core::InputError("there is no layer below \"%1\" to merge it onto.",
                               painting_.layers.layers[0].look.name);
    check_paintable(painting_.layers, place - 1);
    check_paintable(painting_.layers, place);
    LayerPaint wiped;
    rearrange([&](LayerStack& stack) { wiped = merge_onto_lower(stack, place, pool_); });
    return wiped;
}

LayerPaint LayeredCanvas::flatten() {
    LayerPaint wiped;
    rearrange([&](LayerStack& stack) {
        const std::vector<std::size_t> visible = visible_places(stack);
        if (visible.empty()) throw core::InputError("there is no visible layer to flatten.");
        for (const std::size_t place : visible)
            check_unlocked(stack, place);
        Layer flat{.id = stack.layers[visible[0]].id,
                   .look = {.name = stack.layers[visible[0]].look.name},
                   .inactive = inactive_film(flattened(stack, visible, wiped, pool_))};
        for (auto place = visible.rbegin(); place != visible.rend(); ++place)
            stack.layers.erase(stack.layers.begin() + static_cast<std::ptrdiff_t>(*place));
        insert_between_groups(stack, visible[0], std::move(flat));
        drop_empty_groups(stack);
    });
    return wiped;
}

LayerPaint LayeredCanvas::paint_picture(const PaintPicture& paint) {
    LayerPaint taken;
    rearrange([&](LayerStack& stack) {
        check_room(stack);
        film::FilmState flat =
            off_masking(layers::flat_paint(*paint.picture, paint.place, painting_.film.shape,
                                           painting_.film.cell_mm, pool_),
                        painting_.masking);
        taken = paint_on(flat);
        insert_above(stack, stack.active, new_look(stack, stack.active, paint.name),
                     inactive_film(std::move(flat)));
    });
    return taken;
}

LayerPaint LayeredCanvas::lay_ground(const std::string& name, film::FilmState ground) {
    LayerPaint taken = paint_on(ground);
    rearrange([&](LayerStack& stack) {
        check_room(stack);
        for (std::size_t place = 0; place < stack.layers.size(); ++place)
            if (!clipped_to(stack, place)) stack.layers[place].look.clipped = false;
        stack.layers.insert(stack.layers.begin(), Layer{.id = stack.next_layer++,
                                                        .look = {.name = name},
                                                        .inactive = inactive_film(std::move(ground))});
        ++stack.active;
    });
    return taken;
}

LayerPaint LayeredCanvas::pour(const film::FilmState& poured) {
    rearrange([&](LayerStack& stack) {
        InactiveFilm& layer = stack.layers[stack.active].inactive;
        layer = inactive_film(layers::merged(*layer, poured, 1.0, pool_));
    });
    return paint_on(poured);
}

AdjustedPaint LayeredCanvas::adjust_dry(const film::PaintCoefficients& paint,
                                        const layers::Adjustment& adjustment, const grid::Mask* where) {
    AdjustedPaint moved;
    rearrange([&](LayerStack& stack) {
        Layer& layer = stack.layers[stack.active];
        // Where what is selected is all wet, nothing changes: on other cells a bit of it may be dry.
        if (!layers::any_dry_cell(*layer.inactive))
            throw core::InputError("there is no dry paint on \"%1\" to adjust.", layer.look.name);
        layers::AdjustedLayer adjusted =
            layers::adjusted(*layer.inactive, paint, adjustment, where, pool_);
        moved.taken.dried = adjusted.added;
        moved.taken.evaporated = adjusted.evaporated;
        moved.wiped.dried = adjusted.removed;
        layer.inactive = inactive_film(std::move(adjusted.film));
    });
    return moved;
}

LayerPaint LayeredCanvas::duplicate(const DuplicateLayer& duplicate) {
    LayerPaint taken;
    rearrange([&](LayerStack& stack) {
        check_room(stack);
        const std::size_t place = place_of(stack, duplicate.layer);
        film::FilmState copy = *stack.layers[place].inactive;
        copy.strata.evaporated = 0;
        taken = paint_on(copy);
        insert_above(stack, place, stack.layers[place].look, inactive_film(std::move(copy)));
    });
    return taken;
}

film::FilmState LayeredCanvas::copy(const CopyPaint& copy, const grid::Mask* selection) {
    const LayerStack stack = all_inactive();
    const std::vector<std::size_t> places =
        copy.layer == 0 ? visible_places(stack) : std::vector{place_of(stack, copy.layer)};
    if (places.empty()) throw core::InputError("there is no visible layer to copy.");
    LayerPaint hidden;
    film::FilmState paint =
        copy.layer == 0 ? flattened(stack, places, hidden, pool_) : *stack.layers[places[0]].inactive;
    if (selection != nullptr) paint = layers::cut(paint, *selection).inside;
    paint.strata.evaporated = 0;
    return paint;
}

LayerPaint LayeredCanvas::paste(const PastePaint& paste, const film::FilmState& copied) {
    const auto cells = [&](double way_mm) {
        return static_cast<int>(std::lround(way_mm / painting_.film.cell_mm));
    };
    LayerPaint taken;
    rearrange([&](LayerStack& stack) {
        check_room(stack);
        film::FilmState paint = off_masking(
            laid_at({cells(paste.move_x_mm), cells(paste.move_y_mm)}, copied, painting_.film, pool_),
            painting_.masking);
        taken = paint_on(paint);
        insert_above(stack, stack.active, new_look(stack, stack.active, paste.name),
                     inactive_film(std::move(paint)));
    });
    return taken;
}

LayerPaint LayeredCanvas::remove(const RemoveLayer& remove) {
    LayerPaint wiped;
    rearrange([&](LayerStack& stack) {
        const std::size_t place = place_of(stack, remove.layer);
        if (stack.layers.size() == 1) throw core::InputError("a painting keeps its last layer.");
        check_unlocked(stack, place);
        wiped = paint_on(*stack.layers[place].inactive);
        erase_layer(stack, place);
    });
    return wiped;
}

LayerPaint LayeredCanvas::clear(const ClearLayer& clear, const grid::Mask* selection) {
    LayerPaint wiped;
    rearrange([&](LayerStack& stack) {
        const std::size_t place = place_of(stack, clear.layer);
        check_unlocked(stack, place);
        InactiveFilm& layer = stack.layers[place].inactive;
        layers::CutLayer parts{*layer, film::FilmState(painting_.film.shape, painting_.film.cell_mm)};
        if (selection != nullptr) parts = layers::cut(*layer, *selection);
        wiped = paint_on(parts.inside);
        layer = inactive_film(std::move(parts.outside));
    });
    return wiped;
}

LayerChange LayeredCanvas::transform(LayerId layer, const layers::Projective& map_cells,
                                     const grid::Mask* unmasked) {
    LayerChange paint;
    rearrange([&](LayerStack& stack) {
        const std::size_t place = place_of(stack, layer);
        check_unlocked(stack, place);
        InactiveFilm& film = stack.layers[place].inactive;
        paint.before = paint_on(*film);
        film = inactive_film(transformed(*film, map_cells, unmasked, painting_.masking, pool_));
        paint.after = paint_on(*film);
    });
    return paint;
}

LayerPaint LayeredCanvas::paint() const {
    LayerPaint sums = paint_on(painting_.film);
    for (const Layer& layer : painting_.layers.layers)
        if (layer.inactive) document::add(paint_on(*layer.inactive), sums);
    return sums;
}

film::FilmState LayeredCanvas::view() {
    if (is_single(painting_.layers)) return painting_.film;
    const film::FilmState active = lifter_.lifted_off(painting_.film, base_mm_);
    return seen_by(view_, active, painting_.bare->support_mm, painting_.layers, pool_);
}

std::uint64_t state_hash(const film::FilmState& film, const LayerStack& stack) {
    if (is_single(stack)) return film::state_hash(film);
    core::Hash64 hash;
    hash.add_value(stack.active);
    for (std::size_t place = 0; place < stack.layers.size(); ++place) {
        const Layer& layer = stack.layers[place];
        add_to_hash(place == stack.active ? film : *layer.inactive, layer, hash);
    }
    for (const LayerGroup& group : stack.groups) {
        hash.add_value(group.id);
        hash.add_value(group.look.visible);
        hash.add_value(group.look.locked);
        hash.add_value(group.look.bare_locked);
        hash.add_value(group.look.opacity);
    }
    return hash.value();
}

}  // namespace pastoso::document
