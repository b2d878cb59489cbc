#include "document/references.hpp"

#include <algorithm>

namespace pastoso::document {

const Reference* find_reference(const SharedReferences& board, ReferenceId id) {
    if (!board) return nullptr;
    const auto found = std::ranges::find(board->references, id, &Reference::id);
    return found == board->references.end() ? nullptr : &*found;
}

double pixel_count(const ReferenceBoard& board) {
    double sum = 0.0;
    for (const Reference& reference : board.references)
        sum += 1.0 * reference.picture->pixels.width * reference.picture->pixels.height;
    return sum;
}

}  // namespace pastoso::document
