// What the canvas shows in place of lit paint, the lamp over it, and a graphics context that is lost.
#include "app/window_fixture.hpp"
#include "interactions/light_handle.hpp"
#include "shade/outline.hpp"
#include "shade/render.hpp"
#include "shade/sampling.hpp"
#include "shade/surface.hpp"
#include "shade/tile_colour.hpp"
#include "view/look_legend.hpp"

#include <algorithm>
#include <cmath>

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QOpenGLContext>
#include <QTest>

namespace pastoso::tests {
namespace {

using commands::Command;
using screen::Look;

/// A value rounded to eight bits, and the shader's single precision.
constexpr double kLevels = 1.5;

double encoded(double linear) {
    const double value = std::clamp(linear, 0.0, 1.0);
    return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
}

class Looks : public WindowTest {
  protected:
    /// A stroke that lies still, seen at four pixels a cell: every cell has a pixel at its middle.
    void paint() {
        give(Command::Pause);
        mouse_stroke(line_mm({20.0, 20.0}, {40.0, 20.0}));
        screen::ViewTransform view;
        view.zoom = 4.0;
        view.origin_px = {-200.5, -60.5};  // the middle of a cell on that of a pixel
        settle();
        canvas().set_view(view);
    }

    void give(Command command) { action(command)->trigger(); }

    film::FilmState film() { return session().snapshot()->film; }

    /// Cells that are seen, some of them painted.
    static std::vector<glm::ivec2> some_cells() {
        std::vector<glm::ivec2> cells;
        for (int y = 35; y < 125; y += 3)
            for (int x = 70; x < 190; x += 5)
                cells.emplace_back(x, y);
        return cells;
    }

    /// Of the pixel at the middle of a cell, 0 to 255.
    glm::dvec3 seen(const QImage& image, const glm::ivec2& cell) {
        const glm::dvec2 px = canvas().view_transform().device_from_cell(glm::dvec2(cell) + 0.5);
        const QColor there =
            image.pixelColor(static_cast<int>(std::floor(px.x)), static_cast<int>(std::floor(px.y)));
        return {there.red(), there.green(), there.blue()};
    }

    static void expect_near(const glm::dvec3& seen, const glm::dvec3& expected) {
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(seen[i], expected[i], kLevels);
    }

    double wet_mm(const glm::ivec2& cell) {
        return film::thickness_mm(film().thickness.at(cell.x, cell.y));
    }

