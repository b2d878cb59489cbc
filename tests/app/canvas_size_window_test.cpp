// Another size of the canvas in the real window, and other ways round: asked for, undone, with guides
// and view following.
#include "app/window_fixture.hpp"
#include "dialogs/canvas_size_dialog.hpp"
#include "dialogs/rotate_dialog.hpp"
#include "dialogs/scale_dialog.hpp"
#include "main/window_parts.hpp"

#include <functional>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QStatusBar>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using testing::HasSubstr;
using testing::Not;

class CanvasSize : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        give(Command::Pause);
        studio().easel().take_brush("Flat bristle 20", 4.0);
        settle();
    }

    void give(Command command) {
        ASSERT_TRUE(action(command)->isEnabled()) << action(command)->text().toStdString();
        action(command)->trigger();
        loaded();
        settle();
    }

    /// Opens the dialog by its keys and does that in it.
    void in_dialog(const std::function<void(dialogs::CanvasSizeDialog&)>& act) {
        bool done = false;
        QTimer::singleShot(0, &window(), [&] {
            auto* dialog = window().findChild<dialogs::CanvasSizeDialog*>();
            ASSERT_NE(dialog, nullptr);
            act(*dialog);
            done = true;
            if (dialog->isVisible()) dialog->reject();
        });
        QTest::keyClick(&canvas(), Qt::Key_C, Qt::ControlModifier | Qt::AltModifier);
        EXPECT_TRUE(done);
        loaded();
        settle();
    }
    static QDoubleSpinBox& box(dialogs::CanvasSizeDialog& dialog, const char* name) {
        return *dialog.findChild<QDoubleSpinBox*>(QLatin1String(name));
    }
    static QPushButton& ok(dialogs::CanvasSizeDialog& dialog) {
        return *dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    }
    static QToolButton& anchor(dialogs::CanvasSizeDialog& dialog, int field) {
        return *dialog.findChildren<QToolButton*>().at(field);
    }
    static std::string summary(dialogs::CanvasSizeDialog& dialog) {
        return dialog.findChild<QLabel*>(QStringLiteral("summary"))->text().toStdString();
    }

    void resize(double width_mm, double height_mm, int field) {
        in_dialog([&](dialogs::CanvasSizeDialog& dialog) {
            box(dialog, "width_mm").setValue(width_mm);
            box(dialog, "height_mm").setValue(height_mm);
            anchor(dialog, field).click();
            ASSERT_TRUE(ok(dialog).isEnabled()) << summary(dialog);
            ok(dialog).click();
        });
    }

    glm::dvec2 size_mm() {
        const document::CanvasSettings canvas = session().canvas();
        return {canvas.width_mm, canvas.height_mm};
    }
    std::int32_t thickness_at(const glm::dvec2& place_mm) {
        const auto painting = session().snapshot();
        return painting->film.thickness.at(static_cast<int>(4.0 * place_mm.x),
                                           static_cast<int>(4.0 * place_mm.y));
    }
};

TEST_F(CanvasSize, PixelsAreReadByTheResolution) {
    const auto type = [](QDialog& dialog, const char* name, const char* words) {
        auto* box = dialog.findChild<QDoubleSpinBox*>(QLatin1String(name));
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, QLatin1String(words));
        QTest::keyClick(box, Qt::Key_Tab);
    };
    const document::CanvasSettings canvas = canvas_settings();
    ASSERT_EQ(canvas.px_per_mm, 4.0);
    in_dialog([&](dialogs::CanvasSizeDialog& dialog) {
        type(dialog, "width_mm", "200 px");
        EXPECT_EQ(box(dialog, "width_mm").value(), 50.0);
    });
    dialogs::ScaleDialog scale(canvas, &window());
    scale.show();
    wait_until_shown(scale);
    type(scale, "width_mm", "480 px");
    EXPECT_EQ(scale.wanted(), (document::ScaleCanvas{2.0, 2.0, 1.0}));
    type(scale, "px_per_mm", "8");
    type(scale, "width_mm", "480px");
    EXPECT_EQ(scale.wanted(), (document::ScaleCanvas{1.0, 1.0, 2.0})) << "by the resolution to be";
}

