// Paint that is copied, cut and pasted in the window, and pictures of other programs.
#include "app/window_fixture.hpp"
#include "core/temporary_folder.hpp"

#include <algorithm>
#include <variant>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDropEvent>
#include <QGuiApplication>
#include <QImage>
#include <QMimeData>
#include <QTest>
#include <QUrl>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using testing::HasSubstr;

class ClipboardWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        give(Command::Pause);
        QGuiApplication::clipboard()->clear();
        studio().easel().take_brush("Flat bristle 20", 4.0);
        mouse_stroke(line_mm({10.0, 20.0}, {50.0, 20.0}));
        settle();
    }

    void give(Command command) {
        action(command)->trigger();
        settle();
    }
    void press_keys(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::ControlModifier) {
        QTest::keyClick(&canvas(), key, modifiers);
        settle();
    }
    void select(double x0_mm, double x1_mm) {
        studio().easel().select(
            document::SelectArea{{{x0_mm, 0}, {x1_mm, 0}, {x1_mm, 40}, {x0_mm, 40}}});
        settle();
    }
    document::PaintingState state() { return session().capture().painting; }
    std::size_t layer_count() { return state().value.layers.layers.size(); }
    std::int32_t thickness_of_active(const glm::dvec2& place_mm) {
        return state().value.film.thickness.at(static_cast<int>(4.0 * place_mm.x),
                                               static_cast<int>(4.0 * place_mm.y));
    }
    document::CanvasSettings canvas_settings() const override {
        document::CanvasSettings canvas = WindowTest::canvas_settings();
        canvas.width_mm = width_mm;
        return canvas;
    }
    /// Of another painting; that of before is gone.
    void open_window(double of_width_mm) {
        width_mm = of_width_mm;
        open_another();
        give(Command::Pause);
    }
    std::size_t times_brought() {
        std::size_t times = 0;
        for (const document::Event& event : session().capture().record.recording().events)
            times += std::holds_alternative<document::BringPaint>(event.action) ? 1 : 0;
        return times;
    }
    double width_mm = 60.0;
    static QImage clipboard_image() {
        return qvariant_cast<QImage>(QGuiApplication::clipboard()->mimeData()->imageData());
    }
};

TEST_F(ClipboardWindow, WhatIsSelectedIsPastedWetAsALayerWhereItWas) {
    const std::int32_t painted = thickness_of_active({30.0, 20.0});
    ASSERT_GT(painted, 0);
    select(25.0, 35.0);
    press_keys(Qt::Key_C);
    EXPECT_THAT(told(), HasSubstr("Copied"));
    press_keys(Qt::Key_V);
    ASSERT_EQ(layer_count(), 2U);
    EXPECT_EQ(thickness_of_active({30.0, 20.0}), painted);
    EXPECT_EQ(thickness_of_active({20.0, 20.0}), 0);
    give(Command::Undo);
    EXPECT_EQ(layer_count(), 1U);
}

TEST_F(ClipboardWindow, CutPaintIsWipedOff) {
    const std::int32_t painted = thickness_of_active({30.0, 20.0});
    select(25.0, 35.0);
    press_keys(Qt::Key_X);
    EXPECT_EQ(thickness_of_active({30.0, 20.0}), 0);
    EXPECT_GT(thickness_of_active({20.0, 20.0}), 0);
    press_keys(Qt::Key_V);
    EXPECT_EQ(thickness_of_active({30.0, 20.0}), painted);
}

TEST_F(ClipboardWindow, OtherProgramsGetAPictureOfIt) {
    select(25.0, 35.0);
    press_keys(Qt::Key_C);
    const QImage image = clipboard_image();
    EXPECT_EQ(image.width(), 40) << "ten millimetres";
    ASSERT_GT(image.height(), 4);
    EXPECT_EQ(image.pixelColor(20, image.height() / 2).alpha(), 255);
    const QColor paint = image.pixelColor(20, image.height() / 2);
    EXPECT_GT(paint.blue(), paint.red()) << "phthalo blue";
}

TEST_F(ClipboardWindow, APictureOfAnotherProgramBecomesALayer) {
    press_keys(Qt::Key_C);
    QImage red(30, 20, QImage::Format_ARGB32);
    red.fill(Qt::red);
    QGuiApplication::clipboard()->setImage(red);
    press_keys(Qt::Key_V);
    ASSERT_EQ(layer_count(), 2U);
    EXPECT_FALSE(film::has_wet_paint(state().value.film)) << "it is dry";
    const QColor middle = picture().pixelColor(picture().width() / 2, picture().height() / 2);
    EXPECT_GT(middle.red(), 150);
    EXPECT_LT(middle.green(), 90);
}