    QString reading() { return window().findChild<QLabel*>(QStringLiteral("look"))->text(); }
};

TEST_F(Looks, HeightsHaveTheColoursOfTheirSteps) {
    paint();
    give(Command::LookHeight);
    const QImage image = picture();
    double highest_mm = 0.0;
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 240; ++x)
            highest_mm = std::max(highest_mm, wet_mm({x, y}));
    const double top_mm = screen::scale_top_mm(highest_mm);
    int high = 0;
    for (const glm::ivec2& cell : some_cells()) {
        const double share = screen::kHeightSteps * wet_mm(cell) / top_mm;
        if (std::abs(share - std::round(share)) < 0.01 && share > 0.5) continue;  // between two steps
        const int step = std::min(static_cast<int>(share), screen::kHeightSteps - 1);
        high += step > 1;
        const screen::Rgb& colour = screen::kHeightColours[step];
        expect_near(seen(image, cell), 255.0 * glm::dvec3(colour[0], colour[1], colour[2]));
    }
    EXPECT_GT(high, 10);
    EXPECT_EQ(reading(), QStringLiteral("Height of the paint"));
    EXPECT_TRUE(canvas().legend().isVisible());
    EXPECT_EQ(canvas().legend().lines().back(), QStringLiteral("%1 mm").arg(top_mm));
}

TEST_F(Looks, WetPaintIsTintedAndDryPaintIsNot) {
    paint();
    const QImage lit = picture();
    give(Command::LookWet);
    const QImage wet = picture();
    int tinted = 0;
    for (const glm::ivec2& cell : some_cells()) {
        const double tint = screen::wet_tint(wet_mm(cell));
        const glm::dvec3 there = seen(wet, cell);
        tinted += tint > 0.3;
        if (tint == 0.0) {
            EXPECT_EQ(there.x, there.y);
        }
        // A grey takes what the tint leaves: all three channels give the same one.
        const glm::dvec3 full =
            255.0 * glm::dvec3(screen::kWetTint[0], screen::kWetTint[1], screen::kWetTint[2]);
        const glm::dvec3 grey = (there - tint * full) / (1.0 - tint);
        const double room = 2.0 * kLevels / (1.0 - tint);
        EXPECT_NEAR(grey.x, grey.y, room);
        EXPECT_NEAR(grey.x, grey.z, room);
        const glm::dvec3 before = seen(lit, cell);
        EXPECT_LE(grey.x, screen::kGreyShare * std::max({before.x, before.y, before.z}) + room);
        EXPECT_GE(grey.x, screen::kGreyShare * std::min({before.x, before.y, before.z}) - room);
    }
    EXPECT_GT(tinted, 20);
    give(Command::Pause);
    give(Command::DryNow);
    wait_for([&] { return volume_mm3() == 0.0; });
    const QImage dry = picture();
    for (const glm::ivec2& cell : some_cells())
        EXPECT_EQ(seen(dry, cell).x, seen(dry, cell).z);
}

TEST_F(Looks, NormalsAreThoseOfTheSurface) {
    paint();
    give(Command::LookNormals);
    const QImage image = picture();
    constexpr int kWidth = 240, kHeight = 160;
    std::vector<float> heights(static_cast<std::size_t>(kWidth) * kHeight);
    shade::height_coefficients(film(), {0, 0, kWidth, kHeight}, heights.data(), kWidth);
    const auto at = [&](int x, int y) { return static_cast<double>(heights[y * kWidth + x]); };
    int steep = 0;
    for (const glm::ivec2& cell : some_cells()) {
        // The cubic B-spline at a node: weights 1, 4, 1 of 6, slope half the difference.
        const auto across = [&](int dy) {
            return 0.5 * (at(cell.x + 1, cell.y + dy) - at(cell.x - 1, cell.y + dy));
        };
        const auto down = [&](int dx) {
            return 0.5 * (at(cell.x + dx, cell.y + 1) - at(cell.x + dx, cell.y - 1));
        };
        const double slope_x = (across(-1) + 4.0 * across(0) + across(1)) / 6.0 / film().cell_mm;
        const double slope_y = (down(-1) + 4.0 * down(0) + down(1)) / 6.0 / film().cell_mm;
        const glm::dvec3 normal =
            glm::dvec3(-slope_x, slope_y, 1.0) / std::sqrt(1.0 + slope_x * slope_x + slope_y * slope_y);
        steep += normal.z < 0.95;
        expect_near(seen(image, cell), 255.0 * (0.5 + 0.5 * normal));
    }
    EXPECT_GT(steep, 5);
}

TEST_F(Looks, FlatColourIsThePaintsOwnInAnyLight) {
    paint();
    give(Command::LookFlat);
    const QImage image = picture();
    constexpr int kWidth = 240, kHeight = 160;
    std::vector<shade::CellColour> colours(static_cast<std::size_t>(kWidth) * kHeight);
    shade::cell_colours(film(), {0, 0, kWidth, kHeight}, session().snapshot()->ground, colours.data(),
                        kWidth);
    // A pixel at the middle of each cell, as the view has it.
    const shade::Lattice lattice{0.375, 0.375, 4.0, 4.0, 4 * (kWidth - 1), 4 * (kHeight - 1)};
    core::ThreadPool pool(2);
    const film::FilmState wet = film();
    shade::SurfaceSamples samples;
    shade::Renderer(wet, session().snapshot()->ground, lattice, {}, pool)
        .render({0, 0, lattice.width, lattice.height}, nullptr, &samples);
    std::vector<float> share(colours.size()), cover(colours.size());
    std::vector<std::uint8_t> near(colours.size());
    shade::outline_cells(wet, {0, 0, kWidth, kHeight}, {share.data(), cover.data(), near.data()},
                         kWidth);
    int outlined = 0, plain = 0;
    // At a node the cubic B-spline has the weights 1, 4, 1 of 6, Mitchell and Netravali's 1, 16, 1
    // of 18.
    const double sharp = shade::colour_sharpness(canvas().view_transform().zoom);
    const double beside = (1.0 - sharp) / 6.0 + sharp / 18.0, middle = 1.0 - 2.0 * beside;
    for (const glm::ivec2& cell : some_cells()) {
        glm::dvec3 mean{0.0};
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const double weight = (dx == 0 ? middle : beside) * (dy == 0 ? middle : beside);
                const shade::CellColour& colour = colours[(cell.y + dy) * kWidth + cell.x + dx];
                mean += weight * glm::dvec3(colour.red, colour.green, colour.blue);
            }
        }
        if (near[(cell.y - 1) * kWidth + cell.x - 1] != 0) {
            const shade::SurfaceSample& sample =
                samples.samples[static_cast<std::size_t>(4 * cell.y) * lattice.width + 4 * cell.x];
            mean = {sample.red, sample.green, sample.blue};
            ++outlined;
        } else {
            ++plain;
        }
        if (std::min({mean.x, mean.y, mean.z}) < 0.0 || std::max({mean.x, mean.y, mean.z}) > 1.0)
            continue;
        expect_near(seen(image, cell),
                    255.0 * glm::dvec3(encoded(mean.x), encoded(mean.y), encoded(mean.z)));
    }
    EXPECT_GT(outlined, 10);
    EXPECT_GT(plain, 100);
    shade::Lighting raking = canvas().lighting();
    raking.elevation_deg = 12.0;
    canvas().set_lighting(raking);
    EXPECT_EQ(difference(picture(), image).largest, 0);
}

