// How large exports will be, asked before the work.
#include "document/error_of.hpp"
#include "document/painting.hpp"
#include "files/temporary_folder.hpp"
#include "recordings/painting_export.hpp"
#include "recordings/picture_export.hpp"
#include "recordings/timelapse.hpp"
#include "shade/canvas.hpp"

#include <cmath>
#include <random>

#include <gmock/gmock.h>

namespace pastoso::recordings {
namespace {

using document::error_of;
using testing::HasSubstr;

const files::KeepGoing kToTheEnd = [](double) { return true; };

class ExportSize : public files::TemporaryFolder {
  protected:
    static document::CanvasSettings settings() {
        document::CanvasSettings canvas;
        canvas.width_mm = 20.0;
        canvas.height_mm = 15.0;
        canvas.px_per_mm = 4.0;
        return canvas;
    }
    ExportChoice choice(ExportKind kind, const char* name) const {
        ExportChoice choice;
        choice.kind = kind;
        choice.path = folder / name;
        return choice;
    }

    core::ThreadPool pool{2};
    ExportedCells cells{document::canvas_shape(settings()), 0.25};
};

TEST_F(ExportSize, IsThatOfTheFile) {
    const document::PaintingState painting = document::Painting(settings(), pool).state();
    for (const bool of_well : {false, true}) {
        ExportChoice picture = choice(ExportKind::Picture, "a.png");
        picture.of_well = of_well;
        picture.scale = 1.37;
        const ExportReport report = export_painting(painting, picture, pool, kToTheEnd);
        const grid::Shape size = export_size(cells, picture);
        EXPECT_EQ(size.width, report.width_px);
        EXPECT_EQ(size.height, report.height_px);
        EXPECT_DOUBLE_EQ(
            exported_cells(cells, picture).shape.width * exported_cells(cells, picture).cell_mm,
            report.width_mm);
    }
    ExportChoice relief = choice(ExportKind::Relief, "a.stl");
    relief.relief.resolution_mm = 0.4;
    const grid::Shape size = export_size(cells, relief);
    const Relief solid{size.width, size.height, 0.4, 0.4, {}};
    EXPECT_EQ(export_painting(painting, relief, pool, kToTheEnd).triangles, solid.triangle_count());
}

TEST_F(ExportSize, RefusesWhatTheExportWouldRefuse) {
    ExportChoice wide = choice(ExportKind::Picture, "a.webp");
    cells.shape = {20000, 100};
    EXPECT_THAT(error_of([&] { export_size(cells, wide); }),
                HasSubstr("a.webp: .webp files hold at most 16383 pixels a side; this picture has "
                          "20000 x 100."));
    wide.path = folder / "a.png";
    EXPECT_EQ(export_size(cells, wide).width, 20000);
    wide.scale = 2.0;
    EXPECT_THAT(error_of([&] { export_size(cells, wide); }), HasSubstr("40000 x 200 pixels is larger"));
    wide.scale = 65.0;
    EXPECT_THAT(error_of([&] { export_size(cells, wide); }), HasSubstr("outside the range"));
    ExportChoice relief = choice(ExportKind::Relief, "a.stl");
    relief.relief.base_mm = 0.0;
    EXPECT_THAT(error_of([&] { export_size(cells, relief); }),
                HasSubstr("The relief's base in mm is 0"));
}

TEST_F(ExportSize, FramesAreCountedAsTheyAreMade) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> fps(1.0, 120.0), exponent(-2.0, 3.0);
    std::uniform_int_distribution<std::int64_t> ticks(0, 3000);
    document::Recording recording;
    recording.canvas = settings();
    TimelapseChoice film;
    for (int i = 0; i < 300; ++i) {
        film.fps = i % 3 == 0 ? std::floor(fps(random)) : fps(random);
        film.speed = i % 2 == 0 ? 1.0 : std::pow(10.0, exponent(random));
        recording.end_tick = ticks(random);
        EXPECT_EQ(frame_count(recording, film),
                  static_cast<std::int64_t>(frame_ticks(recording, film).size()))
            << film.fps << " fps, speed " << film.speed << ", " << recording.end_tick << " ticks";
    }
    film.scale = 1.5;
    EXPECT_EQ(timelapse_size(settings(), film), (grid::Shape{120, 90}));
}

TEST_F(ExportSize, FramesOfAnotherCanvasAreFittedIn) {
    const film::FilmState film = test::random_canvas({40, 40}, 3);
    const ExportSource source{film, test::kGround, {}};
    const pigment::LinearImage frame = frame_picture(source, {80, 20}, pool);
    EXPECT_EQ(frame.width, 80);
    EXPECT_EQ(frame.height, 20);
    const auto at = [&](int x, int y) { return frame.rgb[static_cast<std::size_t>(3 * (80 * y + x))]; };
    EXPECT_EQ(at(5, 3), at(75, 15)) << "grey on both sides";
    EXPECT_NE(at(35, 10), at(5, 3));
    shade::RenderSettings half;
    half.scale = 0.5;
    const pigment::LinearImage small =
        shade::render(film, test::kGround, film.shape.cells(), half, pool);
    EXPECT_EQ(at(30, 0), small.rgb[0]);
    EXPECT_EQ(at(49, 19), small.rgb[3 * (20 * 20 - 1)]);

    const pigment::LinearImage same = frame_picture(source, film.shape, pool);
    EXPECT_EQ(same.rgb, shade::render(film, test::kGround, film.shape.cells(), {}, pool).rgb);
}

}  // namespace
}  // namespace pastoso::recordings