TEST_F(ClipboardWindow, MergedPaintIsThatOfAllLayers) {
    give(Command::AddLayer);
    mouse_stroke(line_mm({30.0, 5.0}, {30.0, 12.0}));
    settle();
    press_keys(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    press_keys(Qt::Key_V);
    EXPECT_GT(thickness_of_active({20.0, 20.0}), 0) << "of the lower layer";
    EXPECT_GT(thickness_of_active({30.0, 9.0}), 0);
}

TEST_F(ClipboardWindow, WhereThereIsNothingItSaysSo) {
    press_keys(Qt::Key_V);
    EXPECT_THAT(told(), HasSubstr("nothing to paste"));
    select(1.0, 3.0);
    press_keys(Qt::Key_C);
    EXPECT_THAT(told(), HasSubstr("no paint to copy"));
    EXPECT_EQ(layer_count(), 1U);
}

TEST_F(ClipboardWindow, ItIsPastedWhereThePointerIs) {
    const std::int32_t painted = thickness_of_active({30.0, 20.0});
    select(29.0, 31.0);
    press_keys(Qt::Key_C);
    move({30.0, 10.0}, Qt::NoButton);
    settle();
    press_keys(Qt::Key_V, Qt::ControlModifier | Qt::AltModifier);
    ASSERT_EQ(layer_count(), 2U);
    // The pointer is at whole pixels, and the stroke is as high as its hairs reach.
    std::int32_t most = 0;
    for (double y_mm = 7.0; y_mm < 13.0; y_mm += 0.25)
        most = std::max(most, thickness_of_active({30.0, y_mm}));
    EXPECT_GT(most, painted / 2);
    EXPECT_EQ(thickness_of_active({30.0, 20.0}), 0);
}

TEST_F(ClipboardWindow, AnotherPaintingGetsThePaintItselfWhereItWas) {
    const std::int32_t painted = thickness_of_active({30.0, 20.0});
    select(25.0, 35.0);
    press_keys(Qt::Key_C);
    open_window(60.0);
    press_keys(Qt::Key_V);
    ASSERT_EQ(layer_count(), 2U);
    EXPECT_EQ(thickness_of_active({30.0, 20.0}), painted);
    EXPECT_EQ(thickness_of_active({20.0, 20.0}), 0);
    press_keys(Qt::Key_V);
    EXPECT_EQ(layer_count(), 3U);
    EXPECT_EQ(thickness_of_active({30.0, 20.0}), painted);
    EXPECT_EQ(times_brought(), 1U) << "the recording holds it once";
    give(Command::Undo);
    give(Command::Undo);
    EXPECT_EQ(layer_count(), 1U);
}

TEST_F(ClipboardWindow, OnACanvasThatDoesNotReachSoFarItLiesInTheMiddle) {
    select(25.0, 35.0);
    press_keys(Qt::Key_C);
    open_window(20.0);
    press_keys(Qt::Key_V);
    ASSERT_EQ(layer_count(), 2U);
    EXPECT_GT(thickness_of_active({10.0, 20.0}), 0);
    EXPECT_EQ(thickness_of_active({4.0, 20.0}), 0);
    EXPECT_EQ(thickness_of_active({16.0, 20.0}), 0);
}

TEST_F(ClipboardWindow, FilesOfPicturesThatWereCopiedBecomeLayers) {
    press_keys(Qt::Key_C);
    const TemporaryFolder folder;
    QList<QUrl> addresses;
    for (const char* name : {"red.png", "blue.png"}) {
        QImage plain(30, 20, QImage::Format_RGB888);
        plain.fill(Qt::red);
        const QString file = QString::fromStdString((folder.path() / name).string());
        ASSERT_TRUE(plain.save(file));
        addresses.push_back(QUrl::fromLocalFile(file));
    }
    auto* files = new QMimeData;
    files->setUrls(addresses);
    QGuiApplication::clipboard()->setMimeData(files);
    press_keys(Qt::Key_V);
    loaded();
    settle();
    ASSERT_EQ(layer_count(), 3U) << "they were copied last";
    EXPECT_EQ(state().value.layers.layers[1].look.name, "red");
    EXPECT_EQ(state().value.layers.layers[2].look.name, "blue");
    give(Command::Undo);
    EXPECT_EQ(layer_count(), 1U);
}

TEST_F(ClipboardWindow, PaintDraggedFromAnotherWindowIsPastedWhereItFalls) {
    const std::int32_t painted = thickness_of_active({30.0, 20.0});
    select(28.0, 32.0);
    press_keys(Qt::Key_C);
    QMimeData dragged;
    const QString format = QStringLiteral("application/x-pastoso-paint");
    dragged.setData(format, QGuiApplication::clipboard()->mimeData()->data(format));
    open_window(60.0);
    const QPoint on_canvas = canvas().widget_position({20.0, 10.0}).toPoint();
    const QPoint place = canvas().mapTo(&window(), on_canvas);
    QDragEnterEvent enter(place, Qt::CopyAction, &dragged, Qt::LeftButton, {});
    QApplication::sendEvent(&window(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent fall(place, Qt::CopyAction, &dragged, Qt::LeftButton, {});
    QApplication::sendEvent(&window(), &fall);
    settle();
    ASSERT_EQ(layer_count(), 2U);
    // The place is a whole pixel, and the stroke is as high as its hairs reach.
    std::int32_t most = 0;
    for (double y_mm = 7.0; y_mm < 13.0; y_mm += 0.25)
        most = std::max(most, thickness_of_active({20.0, y_mm}));
    EXPECT_GT(most, painted / 2);
    EXPECT_EQ(thickness_of_active({30.0, 20.0}), 0);
    give(Command::Undo);
    EXPECT_EQ(layer_count(), 1U);
}

TEST_F(ClipboardWindow, BytesThatAreNoPaintAreRefusedInASentence) {
    auto* bad = new QMimeData;
    bad->setData(QStringLiteral("application/x-pastoso-paint"), "nonsense");
    QGuiApplication::clipboard()->setMimeData(bad);
    press_keys(Qt::Key_V);
    EXPECT_THAT(told(), HasSubstr("The clipboard: is no paint"));
    EXPECT_EQ(layer_count(), 1U);
}

}  // namespace
}  // namespace pastoso::tests
