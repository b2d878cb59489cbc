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
    budget_bytes_ = budget_bytes;
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

void History::remember(Moment before, UndoStep step) {
    future_.clear();
    if (most_moments_ == 0) return;
    before.step = std::move(step);
    past_.push(std::move(before));
    past_.limit_waiting(waiting_bytes_);
    drop_oldest();
    limit_unpacked();
}

bool History::join_latest(const UndoStep& step) {
    if (past_.empty() || past_.steps().back().step.name != step.name) return false;
    future_.clear();
    return true;
}

Moment History::step_back(Moment now) {
    PASTOSO_CHECK(can_undo());
    if (past_.is_undecided(packed_bytes_)) past_.finish_packing();
    drop_oldest();
    Moment moment = past_.pop();
    now.step = moment.step;
    future_.push(std::move(now));
    limit_unpacked();
    return moment;
}

Moment History::step_forward(Moment now) {
    PASTOSO_CHECK(can_redo());
    Moment moment = future_.pop();
    now.step = moment.step;
    past_.push(std::move(now));
    drop_oldest();
    limit_unpacked();
    return moment;
}

void History::finish_packing() {
    past_.finish_packing();
    drop_oldest();
    limit_unpacked();
}

std::size_t History::bytes() const {
    return past_.packed_bytes() + past_.unpacked_bytes() + future_.packed_bytes() +
           future_.unpacked_bytes();
}

void History::drop_oldest() {
    past_.drop_lowest(packed_bytes_, most_moments_);
}

/// What is to be undone comes before what may be done again.
void History::limit_unpacked() {
    const auto left = [](std::size_t bytes, std::size_t taken) {
        return bytes - std::min(bytes, taken);
    };
    const std::size_t room = left(budget_bytes_, past_.packed_bytes() + future_.packed_bytes());
    past_.limit_unpacked(room);
    future_.limit_unpacked(left(room, past_.unpacked_bytes()));
}

}  // namespace pastoso::document
