// Dry paint adjusted in the real window: chosen and foretold in a dialog, one step for Undo.
#include "app/selection_fixture.hpp"
#include "dialogs/adjust_dialog.hpp"

#include <variant>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using Way = dialogs::ChosenAdjustment::Way;
using testing::HasSubstr;

class AdjustWindow : public SelectionFixture {
  protected:
    void lay_dry_blue() {
        studio().choose_paint({{{"PB29", 1.0}}});
        give(Command::FillPaint);
        give(Command::DryNow);
    }
    void take_white() {
        studio().choose_paint({{{"PW6", 1.0}}});
        settle();
    }
    dialogs::AdjustDialog* dialog() { return window().findChild<dialogs::AdjustDialog*>(); }
    dialogs::AdjustDialog& opened() {
        give(Command::AdjustDryPaint);
        return *dialog();
    }
    template <class Widget>
    static Widget& part(dialogs::AdjustDialog& from, const char* name) {
        return *from.findChild<Widget*>(QString::fromLatin1(name));
    }
    static void choose(dialogs::AdjustDialog& from, Way way) {
        part<QComboBox>(from, "way").setCurrentIndex(static_cast<int>(way));
    }
    static QColor swatch(dialogs::AdjustDialog& from, const char* name) {
        return part<QLabel>(from, name).pixmap(Qt::ReturnByValue).toImage().pixelColor(5, 5);
    }
    /// It is closed and gone.
    void adjust(dialogs::AdjustDialog& from) {
        from.accept();
        settle();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        session().wait_until_applied();
    }
    document::AdjustDryPaint last() {
        session().wait_until_applied();
        return std::get<document::AdjustDryPaint>(session().recording().events.back().action);
    }
    static film::StrataOptics optics_of(const document::Snapshot& painting, double x_mm, double y_mm) {
        return painting.film.strata.optics.at(static_cast<int>(x_mm / painting.film.cell_mm),
                                              static_cast<int>(y_mm / painting.film.cell_mm));
    }
    film::StrataOptics optics(double x_mm, double y_mm) {
        session().wait_until_applied();
        return optics_of(*session().snapshot(), x_mm, y_mm);
    }
    film::StrataOptics shown_optics(double x_mm, double y_mm) {
        return optics_of(*canvas().shown(), x_mm, y_mm);
    }
    bool shows_the_painting() { return canvas().shown() == session().snapshot().get(); }
    /// Until the canvas shows this of the middle.
    void wait_for_shown(const film::StrataOptics& optics) {
        wait_for([&] { return shown_optics(20.0, 20.0) == optics; });
    }
    /// What the middle becomes.
    film::StrataOptics adjusted_optics(Way way) {
        dialogs::AdjustDialog& asked = opened();
        choose(asked, way);
        adjust(asked);
        const film::StrataOptics after = optics(20.0, 20.0);
        give(Command::Undo);
        return after;
    }
};

TEST_F(AdjustWindow, ALayerWithoutDryPaintIsToldAndNothingAsked) {
    give(Command::AdjustDryPaint);
    EXPECT_EQ(dialog(), nullptr);
    EXPECT_THAT(told(), HasSubstr("no dry paint"));
    lay_dry_blue();
    give(Command::LockLayer);
    give(Command::AdjustDryPaint);
    EXPECT_EQ(dialog(), nullptr);
    EXPECT_THAT(told(), HasSubstr("locked"));
}

TEST_F(AdjustWindow, AGlazeOfThePaintInHandIsLaid) {
    lay_dry_blue();
    take_white();
    const film::StrataOptics before = optics(20.0, 20.0);
    dialogs::AdjustDialog& asked = opened();
    EXPECT_FALSE(part<QDoubleSpinBox>(asked, "share").isVisibleTo(&asked));
    part<QDoubleSpinBox>(asked, "thickness_um").setValue(30.0);
    EXPECT_GT(swatch(asked, "after").red(), swatch(asked, "before").red());
    adjust(asked);
    EXPECT_EQ(last().paint, studio().easel().hand().paint);
    EXPECT_DOUBLE_EQ(std::get<layers::Glaze>(last().way).thickness_mm, 0.03);
    EXPECT_NE(optics(20.0, 20.0), before);
    EXPECT_EQ(volume_mm3(), 0.0) << "nothing of it is wet";
    give(Command::Undo);
    EXPECT_EQ(optics(20.0, 20.0), before);
    EXPECT_EQ(opened().chosen().glaze.thickness_mm, 0.03) << "as it was chosen last";
}