TEST_F(CanvasSize, WhatIsPaintedStaysWhereItIsOnTheScreenWithItsGuides) {
    give(Command::MirrorSymmetry);
    mouse_stroke(line_mm({10.0, 10.0}, {20.0, 20.0}));
    give(Command::Ruler);
    studio().easel().lay_guide(
        {.form = brush::Ruler{10.0, 10.0, 20.0, 20.0}});  // numbers that a shift there and back keeps
    settle();
    const std::int32_t painted = thickness_at({15.0, 15.0});
    ASSERT_GT(painted, 0);
    const brush::Ruler ruler = *studio().easel().hand().ruler();
    canvas().zoom_about_centre(1.5);
    const QPointF place = canvas().widget_position({15.0, 15.0});

    resize(80.0, 50.0, 8);  // the lower right corner stays
    EXPECT_EQ(size_mm(), glm::dvec2(80.0, 50.0));
    EXPECT_THAT(told(), HasSubstr("80 × 50 mm"));
    EXPECT_EQ(thickness_at({35.0, 25.0}), painted);
    EXPECT_LT((canvas().widget_position({35.0, 25.0}) - place).manhattanLength(), 0.01);
    EXPECT_EQ(studio().easel().hand().symmetry.centre_x_mm, 50.0);
    EXPECT_EQ(studio().easel().hand().symmetry.centre_y_mm, 30.0);
    EXPECT_DOUBLE_EQ(studio().easel().hand().ruler()->x1_mm, ruler.x1_mm + 20.0);
    EXPECT_DOUBLE_EQ(studio().easel().hand().ruler()->y2_mm, ruler.y2_mm + 10.0);

    give(Command::Undo);
    EXPECT_EQ(size_mm(), glm::dvec2(60.0, 40.0));
    EXPECT_EQ(thickness_at({15.0, 15.0}), painted);
    EXPECT_LT((canvas().widget_position({15.0, 15.0}) - place).manhattanLength(), 0.01);
    EXPECT_EQ(studio().easel().hand().symmetry.centre_x_mm, 30.0);
    EXPECT_EQ(studio().easel().hand().ruler(), ruler);

    give(Command::Redo);
    EXPECT_EQ(size_mm(), glm::dvec2(80.0, 50.0));
    EXPECT_EQ(studio().easel().hand().symmetry.centre_x_mm, 50.0);
    // The mirror that the next stroke meets has moved too.
    studio().easel().take_guide_away();
    mouse_stroke(line_mm({40.0, 40.0}, {44.0, 45.0}));
    settle();
    EXPECT_GT(thickness_at({42.0, 42.5}), 0);
    EXPECT_GT(thickness_at({58.0, 42.5}), 0);
}

TEST_F(CanvasSize, TheDialogSaysWhatBecomesOfTheCanvas) {
    in_dialog([&](dialogs::CanvasSizeDialog& dialog) {
        EXPECT_FALSE(ok(dialog).isEnabled());
        EXPECT_THAT(summary(dialog), HasSubstr("has this size"));
        box(dialog, "width_mm").setValue(50.0);
        box(dialog, "height_mm").setValue(44.0);
        EXPECT_TRUE(ok(dialog).isEnabled());
        EXPECT_THAT(summary(dialog), HasSubstr("200 × 176 pixels"));
        EXPECT_THAT(summary(dialog), HasSubstr("Cut off: 5 mm on the left, 5 mm on the right."));
        EXPECT_THAT(summary(dialog), HasSubstr("Added: 2 mm at the top, 2 mm at the bottom."));
        QApplication::setActiveWindow(&dialog);
        box(dialog, "height_mm").setFocus();
        QTest::keyClick(&box(dialog, "height_mm"), Qt::Key_Tab);
        EXPECT_TRUE(anchor(dialog, 4).hasFocus()) << "the one that is chosen";
        QTest::keyClick(&anchor(dialog, 4), Qt::Key_Left);
        EXPECT_TRUE(anchor(dialog, 3).isChecked());
        EXPECT_THAT(summary(dialog), HasSubstr("Cut off: 10 mm on the right."));
        QTest::keyClick(&anchor(dialog, 3), Qt::Key_Down);
        EXPECT_TRUE(anchor(dialog, 6).isChecked());
        EXPECT_THAT(summary(dialog), HasSubstr("Added: 4 mm at the top."));
        EXPECT_EQ(dialog.wanted(), (document::ResizeCanvas{0.0, -4.0, 50.0, 44.0}));
    });
    EXPECT_EQ(size_mm(), glm::dvec2(60.0, 40.0)) << "nothing was accepted";
}

