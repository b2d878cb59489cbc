// What the screen shows: the shader against the renderer on the processor, smoothness, and saved
// pictures.
#include "app/window_fixture.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "main/window_parts.hpp"
#include "panels/canvas/light_panel.hpp"
#include "shade/render.hpp"
#include "shade/varnish.hpp"

#include <cmath>

#include <QAction>
#include <QComboBox>
#include <QStatusBar>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;

class PictureWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        studio().commands().action(Command::Pause)->trigger();
        mouse_stroke(line_mm({12.0, 12.0}, {48.0, 30.0}));
        studio().easel().choose_paint({{{"PY35", 1.0}}, 1.0});
        mouse_stroke(line_mm({45.0, 8.0}, {20.0, 34.0}));
        settle();
    }

    /// The canvas as the renderer on the processor shows it.
    QImage reference(double scale) {
        const auto snapshot = session().snapshot();
        shade::RenderSettings settings;
        settings.scale = scale;
        settings.lighting = canvas().lighting();
        settings.viewing = canvas().viewing();
        core::ThreadPool pool(2);
        const pigment::Image8 image = pigment::encode_srgb8(shade::render(
            snapshot->film, snapshot->ground, snapshot->film.shape.cells(), settings, pool));
        return QImage(image.rgb.data(), image.width, image.height, 3 * image.width,
                      QImage::Format_RGB888)
            .copy();
    }

    void show_at(double zoom, const glm::dvec2& origin_px) { canvas().set_view({origin_px, zoom}); }
};

// The window keeps colours as 16-bit floats (11 bits of precision, up to 1/8 of an 8-bit step in the
// lights and the shoulder, more where the encoding is steep in the darks) and the card rounds sums and
// powers differently.
constexpr int kLargestStep = 3;
constexpr double kMeanStep = 0.25;

TEST_F(PictureWindow, TheShaderShowsWhatTheRendererSaves) {
    for (const double zoom : {0.5, 1.0, 1.4, 2.0, 3.0, 6.4}) {
        show_at(zoom, {20.0, 10.0});
        const QImage shown = picture();
        const QImage wanted = reference(zoom);
        const QRect common = QRect(QPoint(20, 10), wanted.size()).intersected(shown.rect());
        const PictureDifference apart =
            difference(shown.copy(common), wanted.copy(common.translated(-20, -10)));
        EXPECT_LE(apart.largest, kLargestStep) << "at zoom " << zoom;
        EXPECT_LE(apart.mean, kMeanStep) << "at zoom " << zoom;
    }
}

TEST_F(PictureWindow, AnotherLightIsShownAsItIsSaved) {
    shade::Lighting lighting = canvas().lighting();
    lighting.azimuth_deg = 20.0;
    lighting.elevation_deg = 14.0;
    canvas().set_lighting(lighting);
    show_at(2.0, {20.0, 10.0});
    const QImage wanted = reference(2.0);
    const QImage shown = picture().copy(QRect(QPoint(20, 10), wanted.size()));
    EXPECT_LE(difference(shown, wanted).mean, kMeanStep);
}

TEST_F(PictureWindow, VarnishIsShownAsItIsSaved) {
    const shade::Lighting lamp = canvas().lighting();
    for (const shade::Finish finish : {shade::Finish::Matte, shade::Finish::Gloss}) {
        const shade::Varnish varnish{finish, 0.8, 0.5};
        Q_EMIT window().findChild<panels::LightPanel*>()->varnish_chosen(varnish);
        EXPECT_EQ(canvas().lighting().dry_roughness, shade::varnished(lamp, varnish).dry_roughness);
        EXPECT_NE(canvas().viewing(), pigment::Viewing{});
        show_at(2.0, {20.0, 10.0});
        const QImage wanted = reference(2.0);
        const QImage shown = picture().copy(QRect(QPoint(20, 10), wanted.size()));
        EXPECT_LE(difference(shown, wanted).mean, kMeanStep);
    }
}

TEST_F(PictureWindow, TheLightOfAnotherLampIsShownAsItIsSaved) {
    show_at(1.0, {20.0, 10.0});
    const QImage in_daylight = picture();
    auto* box = window().findChild<QComboBox*>(QStringLiteral("illuminant"));
    ASSERT_NE(box, nullptr);
    const auto state = session().snapshot();
    const int lamp = box->findData(QStringLiteral("A"));
    box->setCurrentIndex(lamp);
    Q_EMIT box->activated(lamp);
    EXPECT_EQ(canvas().viewing(), pigment::viewing_under(pigment::find_illuminant("A")));
    const QImage under_lamp = picture();
    const QImage wanted = reference(1.0);
    const QRect part(QPoint(20, 10), wanted.size());
    EXPECT_LE(difference(under_lamp.copy(part), wanted).mean, kMeanStep);
    EXPECT_GT(difference(under_lamp, in_daylight).largest, 2 * kLargestStep);
    EXPECT_EQ(session().snapshot(), state) << "no paint has moved for it";

    box->setCurrentIndex(0);
    Q_EMIT box->activated(0);
    EXPECT_EQ(difference(picture(), in_daylight).largest, 0);
}

