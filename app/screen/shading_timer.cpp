#include "screen/shading_timer.hpp"

#include <utility>

namespace pastoso::screen {
namespace {

/// A card that is behind by more is not asked again before it answers.
constexpr std::size_t kMostAsked = 8;

}  // namespace

std::unique_ptr<QOpenGLTimerQuery> ShadingTimer::new_query() {
    if (asked_.size() >= kMostAsked) return nullptr;
    if (!free_.empty()) {
        auto query = std::move(free_.back());
        free_.pop_back();
        return query;
    }
    auto query = std::make_unique<QOpenGLTimerQuery>();
    return query->create() ? std::move(query) : nullptr;
}

void ShadingTimer::begin() {
    running_ = new_query();
    if (running_) running_->begin();
}

void ShadingTimer::end(double samples) {
    if (!running_) return;
    running_->end();
    asked_.push_back({std::move(running_), samples});
}

std::vector<ShadingTimer::Measured> ShadingTimer::take_measured() {
    std::vector<Measured> measured;
    while (!asked_.empty() && asked_.front().query->isResultAvailable()) {
        Asked first = std::move(asked_.front());
        asked_.pop_front();
        measured.push_back({first.samples, 1e-9 * static_cast<double>(first.query->waitForResult())});
        free_.push_back(std::move(first.query));
    }
    return measured;
}

void ShadingTimer::release() {
    running_.reset();
    asked_.clear();
    free_.clear();
}

}  // namespace pastoso::screen
