#include "document/actions/reference_actions.hpp"

#include "core/check.hpp"
#include "document/actions/field_checks.hpp"
#include "document/actions/picture_actions.hpp"
#include "document/living_painting.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace pastoso::document {
namespace {

/// Changes a copy of the board, which others share.
template <class Change>
void change_board(LivingPainting& painting, const Change& change) {
    SharedReferences& shared = painting.value.references;
    ReferenceBoard board = shared ? *shared : ReferenceBoard{};
    change(board);
    shared = std::make_shared<const ReferenceBoard>(std::move(board));
}

auto place_in(ReferenceBoard& board, ReferenceId id) {
    return std::ranges::find(board.references, id, &Reference::id);
}

/// How many of the others can be below one of them.
std::ptrdiff_t possible_place(const ReferenceBoard& board, int place) {
    return std::min<std::ptrdiff_t>(place, std::ssize(board.references) - 1);
}

}  // namespace

void check_whole(const LayReference& lay) {
    PASTOSO_CHECK(lay.picture != nullptr);
    check_picture(lay.picture->pixels);
}

void check_possible(const LayReference& lay, const LivingPainting& painting) {
    const SharedReferences& board = painting.value.references;
    if (!board) return;
    if (board->references.size() >= kMostReferences)
        throw core::InputError("the board holds %1 references, and no more are kept.", kMostReferences);
    const pigment::Picture& picture = lay.picture->pixels;
    if (pixel_count(*board) + 1.0 * picture.width * picture.height > kMostReferencePixels)
        throw core::InputError(
            "the references on the board are too large; at most %1 million pixels in all are kept.",
            1e-6 * kMostReferencePixels);
}

bool changes_anything(const SetReference& set, const LivingPainting& painting) {
    const Reference* found = find_reference(painting.value.references, set.reference);
    return found != nullptr && (found->place != set.place || found->look != set.look);
}

bool changes_anything(const MoveReference& move, const LivingPainting& painting) {
    const SharedReferences& board = painting.value.references;
    const Reference* found = find_reference(board, move.reference);
    return found != nullptr && found - board->references.data() != possible_place(*board, move.place);
}

bool changes_anything(const RemoveReference& remove, const LivingPainting& painting) {
    return find_reference(painting.value.references, remove.reference) != nullptr;
}

void apply(const LayReference& lay, LivingPainting& painting) {
    change_board(painting, [&lay](ReferenceBoard& board) {
        board.references.push_back({board.next++, lay.name, lay.picture, lay.place, {}});
    });
}

void apply(const SetReference& set, LivingPainting& painting) {
    change_board(painting, [&set](ReferenceBoard& board) {
        const auto found = place_in(board, set.reference);
        found->place = set.place;
        found->look = set.look;
    });
}

void apply(const MoveReference& move, LivingPainting& painting) {
    change_board(painting, [&move](ReferenceBoard& board) {
        const auto found = place_in(board, move.reference);
        Reference moved = std::move(*found);
        const std::ptrdiff_t place = possible_place(board, move.place);
        board.references.erase(found);
        board.references.insert(board.references.begin() + place, std::move(moved));
    });
}

void apply(const RemoveReference& remove, LivingPainting& painting) {
    change_board(painting, [&remove](ReferenceBoard& board) {
        board.references.erase(place_in(board, remove.reference));
    });
}

}  // namespace pastoso::document