TEST_F(Looks, ExcludeEachOtherAndGoAwayWithoutATrace) {
    paint();
    const QImage lit = picture();
    for (const Command look :
         {Command::LookWet, Command::LookHeight, Command::LookNormals, Command::LookFlat}) {
        give(look);
        EXPECT_TRUE(action(look)->isChecked());
        EXPECT_FALSE(action(Command::LookLit)->isChecked());
        EXPECT_FALSE(reading().isEmpty());
        EXPECT_GT(difference(picture(), lit).largest, 30);
    }
    give(Command::LookLit);
    EXPECT_FALSE(action(Command::LookFlat)->isChecked());
    EXPECT_TRUE(reading().isEmpty());
    EXPECT_FALSE(canvas().legend().isVisible());
    EXPECT_EQ(difference(picture(), lit).largest, 0);
}

TEST_F(Looks, PaintThatComesIsShownToo) {
    give(Command::Pause);
    give(Command::LookWet);
    const QImage bare = picture();
    mouse_stroke(line_mm({20.0, 20.0}, {40.0, 20.0}));
    const QImage painted = picture();
    EXPECT_GT(difference(bare, painted).largest, 30);
    give(Command::LookLit);
    picture();
    give(Command::LookWet);
    EXPECT_EQ(difference(picture(), painted).largest, 0) << "piece by piece and at once are the same";
}

TEST(LightHandle, IsWhereTheLightComesFromHoweverTheCanvasIsTurned) {
    const interactions::LightDial dial{{300.0, 200.0}, 100.0};
    screen::ViewTransform view;
    // From the left, seen from the left; from above in a canvas turned to the right.
    EXPECT_NEAR(light_handle_px(dial, view, {180.0, 8.0}).x, 200.0, 1e-9);
    view.angle_deg = 90.0;
    EXPECT_NEAR(light_handle_px(dial, view, {90.0, 8.0}).x, 400.0, 1e-9);
    for (int i = 0; i < 100; ++i) {
        view.angle_deg = 3.7 * i - 180.0;
        view.mirrored = i % 2 == 0;
        const interactions::LightDirection light{std::fmod(29.0 * i, 360.0), 9.0 + 0.8 * i};
        const interactions::LightDirection there =
            light_at(dial, view, light_handle_px(dial, view, light), {});
        EXPECT_NEAR(std::remainder(there.azimuth_deg - light.azimuth_deg, 360.0), 0.0, 1e-9);
        EXPECT_NEAR(there.elevation_deg, light.elevation_deg, 1e-9);
    }
    EXPECT_EQ(light_at(dial, view, dial.centre_px, {77.0, 30.0}).azimuth_deg, 77.0);
    EXPECT_EQ(light_at(dial, view, {900.0, 200.0}, {}).elevation_deg, interactions::kLowestLight_deg);
}

class Lamp : public Looks {
  protected:
    QPoint lamp() {
        const glm::dvec2 window{canvas().width(), canvas().height()};
        const interactions::LightDial dial{0.5 * window,
                                           std::min(120.0, 0.4 * std::min(window.x, window.y))};
        const glm::dvec2 px =
            light_handle_px(dial, canvas().view_transform(),
                            {canvas().lighting().azimuth_deg, canvas().lighting().elevation_deg});
        return QPointF(px.x, px.y).toPoint();
    }

