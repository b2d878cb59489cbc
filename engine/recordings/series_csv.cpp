#include "recordings/series_csv.hpp"

#include "files/number_rows.hpp"

namespace pastoso::recordings {
namespace {

/// One cell is one millimetre and the density is that of water: from joules to energy per density.
constexpr double kJoulePerCellUnit = 1e-12;

}  // namespace

std::string series_csv(const std::vector<SeriesRow>& rows, bool cell_units, bool runoff) {
    const std::string length = cell_units ? "_cells" : "_mm";
    const std::string volume = cell_units ? "_cells3" : "_mm3";
    const std::string energy = cell_units ? "_cells5_s2" : "_J";
    std::string text = "t_s,volume" + volume + ",max_h" + length + ",centroid_x" + length +
                       ",centroid_y" + length + ",wet_x0" + length + ",wet_x1" + length + ",wet_y0" +
                       length + ",wet_y1" + length + ",kinetic_energy" + energy + ",gravity_energy" +
                       energy + ",surface_energy" + energy + ",clamped_faces,steps";
    if (runoff) text += ",runoff" + volume;
    text += '\n';
    const double energy_unit = cell_units ? kJoulePerCellUnit : 1.0;
    for (const SeriesRow& row : rows) {
        const film::Measures& m = row.measures;
        files::append_numbers(
            text, {row.t_s, m.volume_mm3, m.max_h_mm, m.centroid.x_mm, m.centroid.y_mm, m.wet_box.x0_mm,
                   m.wet_box.x1_mm, m.wet_box.y0_mm, m.wet_box.y1_mm, m.kinetic_energy_J / energy_unit,
                   m.gravity_energy_J / energy_unit, m.surface_energy_J / energy_unit});
        text += ',' + std::to_string(row.clamped_faces) + ',' + std::to_string(row.steps);
        if (runoff) files::append_numbers(text, {row.runoff_mm3});
        text += '\n';
    }
    return text;
}

std::string profile_csv(film::Axis axis, const std::vector<ProfileLine>& lines, bool cell_units) {
    const std::string length = cell_units ? "_cells" : "_mm";
    const std::string speed = cell_units ? "_cells_s" : "_mm_s";
    const bool along_x = axis == film::Axis::X;
    std::string text = std::string("t_s,") + (along_x ? "y" : "x") + length + "," +
                       (along_x ? "x" : "y") + length + ",support" + length + ",h" + length + ",u" +
                       speed + ",v" + speed + "\n";
    for (const ProfileLine& line : lines) {
        for (const film::ProfilePoint& point : line.points) {
            files::append_numbers(
                text, {line.t_s, line.at_mm, point.along_mm, point.support_mm, point.thickness_mm,
                       point.velocity_x_mm_s, point.velocity_y_mm_s});
            text += '\n';
        }
    }
    return text;
}

}  // namespace pastoso::recordings
