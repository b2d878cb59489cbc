// What a painting is made of.
#pragma once

#include "brush/brush.hpp"
#include "brush/contents.hpp"
#include "brush/stroke.hpp"
#include "brush/symmetry.hpp"
#include "document/actions/brush_actions.hpp"
#include "document/actions/canvas_actions.hpp"
#include "document/actions/copy_actions.hpp"
#include "document/actions/media_actions.hpp"
#include "document/canvas.hpp"
#include "document/layers.hpp"
#include "document/masking.hpp"
#include "document/references.hpp"
#include "document/selection.hpp"
#include "film/state.hpp"
#include "layers/tracing.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

namespace pastoso::document {

struct BrushInHand {
    TakeBrush taken;  ///< which one it is
    brush::Brush brush;
    std::uint64_t touch =
        0;  ///< when it was last taken, loaded or cleaned; grows, and files do not keep it
};

/// What has come and gone so far, and where there is nothing else to tell it by.
struct PaintFlows {
    brush::Contents taken{};           ///< out of the tubes
    brush::Contents wiped{};           ///< off brush, well and layers
    film::Totals forgotten_run_off{};  ///< over the edges, in a past that was undone
};

/// One that was laid aside with what it holds, shared by all moments in which it lies there.
using BrushAside = std::shared_ptr<const BrushInHand>;

using SharedTracing = std::shared_ptr<const layers::Tracing>;

/// A painting between two strokes, but for what its solvers remember. Copies share tiles.
struct PaintingValue {
    std::shared_ptr<const BareCanvas> bare{};  ///< the support as its settings tell it to be; not null
    film::FilmState film{};                    ///< of the active layer, on what is visible below it
    LayerStack layers = single_layer();
    std::optional<film::FilmState> well{};  ///< none: nothing has touched it
    std::optional<BrushInHand> brush{};
    BrushAside brush_aside{};  ///< null: none lies there
    UseMedium medium{};  ///< in hand: what the next paint is mixed with
    TiltCanvas tilt{};
    film::DryingAir air{};
    brush::HandAids aids{};
    brush::Symmetry symmetry{};
    Selection selection{};
    Masking masking{};
    SharedTracing tracing{};  ///< null: none
    SharedReferences references{};
    CopiedPaint copied{};     ///< null: nothing; it is in no account
    PaintFlows flows{};
};

/// References to all fields. The one list of them: what is done to each goes through for_each_field()
/// with a function for every type, so that a new field does not compile until everything knows what to
/// do with it.
template <class Value>
auto fields_of(Value& value) {
    auto& [bare, film, layers, well, brush, brush_aside, medium, tilt, air, aids, symmetry, selection,
           masking, tracing, references, copied, flows] = value;
    return std::tie(bare, film, layers, well, brush, brush_aside, medium, tilt, air, aids, symmetry,
                    selection, masking, tracing, references, copied, flows);
}

/// Calls visit(field of the first value, field of the second, ...) for every field.
template <class Visit, class First, class... Others>
void for_each_field(Visit&& visit, First& first, Others&... others) {
    constexpr std::size_t kFields = std::tuple_size_v<decltype(fields_of(first))>;
    const auto visit_field = [&]<std::size_t kField>() {
        visit(std::get<kField>(fields_of(first)), std::get<kField>(fields_of(others))...);
    };
    [&]<std::size_t... kField>(std::index_sequence<kField...>) {
        (visit_field.template operator()<kField>(), ...);
    }
    (std::make_index_sequence<kFields>{});
}

}  // namespace pastoso::document