TEST_F(PictureWindow, DisplayP3IsShownAsItIsSavedAndTheMenuTellsIt) {
    const auto action = [this](commands::Command command) {
        return studio().commands().action(command);
    };
    EXPECT_TRUE(action(commands::Command::SpaceSrgb)->isChecked());
    EXPECT_TRUE(action(commands::Command::LightD65)->isChecked());
    show_at(1.0, {20.0, 10.0});
    const QImage in_srgb = picture();
    action(commands::Command::SpaceDisplayP3)->trigger();
    EXPECT_EQ(canvas().viewing().space, pigment::WorkingSpace::DisplayP3);
    const QImage in_p3 = picture();
    const QImage wanted = reference(1.0);
    EXPECT_LE(difference(in_p3.copy(QRect(QPoint(20, 10), wanted.size())), wanted).mean, kMeanStep);
    EXPECT_GT(difference(in_p3, in_srgb).largest, 2 * kLargestStep);
    action(commands::Command::LightLed)->trigger();
    EXPECT_EQ(canvas().viewing(),
              pigment::viewing_under(pigment::find_illuminant("LED"), pigment::WorkingSpace::DisplayP3));
    EXPECT_FALSE(action(commands::Command::LightD65)->isChecked());
    EXPECT_FALSE(action(commands::Command::SpaceSrgb)->isChecked());
    auto* box = window().findChild<QComboBox*>(QStringLiteral("illuminant"));
    EXPECT_EQ(box->currentData().toString(), QStringLiteral("LED"));
}

TEST_F(PictureWindow, ALightFromAFileIsUsedAndABadOneIsTold) {
    const TemporaryFolder folder;
    const auto file = [&](const char* name, const std::string& text) {
        core::write_text_file(folder.path() / name, text);
        return QString::fromStdString((folder.path() / name).string());
    };
    auto* box = window().findChild<QComboBox*>(QStringLiteral("illuminant"));
    parts().light.use(file("even.csv", "wavelength_nm,power\n400,1\n700,1\n"));
    EXPECT_EQ(box->currentText().toStdString(), "even");
    const pigment::Viewing even = canvas().viewing();
    EXPECT_NE(even, pigment::Viewing{});
    parts().light.use(file("bad.csv", "400,1\n390,1\n"));
    EXPECT_THAT(window().statusBar()->currentMessage().toStdString(),
                testing::HasSubstr("bad.csv, line 2: the wavelength 390 nm is not greater"));
    EXPECT_EQ(canvas().viewing(), even);
    EXPECT_EQ(box->currentText().toStdString(), "even");
}

TEST_F(PictureWindow, ZoomedInTheSurfaceIsSmoothAndShowsNoCells) {
    constexpr int kZoom = 8;
    // Cells of the stroke's middle fill the window; cell borders lie at multiples of eight pixels.
    show_at(kZoom, {-8.0 * 80.0, -8.0 * 50.0});
    const QImage shown = picture();
    double at_borders = 0.0, elsewhere = 0.0;
    for (int y = 0; y < shown.height(); ++y) {
        const uchar* row = shown.constScanLine(y);
        for (int x = 1; x < shown.width(); ++x) {
            const int step = std::abs(row[3 * x + 1] - row[3 * x - 2]);
            (x % kZoom == 0 ? at_borders : elsewhere) += step;
        }
    }
    ASSERT_GT(elsewhere, 0.0);
    // Seven of eight steps lie within cells. Flat cells would have all of the change at their borders.
    EXPECT_NEAR(7.0 * at_borders / elsewhere, 1.0, 0.15);
}

TEST_F(PictureWindow, ASavedPictureIsAReadableFileThatLooksLikeTheCanvas) {
    const TemporaryFolder folder;
    const QString path = QString::fromStdString((folder.path() / "picture.png").string());
    parts().exporting.start({}, path.toStdString());
    wait_for([this] { return !parts().exporting.exporter().busy(); });
    const QImage saved = QImage(path).convertToFormat(QImage::Format_RGB888);
    ASSERT_FALSE(saved.isNull());
    EXPECT_EQ(difference(saved, reference(1.0)).largest, 0);
}

}  // namespace
}  // namespace pastoso::tests