TEST_F(CanvasSize, WhatIsTooLargeSaysSo) {
    document::CanvasSettings fine = canvas_settings();
    fine.px_per_mm = 16.0;
    parts().files.new_canvas(fine);
    loaded();
    settle();
    in_dialog([&](dialogs::CanvasSizeDialog& dialog) {
        box(dialog, "width_mm").setValue(5000.0);
        EXPECT_FALSE(ok(dialog).isEnabled());
        EXPECT_THAT(summary(dialog), HasSubstr("at most 32768 a side"));
        box(dialog, "width_mm").setValue(70.0);
        EXPECT_TRUE(ok(dialog).isEnabled());
        EXPECT_THAT(summary(dialog), Not(HasSubstr("at most")));
    });
}

TEST_F(CanvasSize, CroppingKeepsWhatIsSelected) {
    mouse_stroke(line_mm({10.0, 20.0}, {50.0, 20.0}));
    settle();
    const std::int32_t painted = thickness_at({30.0, 20.0});
    ASSERT_GT(painted, 0);
    EXPECT_FALSE(action(Command::CropToSelection)->isEnabled());
    studio().easel().select(document::SelectArea{{{20, 12}, {44, 12}, {44, 30}, {20, 30}}});
    settle();
    const QPointF place = canvas().widget_position({30.0, 20.0});
    give(Command::CropToSelection);
    EXPECT_EQ(size_mm(), glm::dvec2(24.0, 18.0));
    EXPECT_EQ(thickness_at({10.0, 8.0}), painted);
    EXPECT_LT((canvas().widget_position({10.0, 8.0}) - place).manhattanLength(), 0.01);
    give(Command::CropToSelection);
    EXPECT_EQ(size_mm(), glm::dvec2(24.0, 18.0));
    EXPECT_THAT(told(), HasSubstr("nothing to cut"));
    give(Command::Undo);
    EXPECT_EQ(size_mm(), glm::dvec2(60.0, 40.0));
    EXPECT_EQ(thickness_at({30.0, 20.0}), painted);
}

TEST_F(CanvasSize, NothingIsCroppedToWhatIsNotOutlined) {
    studio().easel().select(document::SelectArea{{{29, 19}, {31, 19}, {31, 21}, {29, 21}}});
    studio().easel().select(document::FeatherSelection{10.0});
    settle();
    give(Command::CropToSelection);
    EXPECT_EQ(size_mm(), glm::dvec2(60.0, 40.0));
    EXPECT_THAT(told(), HasSubstr("too soft"));
}

TEST_F(CanvasSize, MirroredItLiesWhereItLayWithItsGuides) {
    mouse_stroke(line_mm({10.0, 10.0}, {20.0, 20.0}));
    give(Command::Ruler);
    studio().easel().lay_guide({.form = brush::Ruler{10.0, 10.0, 20.0, 20.0}});
    settle();
    const std::int32_t painted = thickness_at({15.0, 15.0});
    ASSERT_GT(painted, 0);
    canvas().zoom_about_centre(1.5);
    const QPointF middle = canvas().widget_position({30.0, 20.0});
    give(Command::MirrorImageHorizontally);
    EXPECT_EQ(thickness_at({59.8 - 15.0, 15.0}), painted) << "the cell whose left edge was at 15 mm";
    EXPECT_EQ(studio().easel().hand().ruler(), (brush::Ruler{50.0, 10.0, 40.0, 20.0}));
    EXPECT_LT((canvas().widget_position({30.0, 20.0}) - middle).manhattanLength(), 0.01);
    give(Command::MirrorImageVertically);
    EXPECT_EQ(thickness_at({59.8 - 15.0, 39.8 - 15.0}), painted);
    give(Command::RotateImageAround);
    EXPECT_EQ(thickness_at({15.0, 15.0}), painted);
    for (int step = 0; step < 3; ++step)
        give(Command::Undo);
    EXPECT_EQ(thickness_at({15.0, 15.0}), painted);
    EXPECT_EQ(studio().easel().hand().ruler(), (brush::Ruler{10.0, 10.0, 20.0, 20.0}));
}