TEST_F(AdjustWindow, OtherPigmentsKeepToTheSelection) {
    lay_dry_blue();
    take_white();
    give(Command::SelectRectangle);
    drag({{10.0, 10.0}, {40.0, 30.0}});
    const film::StrataOptics before = optics(25.0, 20.0);
    dialogs::AdjustDialog& asked = opened();
    choose(asked, Way::Exchange);
    EXPECT_FALSE(part<QDoubleSpinBox>(asked, "thickness_um").isVisibleTo(&asked));
    EXPECT_THAT(part<QLabel>(asked, "meaning").text().toStdString(), HasSubstr("replaced"));
    part<QDoubleSpinBox>(asked, "share").setValue(0.0);
    EXPECT_EQ(swatch(asked, "after"), swatch(asked, "before"));
    part<QDoubleSpinBox>(asked, "share").setValue(75.0);
    EXPECT_GT(swatch(asked, "after").red(), swatch(asked, "before").red());
    adjust(asked);
    EXPECT_DOUBLE_EQ(std::get<layers::PaintExchange>(last().way).share, 0.75);
    EXPECT_NE(optics(25.0, 20.0), before);
    EXPECT_EQ(optics(50.0, 20.0), before);
}

TEST_F(AdjustWindow, AnotherPaintTakenMeanwhileIsForetold) {
    lay_dry_blue();
    dialogs::AdjustDialog& asked = opened();
    choose(asked, Way::Exchange);
    const QColor in_blue = swatch(asked, "after");
    take_white();
    EXPECT_GT(swatch(asked, "after").red(), in_blue.red());
}

TEST_F(AdjustWindow, AnotherLayerAnotherSelectionOrMaskingClosesTheDialog) {
    const auto is_closed = [this] { return dialog() == nullptr || !dialog()->isVisible(); };
    lay_dry_blue();
    opened();
    give(Command::AddLayer);
    EXPECT_TRUE(is_closed());
    give(Command::Undo);
    opened();
    studio().easel().select(document::SelectArea{{{0, 0}, {15, 0}, {15, 40}, {0, 40}}});
    settle();
    EXPECT_TRUE(is_closed());
    opened();
    give(Command::MaskSelection);
    EXPECT_TRUE(is_closed());
}

TEST_F(AdjustWindow, WhatIsTakenBackMeanwhileIsSeen) {
    lay_dry_blue();
    take_white();
    dialogs::AdjustDialog& first = opened();
    const QColor blue = swatch(first, "before");
    part<QDoubleSpinBox>(first, "thickness_um").setValue(100.0);
    adjust(first);
    dialogs::AdjustDialog& asked = opened();
    EXPECT_NE(swatch(asked, "before"), blue);
    give(Command::Undo);
    wait_for([&] { return swatch(asked, "before") == blue; });
    give(Command::Undo);
    wait_for([&] { return dialog() == nullptr || !dialog()->isVisible(); });
}

TEST_F(AdjustWindow, OnlyWhatIsDoneIsReported) {
    lay_dry_blue();
    dialogs::AdjustDialog& asked = opened();
    give(Command::LockLayer);
    ASSERT_TRUE(asked.isVisible());
    asked.accept();
    EXPECT_THAT(told(), HasSubstr("locked"));
}

TEST_F(AdjustWindow, AMediumOfWhichNothingStaysIsNoGlaze) {
    lay_dry_blue();
    studio().easel().use_medium("thinner");
    studio().show_hand();
    settle();
    dialogs::AdjustDialog& asked = opened();
    EXPECT_FALSE(asked.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled());
    EXPECT_TRUE(part<QLabel>(asked, "problem").isVisibleTo(&asked));
}

