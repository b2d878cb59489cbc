#include "recordings/series_csv.hpp"

#include <limits>

#include <gmock/gmock.h>

namespace pastoso::recordings {
namespace {

using testing::HasSubstr;

SeriesRow row() {
    SeriesRow row;
    row.t_s = 0.5;
    row.measures.volume_mm3 = 12;
    row.measures.max_h_mm = 0.25;
    row.measures.centroid = {3, 4};
    row.measures.wet_box = {1, 2, 5, 6};
    row.measures.kinetic_energy_J = 2e-12;
    row.measures.gravity_energy_J = 3e-12;
    row.measures.surface_energy_J = 4e-12;
    row.runoff_mm3 = 0.125;
    row.clamped_faces = 7;
    row.steps = 90;
    return row;
}

TEST(SeriesCsv, OneLineARow) {
    EXPECT_EQ(
        series_csv({row()}, false, true),
        "t_s,volume_mm3,max_h_mm,centroid_x_mm,centroid_y_mm,wet_x0_mm,wet_x1_mm,wet_y0_mm,wet_y1_mm,"
        "kinetic_energy_J,gravity_energy_J,surface_energy_J,clamped_faces,steps,runoff_mm3\n"
        "0.5,12,0.25,3,4,1,5,2,6,2e-12,3e-12,4e-12,7,90,0.125\n");
}

TEST(SeriesCsv, CellUnitsAndDryCanvases) {
    SeriesRow dry = row();
    dry.measures.centroid.x_mm = -std::numeric_limits<double>::quiet_NaN();
    const std::string text = series_csv({dry, row()}, true, false);
    EXPECT_THAT(text, HasSubstr("t_s,volume_cells3,max_h_cells,"));
    EXPECT_THAT(text, HasSubstr(",kinetic_energy_cells5_s2,"));
    EXPECT_THAT(text, HasSubstr("\n0.5,12,0.25,nan,4,1,5,2,6,2,3,4,7,90\n0.5,12,0.25,3,"));
}

TEST(SeriesCsv, ProfilesSayTheirLine) {
    const ProfileLine line{1.5, 8, {{0.25, 0.5, 1, 2, 3}, {0.75, 0.5, 0, 0, 0}}};
    EXPECT_EQ(
        profile_csv(film::Axis::X, {line}, false),
        "t_s,y_mm,x_mm,support_mm,h_mm,u_mm_s,v_mm_s\n1.5,8,0.25,0.5,1,2,3\n1.5,8,0.75,0.5,0,0,0\n");
    EXPECT_THAT(profile_csv(film::Axis::Y, {}, true),
                "t_s,x_cells,y_cells,support_cells,h_cells,u_cells_s,v_cells_s\n");
}

}  // namespace
}  // namespace pastoso::recordings