TEST_F(CanvasSize, TurnedItKeepsItsMiddleOrIsFittedAgain) {
    mouse_stroke(line_mm({10.0, 10.0}, {20.0, 20.0}));
    settle();
    const std::int32_t painted = thickness_at({15.0, 15.0});
    ASSERT_GT(painted, 0);
    canvas().fit();
    give(Command::RotateImageRight);
    EXPECT_EQ(size_mm(), glm::dvec2(40.0, 60.0));
    EXPECT_EQ(thickness_at({39.8 - 15.0, 15.0}), painted);
    const screen::ViewTransform shown = canvas().view_transform();
    canvas().fit();
    EXPECT_EQ(canvas().view_transform(), shown);
    canvas().zoom_about_centre(1.5);
    const QPointF middle = canvas().widget_position({20.0, 30.0});
    give(Command::RotateImageLeft);
    EXPECT_EQ(size_mm(), glm::dvec2(60.0, 40.0));
    EXPECT_EQ(thickness_at({15.0, 15.0}), painted);
    EXPECT_LT((canvas().widget_position({30.0, 20.0}) - middle).manhattanLength(), 0.01);
}

TEST_F(CanvasSize, AnotherPaintingIsNoCanvasThatWasCut) {
    give(Command::Ruler);
    const brush::Ruler ruler = *studio().easel().hand().ruler();
    resize(80.0, 40.0, 5);
    ASSERT_NE(studio().easel().hand().ruler(), ruler);
    const brush::Ruler moved = *studio().easel().hand().ruler();
    parts().files.new_canvas(canvas_settings());
    loaded();
    settle();
    EXPECT_EQ(studio().easel().hand().ruler(), moved);
    give(Command::FitCanvas);
    const screen::ViewTransform fitted = canvas().view_transform();
    parts().files.new_canvas({.width_mm = 40.0, .height_mm = 40.0});
    loaded();
    settle();
    EXPECT_NE(canvas().view_transform(), fitted) << "it is shown whole";
}

class ScaledImage : public CanvasSize {
  protected:
    void in_scale_dialog(const std::function<void(dialogs::ScaleDialog&)>& act) {
        bool done = false;
        QTimer::singleShot(0, &window(), [&] {
            auto* dialog = window().findChild<dialogs::ScaleDialog*>();
            ASSERT_NE(dialog, nullptr);
            act(*dialog);
            done = true;
            if (dialog->isVisible()) dialog->reject();
        });
        QTest::keyClick(&canvas(), Qt::Key_I, Qt::ControlModifier | Qt::AltModifier);
        EXPECT_TRUE(done);
        settle();
    }
    template <class Child>
    static Child& child(dialogs::ScaleDialog& dialog, const char* name) {
        return *dialog.findChild<Child*>(QLatin1String(name));
    }
    static QPushButton& scale_ok(dialogs::ScaleDialog& dialog) {
        return *dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    }
    static std::string words(dialogs::ScaleDialog& dialog) {
        return child<QLabel>(dialog, "summary").text().toStdString();
    }
    void scale(const char* number, double value) {
        in_scale_dialog([&](dialogs::ScaleDialog& dialog) {
            child<QDoubleSpinBox>(dialog, number).setValue(value);
            ASSERT_TRUE(scale_ok(dialog).isEnabled()) << words(dialog);
            scale_ok(dialog).click();
        });
    }
};

TEST_F(ScaledImage, ThePaintingIsDrawnOutWithItsGuidesAndUndoBringsItBack) {
    give(Command::Ruler);
    studio().easel().lay_guide({.form = brush::Ruler{10.0, 10.0, 20.0, 20.0}});
    mouse_stroke(line_mm({30.0, 10.0}, {40.0, 20.0}));
    settle();
    const brush::Ruler ruler = *studio().easel().hand().ruler();
    scale("width_mm", 90.0);
    EXPECT_EQ(size_mm(), glm::dvec2(90.0, 60.0));
    EXPECT_EQ(session().canvas().px_per_mm, 4.0);
    EXPECT_DOUBLE_EQ(studio().easel().hand().ruler()->x2_mm, 30.0);
    EXPECT_GT(thickness_at({52.5, 22.5}), 0);
    give(Command::Undo);
    EXPECT_EQ(size_mm(), glm::dvec2(60.0, 40.0));
    EXPECT_EQ(studio().easel().hand().ruler(), ruler);
}

