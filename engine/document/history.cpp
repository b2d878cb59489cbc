#include "document/history.hpp"

#include "core/check.hpp"

#include <utility>

namespace pastoso::document {

void History::set_budget(std::size_t bytes) {
    finish_packing();
    budget_bytes_ = bytes;
    past_.set_unpacked_bytes(bytes / 8);
    future_.set_unpacked_bytes(bytes / 8);
    if (bytes == 0) {
        past_.clear();
        future_.clear();
    }
    finish_packing();
}

void History::remember(Moment before, Step step) {
    future_.clear();
    if (budget_bytes_ == 0) return;
    before.step = std::move(step);
    past_.push(std::move(before));
    drop_oldest();
}

Moment History::step_back(Moment now) {
    PASTOSO_CHECK(can_undo());
    if (past_.is_undecided(packed_budget_bytes())) past_.finish_packing();
    drop_oldest();
    Moment moment = past_.pop();
    now.step = moment.step;
    future_.push(std::move(now));
    return moment;
}

Moment History::step_forward(Moment now) {
    PASTOSO_CHECK(can_redo());
    Moment moment = future_.pop();
    now.step = moment.step;
    past_.push(std::move(now));
    drop_oldest();
    return moment;
}

void History::finish_packing() {
    past_.finish_packing();
    drop_oldest();
}

void History::drop_oldest() {
    past_.drop_lowest(packed_budget_bytes(), kMostMoments);
}

}  // namespace pastoso::document
