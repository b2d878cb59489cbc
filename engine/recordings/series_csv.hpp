// The course of a scene as tables: comma-separated values with one heading line.
#pragma once

#include "film/laboratory/measures.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace pastoso::recordings {

struct SeriesRow {
    double t_s = 0.0;
    film::Measures measures;
    double runoff_mm3 = 0.0;
    std::int64_t clamped_faces = 0;  ///< from the start, like the steps
    std::int64_t steps = 0;
};

/// A profile along a line at a time; `at_mm` is the line's y (x) when it goes along x (y).
struct ProfileLine {
    double t_s = 0.0;
    double at_mm = 0.0;
    std::vector<film::ProfilePoint> points;
};

/// In cell units lengths are called cells, and energies are divided by the density: cells5_s2. `runoff`
/// adds the column of what ran off open edges. Numbers are the shortest that read back the same; "nan"
/// stands where a dry canvas has none.
std::string series_csv(const std::vector<SeriesRow>& rows, bool cell_units, bool runoff);

/// One line of text per cell; the heading begins t_s,y_mm,x_mm for lines along x, t_s,x_mm,y_mm for
/// those along y.
std::string profile_csv(film::Axis axis, const std::vector<ProfileLine>& lines, bool cell_units);

}  // namespace pastoso::recordings
