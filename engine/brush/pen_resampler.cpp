#include "brush/pen_resampler.hpp"

#include "brush/pen_curve.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::brush {
namespace {

constexpr double kLeastInterval_s = 1e-4;
constexpr double kLongestInterval_s = 0.002;
/// A pen that rests between two events for long needs no more samples than this.
constexpr double kMostSamples = 32.0;

}  // namespace

PenSample following(const PenSample& before, const PenSample& sample) {
    PenSample next = sample;
    next.time_s = std::max(sample.time_s, before.time_s + kLeastInterval_s);
    next.rotation_deg =
        before.rotation_deg + std::remainder(sample.rotation_deg - before.rotation_deg, 360.0);
    return next;
}

void PenResampler::start(const PenSample& sample) {
    last_.fill(sample);
    moved_ = false;
}

const std::vector<PenSample>& PenResampler::add(const PenSample& sample) {
    const PenSample next = following(last_[2], sample);
    fill(next);
    last_ = {last_[1], last_[2], next};
    moved_ = true;
    return filled_;
}

const std::vector<PenSample>& PenResampler::end() {
    fill(last_[2]);
    return filled_;
}

void PenResampler::fill(const PenSample& after) {
    filled_.clear();
    if (!moved_) return;
    const PenCurve curve(last_[0], last_[1], last_[2], after);
    // A little more than the interval: rounded times at 500 Hz are not cut in two.
    const double parts = std::clamp(
        std::ceil((last_[2].time_s - last_[1].time_s) / kLongestInterval_s - 1e-3), 1.0, kMostSamples);
    for (double part = 1.0; part < parts; ++part)
        filled_.push_back(curve.at(part / parts));
    filled_.push_back(last_[2]);
}

}  // namespace pastoso::brush