TEST_F(ScaledImage, OnFinerCellsTheStrokesGoOn) {
    mouse_stroke(line_mm({30.0, 10.0}, {40.0, 20.0}));
    settle();
    scale("px_per_mm", 8.0);
    EXPECT_EQ(size_mm(), glm::dvec2(60.0, 40.0));
    EXPECT_EQ(session().canvas().px_per_mm, 8.0);
    EXPECT_EQ(session().snapshot()->film.shape, (grid::Shape{480, 320}));
    mouse_stroke(line_mm({10.0, 30.0}, {20.0, 30.0}));
    settle();
    EXPECT_GT(session().snapshot()->film.thickness.at(120, 240), 0);
    EXPECT_GT(session().snapshot()->film.thickness.at(280, 120), 0);
}

TEST_F(ScaledImage, TheDialogSaysWhatBecomesOfTheImage) {
    in_scale_dialog([&](dialogs::ScaleDialog& dialog) {
        EXPECT_FALSE(scale_ok(dialog).isEnabled());
        EXPECT_THAT(words(dialog), HasSubstr("has this size"));
        child<QDoubleSpinBox>(dialog, "height_mm").setValue(20.0);
        EXPECT_EQ(child<QDoubleSpinBox>(dialog, "width_mm").value(), 30.0);
        EXPECT_THAT(words(dialog), HasSubstr("120 × 80 pixels, 102 dpi"));
        EXPECT_THAT(words(dialog), HasSubstr("0.25 times as much"));
        child<QDoubleSpinBox>(dialog, "height_mm").setValue(25.0);
        EXPECT_EQ(child<QDoubleSpinBox>(dialog, "width_mm").value(), 37.5);
        child<QDoubleSpinBox>(dialog, "width_mm").setValue(35.0);
        EXPECT_EQ(child<QDoubleSpinBox>(dialog, "height_mm").value(), 23.33);
        EXPECT_EQ(dialog.wanted(), (document::ScaleCanvas{35.0 / 60.0, 35.0 / 60.0, 1.0})) << "exactly";
        child<QDoubleSpinBox>(dialog, "height_mm").setValue(20.0);
        child<QCheckBox>(dialog, "proportions").setChecked(false);
        child<QDoubleSpinBox>(dialog, "height_mm").setValue(40.0);
        EXPECT_EQ(child<QDoubleSpinBox>(dialog, "width_mm").value(), 30.0);
        EXPECT_EQ(dialog.wanted(), (document::ScaleCanvas{0.5, 1.0, 1.0}));
        child<QDoubleSpinBox>(dialog, "px_per_mm").setValue(70.0);
        EXPECT_FALSE(scale_ok(dialog).isEnabled());
        EXPECT_THAT(words(dialog), HasSubstr("between 0.25 and 64"));
    });
    EXPECT_EQ(size_mm(), glm::dvec2(60.0, 40.0));
}

class RotatedImage : public CanvasSize {
  protected:
    void in_rotate_dialog(const std::function<void(dialogs::RotateDialog&)>& act) {
        bool done = false;
        QTimer::singleShot(0, &window(), [&] {
            auto* dialog = window().findChild<dialogs::RotateDialog*>();
            ASSERT_NE(dialog, nullptr);
            act(*dialog);
            done = true;
            if (dialog->isVisible()) dialog->reject();
        });
        give(Command::RotateImage);
        EXPECT_TRUE(done);
        settle();
    }
    template <class Child>
    static Child& child(dialogs::RotateDialog& dialog, const char* name) {
        return *dialog.findChild<Child*>(QLatin1String(name));
    }
    static QPushButton& rotate_ok(dialogs::RotateDialog& dialog) {
        return *dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    }
    static std::string words(dialogs::RotateDialog& dialog) {
        return child<QLabel>(dialog, "summary").text().toStdString();
    }
    void rotate(double turn_deg, bool keeps_size) {
        in_rotate_dialog([&](dialogs::RotateDialog& dialog) {
            child<QDoubleSpinBox>(dialog, "turn").setValue(turn_deg);
            child<QCheckBox>(dialog, "keeps_size").setChecked(keeps_size);
            ASSERT_TRUE(rotate_ok(dialog).isEnabled()) << words(dialog);
            rotate_ok(dialog).click();
        });
    }
};