TEST_F(AdjustWindow, TheCanvasShowsWhatWillCome) {
    lay_dry_blue();
    take_white();
    for (const Way way : {Way::Glaze, Way::Exchange}) {
        const film::StrataOptics after = adjusted_optics(way);
        ASSERT_NE(after, optics(20.0, 20.0));
        dialogs::AdjustDialog& asked = opened();
        ASSERT_EQ(asked.chosen().way, way) << "as it was chosen last";
        wait_for_shown(after);
        EXPECT_NE(optics(20.0, 20.0), after) << "the painting is as it was";
        adjust(asked);
        EXPECT_EQ(optics(20.0, 20.0), after);
        EXPECT_TRUE(shows_the_painting());
        give(Command::Undo);
    }
}

TEST_F(AdjustWindow, ThePreviewKeepsToTheSelectionAndFollowsTheNumber) {
    lay_dry_blue();
    take_white();
    give(Command::SelectRectangle);
    drag({{10.0, 10.0}, {40.0, 30.0}});
    dialogs::AdjustDialog& asked = opened();
    choose(asked, Way::Exchange);
    const film::StrataOptics before = optics(20.0, 20.0);
    wait_for([&] { return shown_optics(20.0, 20.0) != before; });
    EXPECT_EQ(shown_optics(50.0, 20.0), before);
    part<QDoubleSpinBox>(asked, "share").setValue(0.0);
    wait_for_shown(before);
}

TEST_F(AdjustWindow, CancelLeavesAllAsItWas) {
    lay_dry_blue();
    take_white();
    const QImage picture_before = picture();
    const std::int64_t events = events_posted();
    const std::uint64_t before = film::state_hash(session().snapshot()->film);
    dialogs::AdjustDialog& asked = opened();
    choose(asked, Way::Exchange);
    wait_for([&] { return shown_optics(20.0, 20.0) != optics(20.0, 20.0); });
    EXPECT_NE(picture(), picture_before);
    asked.reject();
    settle();
    EXPECT_TRUE(shows_the_painting());
    EXPECT_EQ(events_posted(), events);
    EXPECT_EQ(film::state_hash(session().snapshot()->film), before);
    EXPECT_EQ(picture(), picture_before);
}

TEST_F(AdjustWindow, WithoutThePreviewTheCanvasStaysAsItIs) {
    lay_dry_blue();
    take_white();
    dialogs::AdjustDialog& asked = opened();
    auto& preview = part<QCheckBox>(asked, "preview");
    EXPECT_TRUE(preview.isChecked());
    wait_for([&] { return shown_optics(20.0, 20.0) != optics(20.0, 20.0); });
    preview.setChecked(false);
    wait_for([&] { return shows_the_painting(); });
    asked.reject();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    dialogs::AdjustDialog& again = opened();
    EXPECT_FALSE(part<QCheckBox>(again, "preview").isChecked()) << "as it was chosen last";
    EXPECT_TRUE(shows_the_painting());
}

TEST_F(AdjustWindow, ThePreviewFollowsThePaintInHandAndWhatIsTakenBack) {
    lay_dry_blue();
    take_white();
    const film::StrataOptics once = adjusted_optics(Way::Exchange);
    adjust(opened());
    opened();
    wait_for([&] { return shown_optics(20.0, 20.0) != once; });
    give(Command::Undo);
    wait_for_shown(once);
    studio().choose_paint({{{"PB29", 1.0}}});
    wait_for([&] { return shown_optics(20.0, 20.0) != once; });
}

TEST_F(AdjustWindow, AnotherLayerEndsThePreview) {
    lay_dry_blue();
    take_white();
    opened();
    wait_for([&] { return shown_optics(20.0, 20.0) != optics(20.0, 20.0); });
    give(Command::AddLayer);
    wait_for([&] { return shows_the_painting(); });
}

}  // namespace
}  // namespace pastoso::tests