    void drag_lamp(const QPoint& way) {
        const QPoint from = lamp();
        QTest::mousePress(&canvas(), Qt::LeftButton, {}, from);
        QTest::mouseMove(&canvas(), from + way / 2);
        QTest::mouseMove(&canvas(), from + way);
        QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, from + way);
    }
};

TEST_F(Lamp, StandsInAPictureOfTheWholeWindow) {
    paint();
    const auto seen = [this] {
        settle();
        const QImage all = window().grab().toImage();
        return all.pixelColor(canvas().mapTo(&window(), lamp()) * all.devicePixelRatio());
    };
    const QColor without = seen();
    EXPECT_LT(without.red() - without.blue(), 60);
    give(Command::MoveLight);
    const QColor lit = seen();
    EXPECT_GT(lit.red() - lit.blue(), 120) << "it is yellow";
}

TEST_F(Lamp, IsDraggedOverTheCanvas) {
    paint();
    const QImage before = picture();
    give(Command::MoveLight);
    const QPoint from = lamp();
    drag_lamp({90, 20});
    const shade::Lighting light = canvas().lighting();
    EXPECT_GT(std::abs(light.azimuth_deg - shade::Lighting{}.azimuth_deg), 10.0);
    EXPECT_LE((lamp() - from - QPoint(90, 20)).manhattanLength(), 2);
    EXPECT_EQ(studio().well().lighting().azimuth_deg, light.azimuth_deg);
    const double volume = volume_mm3();
    QTest::keyClick(&canvas(), Qt::Key_Escape);
    EXPECT_FALSE(action(Command::MoveLight)->isChecked());
    EXPECT_EQ(volume_mm3(), volume) << "the press did not paint";
    const QImage after = picture();
    EXPECT_GT(difference(before, after).largest, 20);
    // However it came there, the shadows are those of the light.
    canvas().set_lighting(light);
    EXPECT_EQ(difference(picture(), after).largest, 0);
}

TEST_F(Lamp, IsFoundWhereItWasLeft) {
    give(Command::MoveLight);
    drag_lamp({-60, 30});
    const shade::Lighting light = canvas().lighting();
    EXPECT_NE(light.azimuth_deg, shade::Lighting{}.azimuth_deg);
    start_again();
    EXPECT_NEAR(canvas().lighting().azimuth_deg, light.azimuth_deg, 1e-9);
    EXPECT_NEAR(canvas().lighting().elevation_deg, light.elevation_deg, 1e-9);
}

TEST_F(Lamp, BesideItTheBrushPaintsOn) {
    give(Command::Pause);
    give(Command::MoveLight);
    mouse_stroke(line_mm({5.0, 35.0}, {25.0, 35.0}));
    EXPECT_GT(volume_mm3(), 2.0);
    EXPECT_EQ(canvas().lighting().azimuth_deg, shade::Lighting{}.azimuth_deg);
}

/// The view in a window of its own and back: each has a context of its own, which dies with it.
TEST_F(Looks, AContextThatIsLostLeavesThePictureAsItWas) {
    for (view::CanvasView* view : studio().views())
        view->set_drawn_by(screen::DrawnBy::OpenGl);
    paint();
    for (const Command look : {Command::LookLit, Command::LookHeight}) {
        give(look);
        const QImage before = picture();
        const screen::ViewTransform view = canvas().view_transform();
        const QOpenGLContext* first = canvas().opengl()->context();
        int lost = 0;
        QObject::connect(first, &QOpenGLContext::aboutToBeDestroyed, &canvas(), [&lost] { ++lost; });
        QWidget* home = canvas().parentWidget();
        const QSize size = canvas().size();
        QWidget other;
        put_canvas_into(other);
        EXPECT_EQ(lost, 1);
        canvas().set_view(view);
        EXPECT_EQ(difference(picture(), before).largest, 0);
        put_canvas_back(*home, size);
        canvas().set_view(view);
        EXPECT_EQ(difference(picture(), before).largest, 0);
    }
    mouse_stroke(line_mm({20.0, 25.0}, {40.0, 25.0}));
    EXPECT_TRUE(session().take_errors().empty());
}

}  // namespace
}  // namespace pastoso::tests
