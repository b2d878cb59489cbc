#include "interactions/stroke_ahead.hpp"

#include <utility>

namespace pastoso::interactions {
namespace {

/// The brush follows the hand about so late, and the screen the brush: that is made up for.
constexpr double kLag_s = 0.024;

/// After that a brush without further steadying is where the hand rests.
constexpr double kCatchUp_s = 0.1;

/// One sample more lies in between: the path is behind by one.
constexpr int kForetold = 3;

}  // namespace

void StrokeAhead::begin(const brush::HandPath& path, const brush::PenSample& sample,
                        std::uint64_t number) {
    lifted_ = path_ = path;
    samples_ = {{sample, number}};
    places_.clear();
    choice_ = brush::GuideChoice(path.guide());
    begun_ = false;
    follow(choice_.add(sample), number);
    forecast_.start(sample);
    rests_ = false;
}

void StrokeAhead::add(const brush::PenSample& sample, std::uint64_t number) {
    if (!path_) return;
    samples_.push_back({sample, number});
    follow(choice_.add(sample), number);
    forecast_.add(sample);
    rests_ = false;
}

void StrokeAhead::turn(double rotation_deg) {
    if (!path_) return;
    const auto samples = std::exchange(samples_, {});
    for (Told told : samples) {
        told.pen.rotation_deg = rotation_deg;
        if (samples_.empty())
            begin(*lifted_, told.pen, told.number);
        else
            add(told.pen, told.number);
    }
}

void StrokeAhead::end(std::uint64_t number) {
    if (!path_) return;
    follow(choice_.end(), number);
    path_->end();
    take_steps(number);
    path_.reset();
}

void StrokeAhead::shown(std::uint64_t number) {
    shown_ = number;
    while (places_.size() > 1 && places_[1].number <= shown_)
        places_.pop_front();
}

std::vector<brush::PenSample> StrokeAhead::places() const {
    std::vector<brush::PenSample> places;
    for (const Told& place : places_)
        places.push_back(place.pen);
    for (const brush::PathStep& step : foretold())
        places.push_back(step.pen);
    const bool first_is_shown = !places_.empty() && places_.front().number <= shown_;
    if (first_is_shown && places.size() == 1) places.clear();
    return places;
}

void StrokeAhead::follow(const std::vector<brush::PenSample>& samples, std::uint64_t number) {
    for (const brush::PenSample& sample : samples) {
        if (begun_) {
            path_->add(sample);
            continue;
        }
        begun_ = true;
        path_->keep_to(choice_.guide());
        path_->begin(sample);
    }
    if (begun_) take_steps(number);
}

void StrokeAhead::take_steps(std::uint64_t number) {
    for (const brush::PathStep& step : path_->take_steps())
        places_.push_back({step.pen, number});
    shown(shown_);
}

/// The paint of a hand that rests stays behind until that moves on or lifts.
brush::PenSample StrokeAhead::expected(int number) const {
    if (!rests_) return forecast_.after(kLag_s * number / (kForetold - 1));
    brush::PenSample there = samples_.back().pen;
    there.time_s += kCatchUp_s * number / (kForetold - 1);
    return there;
}

std::vector<brush::PathStep> StrokeAhead::foretold() const {
    if (!path_ || !begun_) return {};
    brush::HandPath path = *path_;
    for (int i = 1; i <= kForetold; ++i)
        path.add(expected(i));
    return path.take_steps();
}

}  // namespace pastoso::interactions
