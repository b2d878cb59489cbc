// Flow in a plane on a canvas that lies aslant to it: what varies in one direction only, and again and
// again.
#pragma once

#include "film/validation/bench.hpp"
#include "film/validation/case.hpp"

#include <functional>

namespace pastoso::film::validation {

/// A canvas with periodic edges which `along` crosses once from 0 to the period, whatever the direction
/// of the flow against the grid.
class Plane {
  public:
    /// The nearest to this period and angle (0 to 90) that whole cells allow.
    Plane(double period_mm, double angle_deg, double cell_mm);

    int width() const { return width_; }
    int height() const { return height_; }
    double period_mm() const { return period_mm_; }
    double towards_x() const { return towards_x_; }  ///< the direction's cosine, and its sine
    double towards_y() const { return towards_y_; }

    /// Place along the flow of a point in cells, 0 to the period.
    double along_mm(double x, double y) const;

    /// The profile's mean over a cell.
    double mean(const std::function<double(double along_mm)>& profile, int x, int y) const;

    void fill(Bench& bench, const std::function<double(double along_mm)>& profile) const;

    /// Size, cells and force (mm/s2) of a setup.
    Setup placed(Setup setup, double force = 0.0) const;

    /// integral f(s) h ds and the like: the mean of value(along, h) over the canvas, times the period.
    double integral(const Bench& bench,
                    const std::function<double(double along_mm, double h_mm)>& value) const;

    /// Mean thickness in strips as wide as a cell, less `level_mm`.
    Curve profile(const Bench& bench, double level_mm = 0.0) const;

    /// Mean |h - exact| over the mean of exact, cell by cell.
    double l1_error(const Bench& bench, const std::function<double(double along_mm)>& exact) const;

  private:
    double cell_mm_;
    int width_, height_;
    double period_mm_, towards_x_, towards_y_;
};

}  // namespace pastoso::film::validation
