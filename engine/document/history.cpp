#include "document/history.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pastoso::document {

void History::set_budget(std::size_t bytes) {
    set_limits(bytes, bytes - bytes / 8, bytes == 0 ? 0 : kMostMoments);
}

void History::keep_steps(std::size_t count) {
    set_limits(kDefaultBudget_bytes, SIZE_MAX, std::min(count, kMostMoments));
}

void History::set_limits(std::size_t budget_bytes, std::size_t packed_bytes, std::size_t most_moments) {
    finish_packing();
    packed_bytes_ = packed_bytes;
    waiting_bytes_ = budget_bytes / 4;
    most_moments_ = most_moments;
    past_.set_unpacked_bytes(budget_bytes / 8);
    future_.set_unpacked_bytes(budget_bytes / 8);
    if (most_moments == 0) {
        past_.clear();
        future_.clear();
    }
    finish_packing();
}

void History::remember(Moment before, Step step) {
    future_.clear();
    if (most_moments_ == 0) return;
    before.step = std::move(step);
    past_.push(std::move(before));
    past_.limit_waiting(waiting_bytes_);
    drop_oldest();
}

Moment History::step_back(Moment now) {
    PASTOSO_CHECK(can_undo());
    if (past_.is_undecided(packed_bytes_)) past_.finish_packing();
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
    past_.drop_lowest(packed_bytes_, most_moments_);
}

}  // namespace pastoso::document
