#include "screen/shading_plan.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::screen {
namespace {

/// A stroke feels immediate when its picture follows within about two frames of a 60 Hz screen; finer
/// sampling must not take more than one of them, and a plain picture up to twice that is still better
/// than a coarse one.
constexpr double kFullWithin_s = 0.016;
constexpr double kPlainWithin_s = 0.045;

/// A strip of refinement may hold up the pen for no longer than this.
constexpr double kRefinement_s = 0.030;

double pixel_count(const QRegion& region) {
    double count = 0.0;
    for (const QRect& rect : region)
        count += static_cast<double>(rect.width()) * rect.height();
    return count;
}

}  // namespace

double ShadingPlan::Job::samples() const {
    return samples_per_pixel * pixel_count(region);
}

Quality ShadingPlan::affordable_quality(double pixels, double px_per_cell) const {
    const auto expected_s = [&](Quality quality) {
        return budget_.expected_s(pixels * samples_per_pixel(quality, px_per_cell));
    };
    if (expected_s(Quality::Full) <= kFullWithin_s) return Quality::Full;
    const bool too_slow = expected_s(Quality::Plain) > kPlainWithin_s;
    return too_slow && coarse_is_useful(px_per_cell) ? Quality::Coarse : Quality::Plain;
}

void ShadingPlan::shift(const QPoint& by, const QRect& window) {
    for (QRegion* region : {&damage_, &fresh_, &cooling_, &cold_})
        *region = region->translated(by) & window;
    damage_ += QRegion(window) - window.translated(by);
}

void ShadingPlan::keep_as_draft(const QRegion& kept, const QRect& window) {
    damage_ = QRegion(window) - kept;
    fresh_ = kept & window;
    cooling_ = cold_ = QRegion();
}

bool ShadingPlan::is_quick(const QRect& window, double px_per_cell) const {
    const double samples = pixel_count(window) * samples_per_pixel(Quality::Plain, px_per_cell);
    return budget_.expected_s(samples) <= kFullWithin_s;
}

ShadingPlan::Job ShadingPlan::take_damage(const QRect& window, double px_per_cell) {
    Job job;
    job.region = std::exchange(damage_, QRegion()) & window;
    job.quality = affordable_quality(pixel_count(job.region), px_per_cell);
    job.samples_per_pixel = samples_per_pixel(job.quality, px_per_cell);
    for (QRegion* drafts : {&fresh_, &cooling_, &cold_})
        *drafts = (*drafts & window) - job.region;
    if (job.quality != Quality::Full) fresh_ += job.region;
    return job;
}

ShadingPlan::Job ShadingPlan::take_refinement(double px_per_cell) {
    Job job;
    job.samples_per_pixel = samples_per_pixel(job.quality, px_per_cell);
    const QRect all = cold_.boundingRect();
    const double affordable_px = budget_.affordable_samples(kRefinement_s) / job.samples_per_pixel;
    const double rows = std::clamp(affordable_px / std::max(all.width(), 1), 4.0, 65536.0);
    job.region = cold_ & QRect(all.x(), all.y(), all.width(), static_cast<int>(rows));
    cold_ -= job.region;
    return job;
}

void ShadingPlan::let_drafts_cool() {
    cold_ += std::exchange(cooling_, std::exchange(fresh_, QRegion()));
}

}  // namespace pastoso::screen