TEST_F(RotatedImage, ThePaintingIsTurnedWithItsGuidesAndUndoBringsItBack) {
    studio().easel().lay_guide({.form = brush::Ruler{30.0, 20.0, 40.0, 20.0}});
    mouse_stroke(line_mm({36.0, 20.0}, {44.0, 20.0}));
    settle();
    const brush::Ruler ruler = *studio().easel().hand().ruler();
    rotate(90.0, true);
    EXPECT_EQ(size_mm(), glm::dvec2(60.0, 40.0));
    EXPECT_GT(thickness_at({30.0, 30.0}), 0) << "10 mm below the middle";
    EXPECT_NEAR(studio().easel().hand().ruler()->x2_mm, 30.0, 1e-9);
    EXPECT_NEAR(studio().easel().hand().ruler()->y2_mm, 30.0, 1e-9);
    give(Command::Undo);
    EXPECT_GT(thickness_at({40.0, 20.0}), 0);
    EXPECT_NEAR(studio().easel().hand().ruler()->x2_mm, ruler.x2_mm, 1e-9);
    rotate(30.0, false);
    EXPECT_NEAR(size_mm().x, 60.0 * std::sqrt(0.75) + 20.0, 1e-6);
    EXPECT_NEAR(size_mm().y, 30.0 + 40.0 * std::sqrt(0.75), 1e-6);
    give(Command::Undo);
    EXPECT_EQ(size_mm(), glm::dvec2(60.0, 40.0));
}

TEST_F(RotatedImage, ARulerAlongTheHorizonIsPutStraight) {
    in_rotate_dialog([&](dialogs::RotateDialog& dialog) {
        EXPECT_FALSE(child<QPushButton>(dialog, "straighten").isEnabled()) << "there is no ruler yet";
    });
    studio().easel().lay_guide({.form = brush::Ruler{10.0, 20.0, 50.0, 22.0}});
    settle();
    in_rotate_dialog([&](dialogs::RotateDialog& dialog) {
        child<QPushButton>(dialog, "straighten").click();
        EXPECT_EQ(child<QDoubleSpinBox>(dialog, "turn").value(), -2.86);
        rotate_ok(dialog).click();
    });
    const brush::Ruler ruler = *studio().easel().hand().ruler();
    EXPECT_NEAR(ruler.y2_mm, ruler.y1_mm, 0.01);
}

TEST_F(RotatedImage, TheDialogSaysWhatBecomesOfTheCanvas) {
    in_rotate_dialog([&](dialogs::RotateDialog& dialog) {
        EXPECT_FALSE(rotate_ok(dialog).isEnabled());
        EXPECT_THAT(words(dialog), HasSubstr("stands like this"));
        child<QDoubleSpinBox>(dialog, "turn").setValue(-30.0);
        EXPECT_TRUE(rotate_ok(dialog).isEnabled());
        EXPECT_THAT(words(dialog), HasSubstr("71.96 × 64.64 mm"));
        EXPECT_THAT(words(dialog), HasSubstr("is bare"));
        child<QCheckBox>(dialog, "keeps_size").setChecked(true);
        EXPECT_THAT(words(dialog), HasSubstr("60 × 40 mm"));
        EXPECT_THAT(words(dialog), HasSubstr("wiped off"));
        EXPECT_EQ(dialog.wanted(), (document::RotateCanvas{-30.0, true}));
    });
    EXPECT_EQ(size_mm(), glm::dvec2(60.0, 40.0));
}

TEST_F(RotatedImage, TheDialogWritesNumbersAsTheLanguageDoes) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::Swedish));
    dialogs::RotateDialog dialog(canvas_settings(), QImage(60, 40, QImage::Format_RGB888), {},
                                 &window());
    child<QDoubleSpinBox>(dialog, "turn").setValue(-30.0);
    EXPECT_THAT(words(dialog), HasSubstr("71,96 × 64,64 mm"));
    QLocale::setDefault(before);
}

}  // namespace
}  // namespace pastoso::tests
