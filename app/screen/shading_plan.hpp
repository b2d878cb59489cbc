// Which parts of the window have to be shaded, and how well, in this frame and in later ones.
#pragma once

#include "screen/frame_budget.hpp"
#include "screen/quality.hpp"

#include <QRegion>

namespace pastoso::screen {

/// Collects what is out of date. Where a good picture of it would take too long for a frame it is first
/// drafted; drafts that have been left alone for a while are refined strip by strip, even while paint
/// moves elsewhere.
class ShadingPlan {
  public:
    /// A part of the window shows something else now.
    void add_damage(const QRegion& region) { damage_ += region; }

    /// The picture has been moved in the window by so many pixels: what comes in is out of date.
    void shift(const QPoint& by, const QRect& window);

    /// All of the picture is a draft now, and what lies beside `kept` is out of date.
    void keep_as_draft(const QRegion& kept, const QRect& window);

    /// Whether all of the window can be shaded so quickly that no draft is wanted.
    bool is_quick(const QRect& window, double px_per_cell) const;

    bool has_damage() const { return !damage_.isEmpty(); }
    bool has_drafts() const { return !fresh_.isEmpty() || !cooling_.isEmpty() || !cold_.isEmpty(); }
    bool can_refine() const { return !cold_.isEmpty(); }

    struct Job {
        QRegion region;
        Quality quality = Quality::Full;
        double samples_per_pixel = 1.0;

        double samples() const;
    };

    /// Takes all damage, clipped to the window, in the best quality that can be had within a frame.
    Job take_damage(const QRect& window, double px_per_cell);

    /// Takes as much of the drafts that may be refined as fits into a frame.
    Job take_refinement(double px_per_cell);

    /// To be called at regular intervals: drafts may be refined that have not been damaged for one to
    /// two of them.
    void let_drafts_cool();

    /// What a job is likely to cost.
    double expected_s(const Job& job) const { return budget_.expected_s(job.samples()); }

    /// Tells what jobs of so many samples cost.
    void measured(double samples, double seconds) { budget_.measured(samples, seconds); }

  private:
    Quality affordable_quality(double pixels, double px_per_cell) const;

    QRegion damage_;
    QRegion fresh_;    ///< drafted since the last interval began
    QRegion cooling_;  ///< drafted in the interval before
    QRegion cold_;
    FrameBudget budget_;
};

}  // namespace pastoso::screen
