// A colour becomes paint: picked by its channels, typed, taken from the canvas or from a palette; and
// the recipe from the tubes may take its place.
#include "app/window_fixture.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "main/window_parts.hpp"
#include "panels/colour/colour_panel.hpp"
#include "panels/colour/colour_wheel.hpp"
#include "panels/paint/paint_panel.hpp"
#include "panels/paint/tube_menu.hpp"
#include "pigment/hex_colour.hpp"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QStatusBar>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using testing::HasSubstr;

class MixingWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        give(Command::Pause);
        give(Command::ColourPanel);
    }

    void give(Command command) { studio().commands().action(command)->trigger(); }

    template <class Widget>
    Widget& find(const char* name) {
        auto* found = window().findChild<Widget*>(QString::fromLatin1(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    void click(QWidget& widget) { QTest::mouseClick(&widget, Qt::LeftButton); }
    std::string recipe() { return find<QLabel>("recipe").text().toStdString(); }
    const std::vector<document::Ingredient>& paint() {
        return studio().easel().hand().paint.ingredients;
    }
    /// The paint of the last dip in the recording.
    document::PaintRecipe dipped() {
        session().wait_until_applied();
        document::PaintRecipe paint;
        for (const document::Event& event : session().recording().events) {
            const auto* load = std::get_if<document::LoadPaint>(&event.action);
            if (load != nullptr) paint = load->paint;
        }
        return paint;
    }

    void type(const QString& colour) {
        auto& hex = find<QLineEdit>("hex");
        hex.setText(colour);
        QTest::keyClick(&hex, Qt::Key_Return);
    }
    void click_canvas(const glm::dvec2& place_mm, Qt::KeyboardModifiers modifiers) {
        const QPoint place = canvas().widget_position(place_mm).toPoint();
        QTest::mousePress(&canvas(), Qt::LeftButton, modifiers, place);
        QTest::mouseRelease(&canvas(), Qt::LeftButton, modifiers, place);
    }
};

TEST_F(MixingWindow, ATypedColourIsWhatTheBrushPaints) {
    type(QStringLiteral("e05020"));
    ASSERT_EQ(paint().size(), 1U);
    EXPECT_EQ(paint()[0].pigment, "#e05020");
    EXPECT_THAT(recipe(), HasSubstr("ΔE"));
    for (int i = 0; i < 3; ++i)
        mouse_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}));
    EXPECT_EQ(dipped(), studio().easel().hand().paint);
    const QImage after = picture();
    const double ratio = canvas().devicePixelRatioF();
    const QColor painted = after.pixelColor((ratio * canvas().widget_position({30.0, 20.0})).toPoint());
    EXPECT_GT(painted.red(), painted.green() + 60);
    EXPECT_GT(painted.red(), painted.blue() + 60);
    EXPECT_TRUE(session().take_errors().empty());
}

TEST_F(MixingWindow, WhatIsNoColourIsToldAndThePaintStays) {
    const auto before = studio().easel().hand().paint;
    type(QStringLiteral("#12345"));
    EXPECT_THAT(told(), HasSubstr("\"#12345\" is no colour"));
    EXPECT_EQ(studio().easel().hand().paint, before);
    EXPECT_EQ(find<QLineEdit>("hex").text().size(), 7);
}

TEST_F(MixingWindow, ChannelsOfEveryModelChangeTheColour) {
    click(find<QToolButton>("model_rgb"));
    type(QStringLiteral("#204060"));
    find<QDoubleSpinBox>("channel_0").setValue(224.0);
    EXPECT_EQ(paint()[0].pigment, "#e04060");
    click(find<QToolButton>("model_hsv"));
    EXPECT_EQ(paint()[0].pigment, "#e04060") << "another way to look at it changes nothing";
    find<QDoubleSpinBox>("channel_1").setValue(0.0);
    EXPECT_EQ(paint()[0].pigment, "#e0e0e0");
    click(find<QToolButton>("model_oklch"));
    find<QDoubleSpinBox>("channel_0").setValue(0.0);
    EXPECT_EQ(paint()[0].pigment, "#000000");
}

TEST_F(MixingWindow, ASliderPaintsOnceItIsLetGo) {
    click(find<QToolButton>("model_hsv"));
    type(QStringLiteral("#ff0000"));
    auto& hue = find<QSlider>("channel_slider_0");
    const QPoint left(4, hue.height() / 2), middle(hue.width() / 2, hue.height() / 2);
    QTest::mousePress(&hue, Qt::LeftButton, {}, left);
    QMouseEvent drag(QEvent::MouseMove, middle, hue.mapToGlobal(middle), Qt::NoButton, Qt::LeftButton,
                     {});
    QApplication::sendEvent(&hue, &drag);
    EXPECT_EQ(paint()[0].pigment, "#ff0000");
    EXPECT_EQ(find<QLineEdit>("hex").text().toStdString().substr(0, 3), "#00");
    QTest::mouseRelease(&hue, Qt::LeftButton, {}, middle);
    EXPECT_EQ(paint()[0].pigment.substr(0, 3), "#00") << "cyan lies opposite red";
}

TEST_F(MixingWindow, TheNearestFromTheTubesIsSeenWithoutScrolling) {
    type(QStringLiteral("#7a5c3e"));
    give(Command::ResetPanels);
    give(Command::ColourPanel);
    window().setMinimumHeight(700);  // a screen of 768 cuts it, whatever it would like
    for (const QSize& size : {QSize(1280, 800), QSize(1366, 768)}) {
        window().resize(size);
        wait_for([&] { return window().size() == size; });
        QApplication::sendPostedEvents();
        const auto is_seen = [](const QWidget& part) {
            return part.visibleRegion().boundingRect() == part.rect();
        };
        EXPECT_TRUE(is_seen(*window().findChild<panels::ColourWheel*>())) << size.height();
        for (const char* part : {"wanted_colour", "nearest_colour", "use_recipe", "recipe"})
            EXPECT_TRUE(is_seen(find<QWidget>(part))) << part << " at " << size.height();
    }
}

TEST_F(MixingWindow, TheRecipeTakesTheColoursPlace) {
    type(QStringLiteral("#7a5c3e"));
    auto& use_recipe = find<QPushButton>("use_recipe");
    click(use_recipe);
    ASSERT_GE(paint().size(), 2U);
    for (const document::Ingredient& ingredient : paint())
        EXPECT_EQ(ingredient.pigment.front(), 'P');
    EXPECT_FALSE(use_recipe.isEnabled());
    EXPECT_EQ(dipped(), studio().easel().hand().paint);
    EXPECT_TRUE(session().take_errors().empty());
    click(find<QPushButton>("wanted_colour"));
    EXPECT_EQ(paint()[0].pigment, "#7a5c3e");
    EXPECT_TRUE(use_recipe.isEnabled());
}

TEST_F(MixingWindow, ATubeIsItsOwnRecipe) {
    EXPECT_THAT(recipe(), HasSubstr("Ultramarine blue\nΔE 0.0"));
    EXPECT_FALSE(find<QPushButton>("use_recipe").isEnabled());
}

TEST_F(MixingWindow, PaintsThatWereUsedComeBackAtAClick) {
    type(QStringLiteral("#113355"));
    type(QStringLiteral("#dd9900"));
    auto* recent = window().findChild<QWidget*>(QStringLiteral("recent_paints"));
    const auto patches = recent->findChildren<QPushButton*>();
    ASSERT_GE(patches.size(), 3);
    click(*patches[1]);
    EXPECT_EQ(paint()[0].pigment, "#113355");
    EXPECT_TRUE(patches[0]->toolTip().contains(QStringLiteral("#113355")));
}

TEST_F(MixingWindow, ACtrlClickTakesTheColourOfThePaintThere) {
    type(QStringLiteral("#c03020"));
    for (int i = 0; i < 4; ++i)
        mouse_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}));
    const double volume = volume_mm3();
    type(QStringLiteral("#2050c0"));
    click_canvas({30.0, 20.0}, Qt::ControlModifier);
    EXPECT_EQ(volume_mm3(), volume) << "picking does not paint";
    const auto picked = pigment::parse_hex_colour(paint()[0].pigment);
    ASSERT_TRUE(picked.has_value());
    // Thick paint over white ground: its masstone to a few steps.
    EXPECT_NEAR((*picked)[0], 0xc0, 8);
    EXPECT_NEAR((*picked)[1], 0x30, 8);
    EXPECT_NEAR((*picked)[2], 0x20, 8);
    click_canvas({30.0, 34.0}, Qt::AltModifier);
    EXPECT_GT((*pigment::parse_hex_colour(paint()[0].pigment))[2], 200) << "the bare ground";
}

TEST_F(MixingWindow, TheNextClickPicksOnce) {
    give(Command::PickColour);
    click_canvas({30.0, 20.0}, {});
    EXPECT_EQ(volume_mm3(), 0.0);
    EXPECT_EQ(paint()[0].pigment.front(), '#');
    EXPECT_FALSE(studio().commands().action(Command::PickColour)->isChecked());
    mouse_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}));
    EXPECT_GT(volume_mm3(), 0.0);
    click_canvas({-3.0, 20.0}, Qt::ControlModifier);
    EXPECT_THAT(told(), HasSubstr("beside the canvas"));
}

TEST_F(MixingWindow, APaletteGivesItsColoursAndABadOneIsTold) {
    const TemporaryFolder folder;
    const auto file = [&](const char* name, const char* text) {
        core::write_text_file(folder.path() / name, text);
        return QString::fromStdString((folder.path() / name).string());
    };
    parts().paints.open_palette(
        file("good.gpl", "GIMP Palette\nName: Earths\n120 60 20 Umber\n200 150 60 Ochre\n"));
    auto* grid = window().findChild<QWidget*>(QStringLiteral("palette"));
    const auto patches = grid->findChildren<QPushButton*>();
    ASSERT_EQ(patches.size(), 2);
    click(*patches[1]);
    EXPECT_EQ(paint()[0].pigment, "#c8963c");
    parts().paints.open_palette(file("bad.gpl", "GIMP Palette\nName: Bad\n120 600 20 Umber\n"));
    EXPECT_THAT(told(), HasSubstr("bad.gpl, line 3"));
    EXPECT_TRUE(patches[1]->isVisible());
    EXPECT_EQ(paint()[0].pigment, "#c8963c");
}

TEST_F(MixingWindow, APaletteOfAPictureGivesRecipesOfTubesToo) {
    const TemporaryFolder folder;
    QImage image(40, 20, QImage::Format_RGB32);
    image.fill(QColor(122, 92, 62));
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 40; ++x)
            image.setPixelColor(x, y, QColor(40, 80, 160));
    const QString file = QString::fromStdString((folder.path() / "lake.png").string());
    ASSERT_TRUE(image.save(file));
    parts().paints.open_picture(file, 5);
    loaded();
    auto* grid = window().findChild<QWidget*>(QStringLiteral("palette"));
    const auto patches = grid->findChildren<QPushButton*>();
    ASSERT_EQ(patches.size(), 2) << "it has no more";
    click(*patches[1]);
    EXPECT_EQ(paint()[0].pigment, "#7a5c3e");
    find<QCheckBox>("palette_from_tubes").setChecked(true);
    click(*patches[1]);
    ASSERT_GE(paint().size(), 2U);
    EXPECT_EQ(paint()[0].pigment.front(), 'P');
    const document::PaintRecipe recipe = studio().easel().hand().paint;
    click(find<QPushButton>("wanted_colour"));
    click(find<QPushButton>("use_recipe"));
    EXPECT_EQ(studio().easel().hand().paint, recipe) << "the one that the panel finds";
}

TEST_F(MixingWindow, ThePaletteIsSavedForOtherPrograms) {
    const TemporaryFolder folder;
    const QString file = QString::fromStdString((folder.path() / "mine.gpl").string());
    EXPECT_FALSE(find<QPushButton>("save_palette").isEnabled());
    type(QStringLiteral("#c03020"));
    click(find<QPushButton>("keep_paint"));
    EXPECT_TRUE(find<QPushButton>("save_palette").isEnabled());
    parts().paints.save_palette(file);
    EXPECT_EQ(core::read_text_file(file.toStdString()),
              "GIMP Palette\nName: mine\n#\n192 48 32\t#c03020\n");
    parts().paints.open_palette(file);
    auto* grid = window().findChild<QWidget*>(QStringLiteral("palette"));
    EXPECT_EQ(grid->findChildren<QPushButton*>().size(), 1);
}

// ---- mixes

class Mixes : public MixingWindow {
  protected:
    QListWidget& list() { return find<QListWidget>("mixes"); }
    void click_row(int row) {
        const QPoint place = list().visualItemRect(list().item(row)).center();
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, place);
        QApplication::processEvents();
    }
    /// In the list, where it is asked for.
    void type_name(const char* name) {
        auto* editor = list().findChild<QLineEdit*>();
        ASSERT_NE(editor, nullptr);
        editor->selectAll();
        QTest::keyClicks(editor, name);
        QTest::keyClick(editor, Qt::Key_Return);
        QApplication::processEvents();
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    void keep_as(const char* name) {
        click(find<QPushButton>("keep_mix"));
        type_name(name);
    }
    const document::PaintRecipe sky_{{{"PB29", 1.0}, {"PW6", 8.0}}, 0.5};
};

TEST_F(Mixes, AreKeptUnderANameAndTakenInHandAgain) {
    studio().choose_paint(sky_);
    keep_as("my sky");
    studio().choose_paint({{{"PR108", 1.0}}, 1.0});
    ASSERT_EQ(list().count(), 1);
    EXPECT_EQ(list().item(0)->text(), "my sky");
    click_row(0);
    EXPECT_EQ(studio().easel().hand().paint, sky_);
    EXPECT_EQ(dipped(), sky_);
}

TEST_F(Mixes, HoldTubesWhereTheColourWasPicked) {
    type(QStringLiteral("#7a5c3e"));
    keep_as("mud");
    click_row(0);
    ASSERT_GE(paint().size(), 2U);
    for (const document::Ingredient& part : paint())
        EXPECT_EQ(part.pigment.front(), 'P');
}

TEST_F(Mixes, AreThereAtTheNextStart) {
    studio().choose_paint(sky_);
    keep_as("my sky");
    start_again();
    give(Command::ColourPanel);
    ASSERT_EQ(list().count(), 1);
    EXPECT_EQ(list().item(0)->text(), "my sky");
    click_row(0);
    EXPECT_EQ(studio().easel().hand().paint, sky_);
}

TEST_F(Mixes, AreRenamedAndTakenAway) {
    keep_as("a");
    keep_as("b");
    list().setCurrentRow(1);
    list().setFocus();
    QTest::keyClick(&list(), Qt::Key_F2);
    type_name("a");
    wait_for([this] { return list().item(1)->text() == "a 2"; });  // no two have one name
    list().setCurrentRow(0);
    list().setFocus();
    QTest::keyClick(&list(), Qt::Key_Delete);
    ASSERT_EQ(list().count(), 1);
    EXPECT_EQ(list().item(0)->text(), "a 2");
    list().setCurrentRow(0);
    const QWidget& part = *find<QPushButton>("remove_mix").parentWidget();
    const auto says_what_it_is_for = [&part] {
        for (const auto* label : part.findChildren<QLabel*>())
            if (!label->isHidden() && label->text().startsWith(QStringLiteral("Paints that you keep")))
                return true;
        return false;
    };
    EXPECT_FALSE(says_what_it_is_for());
    click(find<QPushButton>("remove_mix"));
    EXPECT_EQ(list().count(), 0);
    EXPECT_TRUE(says_what_it_is_for());
}

TEST_F(Mixes, GoToAnotherPainterAsAFile) {
    const TemporaryFolder folder;
    const QString file = QString::fromStdString((folder.path() / "paints.json").string());
    EXPECT_FALSE(find<QPushButton>("export_paints").isEnabled());
    studio().choose_paint(sky_);
    keep_as("my sky");
    parts().paints.export_paints(file);
    parts().paints.import_paints(file);
    EXPECT_EQ(told(), "You have all paints of that set already.");
    list().setCurrentRow(0);
    click(find<QPushButton>("remove_mix"));
    parts().paints.import_paints(file);
    EXPECT_THAT(told(), HasSubstr("added to your own"));
    ASSERT_EQ(list().count(), 1);
    EXPECT_EQ(list().item(0)->text(), "my sky");
}

// ---- tubes

class Tubes : public MixingWindow {
  protected:
    QListWidget& list() { return find<QListWidget>("paints"); }
    panels::PaintPanel& panel() { return *window().findChild<panels::PaintPanel*>(); }
    QString set_shown() { return find<QToolButton>("tube_sets").text(); }
    /// Dollops in the recording.
    std::vector<std::string> squeezed() {
        session().wait_until_applied();
        std::vector<std::string> tubes;
        for (const document::Event& event : session().recording().events)
            if (const auto* squeeze = std::get_if<document::SqueezePaint>(&event.action))
                tubes.push_back(
                    squeeze->paint.ingredients.empty() ? "" : squeeze->paint.ingredients[0].pigment);
        return tubes;
    }
};

TEST_F(Tubes, StandInThePaintersOrderAtTheNextStartToo) {
    const QStringList shipped = panel().tubes();
    list().setCurrentRow(0);
    list().setFocus();
    QTest::keyClick(&list(), Qt::Key_Down, Qt::AltModifier);
    QStringList moved = shipped;
    moved.swapItemsAt(0, 1);
    EXPECT_EQ(panel().tubes(), moved);
    EXPECT_EQ(list().currentRow(), 1) << "the tube that moved";
    start_again();
    EXPECT_EQ(panel().tubes(), moved);
    list().setCurrentRow(0);
    QTest::keyClick(&list(), Qt::Key_Up, Qt::AltModifier);
    EXPECT_EQ(panel().tubes(), moved) << "there is none above";
}

TEST_F(Tubes, AreChosenBySetsThatAreFoundAtTheNextStart) {
    const QStringList all = panel().tubes();
    parts().tubes.save_set(QStringLiteral("sea"));
    EXPECT_EQ(set_shown(), "sea");
    for (const QString& tube : all.mid(2))
        Q_EMIT panel().taken_out(tube);
    EXPECT_EQ(panel().tubes(), all.mid(0, 2));
    EXPECT_EQ(list().item(0)->toolTip().isEmpty(), false) << "swatches are drawn";
    Q_EMIT panel().sets().chosen_set(QString());
    EXPECT_EQ(set_shown(), "All tubes");
    EXPECT_EQ(panel().tubes(), all);
    Q_EMIT panel().put_into_set(all[4], QStringLiteral("sea"));
    Q_EMIT panel().sets().chosen_set(QStringLiteral("sea"));
    EXPECT_EQ(panel().tubes(), (QStringList{all[0], all[1], all[4]}));
    start_again();
    EXPECT_EQ(set_shown(), "sea");
    EXPECT_EQ(panel().tubes(), (QStringList{all[0], all[1], all[4]}));
    parts().tubes.rename_set(QStringLiteral("storm"));
    EXPECT_EQ(set_shown(), "storm");
    parts().tubes.save_set(QStringLiteral(" "));
    EXPECT_EQ(told(), "A set needs a name.");
    Q_EMIT panel().sets().removal_wanted();
    EXPECT_EQ(set_shown(), "All tubes");
    EXPECT_EQ(panel().tubes(), all);
}

TEST_F(Tubes, SetsGoToAnotherPainterAsAFile) {
    const TemporaryFolder folder;
    const QString file = QString::fromStdString((folder.path() / "tubes.json").string());
    parts().tubes.save_set(QStringLiteral("sea"));
    parts().tubes.export_sets(file);
    parts().tubes.import_sets(file);
    EXPECT_EQ(told(), "You have all sets of that file already.");
    Q_EMIT panel().sets().removal_wanted();
    parts().tubes.import_sets(file);
    EXPECT_THAT(told(), HasSubstr("added to your own"));
    EXPECT_EQ(panel().sets().names(), QStringList(QStringLiteral("sea")));
    EXPECT_EQ(set_shown(), "All tubes");
    start_again();
    EXPECT_EQ(panel().sets().names(), QStringList(QStringLiteral("sea")));
}

TEST_F(Tubes, OfASetAreSqueezedOutTogether) {
    const QStringList all = panel().tubes();
    parts().tubes.save_set(QStringLiteral("sea"));
    for (const QString& tube : all.mid(3))
        Q_EMIT panel().taken_out(tube);
    const document::PaintRecipe in_hand = studio().easel().hand().paint;
    Q_EMIT panel().sets().squeeze_wanted();
    EXPECT_EQ(squeezed(), (std::vector<std::string>{all[0].toStdString(), all[1].toStdString(),
                                                    all[2].toStdString()}));
    EXPECT_EQ(studio().easel().hand().paint, in_hand);
    EXPECT_TRUE(studio().commands().action(Command::MixingWell)->isChecked());
    EXPECT_TRUE(session().take_errors().empty());
    studio().easel().undo();
    session().wait_until_applied();
    EXPECT_FALSE(session().snapshot()->well.has_value()) << "all of them in one step";
}

TEST_F(Tubes, OfTheLastWellAreSqueezedOutAgain) {
    Q_EMIT panel().sets().last_palette_wanted();
    EXPECT_EQ(told(), "No paint was squeezed out beside an earlier painting yet.");
    for (const char* tube : {"PR108", "PB29", "PR108"})
        studio().easel().squeeze_next({{{tube, 1.0}}, 1.0});
    EXPECT_EQ(squeezed().size(), 3U);
    QTimer::singleShot(0, [] {
        auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        ASSERT_NE(question, nullptr);
        for (QAbstractButton* button : question->buttons())
            if (question->buttonRole(button) == QMessageBox::DestructiveRole) return button->click();
    });
    start_again();
    EXPECT_TRUE(squeezed().empty());
    Q_EMIT panel().sets().last_palette_wanted();
    EXPECT_EQ(squeezed(), (std::vector<std::string>{"PR108", "PB29"}));
    EXPECT_TRUE(session().take_errors().empty());
}

TEST_F(Tubes, WhatWasMixedOnTheLastWellIsSqueezedOutAgainToo) {
    studio().easel().squeeze_next({{{"PR108", 1.0}}, 1.0});
    studio().easel().squeeze_puddle({{{{"PB29", 62.0}, {"PW6", 38.0}}, 1.0}, 150.0, 60.0, 45.0}, false);
    const document::CanvasSettings canvas = session().canvas();
    session().wait_until_applied();
    parts().files.new_canvas(canvas);
    loaded();
    Q_EMIT panel().sets().last_palette_wanted();
    EXPECT_EQ(squeezed(), (std::vector<std::string>{"PR108", "PB29"}));
    studio().easel().undo();
    session().wait_until_applied();
    EXPECT_FALSE(session().snapshot()->well.has_value()) << "all of it in one step";
    EXPECT_TRUE(session().take_errors().empty());
}

// ---- the eyedropper

class Eyedropper : public MixingWindow {
  protected:
    void SetUp() override {
        MixingWindow::SetUp();
        if (HasFatalFailure()) return;
        studio().easel().choose_paint({{{"PB29", 62.0}, {"PW6", 38.0}}, 1.0});
        for (int i = 0; i < 2; ++i)
            mouse_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}));
        studio().easel().choose_paint({{{"PR108", 1.0}}, 1.0});
        session().wait_until_applied();
    }
    double parts_of(const char* pigment) {
        for (const document::Ingredient& part : paint())
            if (part.pigment == pigment) return part.parts;
        return 0.0;
    }
    /// Brush and film move whole quanta; half a percent of a mixture is more than they lose.
    void expect_the_mixture() {
        EXPECT_EQ(paint().size(), 2U);
        EXPECT_NEAR(parts_of("PB29"), 62.0, 0.5);
        EXPECT_NEAR(parts_of("PW6"), 38.0, 0.5);
        EXPECT_EQ(dipped(), studio().easel().hand().paint);
        EXPECT_TRUE(session().take_errors().empty());
    }
};

TEST_F(Eyedropper, ACtrlClickDipsTheBrushInTheMixtureThatLiesThere) {
    click_canvas({30.0, 20.0}, Qt::ControlModifier);
    expect_the_mixture();
    EXPECT_EQ(told(), "Picked up wet paint: PB29 62 %, PW6 38 %");
    EXPECT_THAT(recipe(), HasSubstr("PB29 62 %, PW6 38 %"));
}

TEST_F(Eyedropper, DryPaintGivesTheUppermostStratum) {
    give(Command::DryNow);
    session().wait_until_applied();
    click_canvas({40.0, 20.0}, Qt::ControlModifier);
    expect_the_mixture();
    EXPECT_EQ(told(), "Picked up dry paint: PB29 62 %, PW6 38 %");
}

TEST_F(Eyedropper, AnAltClickTakesTheColourSeen) {
    click_canvas({30.0, 20.0}, Qt::AltModifier);
    ASSERT_EQ(paint().size(), 1U);
    const auto seen = pigment::parse_hex_colour(paint()[0].pigment);
    ASSERT_TRUE(seen.has_value());
    EXPECT_GT((*seen)[2], (*seen)[0] + 40);
    EXPECT_THAT(told(), HasSubstr("Picked the colour seen: #"));
}

TEST_F(Eyedropper, TheKeysChooseBetweenPaintAndColourForOneClick) {
    give(Command::PickColour);
    give(Command::PickPaint);
    EXPECT_FALSE(studio().commands().action(Command::PickColour)->isChecked());
    click_canvas({30.0, 20.0}, {});
    expect_the_mixture();
    give(Command::PickColour);
    click_canvas({30.0, 20.0}, {});
    EXPECT_EQ(paint()[0].pigment.front(), '#');
    EXPECT_FALSE(studio().commands().action(Command::PickColour)->isChecked());
}

TEST_F(Eyedropper, OnBareCanvasThereIsOnlyAColour) {
    click_canvas({30.0, 35.0}, Qt::ControlModifier);
    EXPECT_EQ(paint()[0].pigment.front(), '#');
}

TEST_F(Eyedropper, PicksWhatWasMixedInTheWell) {
    give(Command::MixingWell);
    studio().easel().choose_paint({{{"PY35", 70.0}, {"PW6", 30.0}}, 0.5});
    studio().easel().squeeze(60.0, 45.0);
    studio().easel().choose_paint({{{"PR108", 1.0}}, 1.0});
    session().wait_until_applied();
    wait_for([this] { return studio().well().finished(); });
    give(Command::PickPaint);
    const QPoint place = studio().well().widget_position({60.0, 45.0}).toPoint();
    QTest::mouseClick(&studio().well(), Qt::LeftButton, {}, place);
    EXPECT_NEAR(parts_of("PY35"), 70.0, 0.5);
    EXPECT_NEAR(parts_of("PW6"), 30.0, 0.5);
    EXPECT_NEAR(studio().easel().hand().paint.strength, 0.5, 0.011);
    EXPECT_THAT(told(), HasSubstr("thinned to 50 %"));
}

// ---- the wheel

class Wheel : public MixingWindow {
  protected:
    panels::ColourWheel& wheel() { return *window().findChild<panels::ColourWheel*>(); }
    void drag(const QPointF& from, const QPointF& to, bool lets_go = true) {
        QTest::mousePress(&wheel(), Qt::LeftButton, {}, from.toPoint());
        QMouseEvent event(QEvent::MouseMove, to, wheel().mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                          {});
        QApplication::sendEvent(&wheel(), &event);
        if (lets_go) QTest::mouseRelease(&wheel(), Qt::LeftButton, {}, to.toPoint());
    }
};

TEST_F(Wheel, TheRingSetsTheHueAndTheFieldTheRest) {
    type(QStringLiteral("#a06040"));
    drag(wheel().ring_position(120.0), wheel().ring_position(250.0));
    EXPECT_NEAR(find<QDoubleSpinBox>("channel_2").value(), 250.0, 1.0);  // a pixel of the ring
    drag(wheel().field_position(50.0, 0.05), wheel().field_position(60.0, 0.1));
    EXPECT_NEAR(find<QDoubleSpinBox>("channel_0").value(), 60.0, 1.0);
    EXPECT_NEAR(find<QDoubleSpinBox>("channel_1").value(), 0.1, 0.005);
    ASSERT_EQ(paint().size(), 1U);
    EXPECT_EQ(paint()[0].pigment, find<QLineEdit>("hex").text().toStdString());
}

TEST_F(Wheel, ADragPaintsOnceItIsLetGoAndEndsWhereSrgbEnds) {
    type(QStringLiteral("#a06040"));
    drag(wheel().field_position(60.0, 0.05), wheel().field_position(60.0, 0.4), false);
    EXPECT_EQ(paint()[0].pigment, "#a06040");
    const auto oklch = wheel().oklch();
    EXPECT_DOUBLE_EQ(oklch[1], tools::most_chroma(oklch[0], oklch[2]));
    QTest::mouseRelease(&wheel(), Qt::LeftButton, {}, {});
    EXPECT_NE(paint()[0].pigment, "#a06040");
}

TEST_F(Wheel, TheRingGivesChromaBackPastAHueThatHasLess) {
    find<QLineEdit>("hex").setFocus();
    type(QStringLiteral("#e03030"));
    const double chroma = wheel().oklch()[1];
    const double hue_deg = wheel().oklch()[2];
    drag(wheel().ring_position(hue_deg), wheel().ring_position(200.0), false);
    EXPECT_LT(wheel().oklch()[1], chroma - 0.05);
    const QPointF back = wheel().ring_position(hue_deg);
    QMouseEvent event(QEvent::MouseMove, back, wheel().mapToGlobal(back), Qt::NoButton, Qt::LeftButton,
                      {});
    QApplication::sendEvent(&wheel(), &event);
    QTest::mouseRelease(&wheel(), Qt::LeftButton, {}, back.toPoint());
    EXPECT_NEAR(wheel().oklch()[1], chroma, 0.01);
}

TEST_F(Wheel, KeysMoveTheColour) {
    type(QStringLiteral("#806050"));
    const tools::Channels before = wheel().oklch();
    QTest::keyClick(&wheel(), Qt::Key_Up);
    QTest::keyClick(&wheel(), Qt::Key_Right);
    QTest::keyClick(&wheel(), Qt::Key_PageUp);
    QTest::keyClick(&wheel(), Qt::Key_PageUp, Qt::ControlModifier);
    EXPECT_NEAR(wheel().oklch()[0], before[0] + 2.0, 1e-9);
    EXPECT_NEAR(wheel().oklch()[1], before[1] + 0.01, 1e-9);
    EXPECT_NEAR(wheel().oklch()[2], before[2] + 6.0, 1e-9);
    EXPECT_EQ(paint()[0].pigment, find<QLineEdit>("hex").text().toStdString());
    QTest::keyClick(&wheel(), Qt::Key_Left, Qt::ControlModifier);
    EXPECT_NEAR(wheel().oklch()[1], before[1] + 0.008, 1e-9);
}

TEST_F(Wheel, WhatIsSeenUnderThePointerIsWhatIsTaken) {
    find<QToolButton>("model_oklch").click();
    type(QStringLiteral("#3060c0"));
    const QImage picture = wheel().grab().toImage();
    const double ratio = picture.devicePixelRatio();
    const QPoint place = wheel().field_position(70.0, 0.06).toPoint();
    const QColor seen = picture.pixelColor(static_cast<int>((place.x() + 0.5) * ratio),
                                           static_cast<int>((place.y() + 0.5) * ratio));
    QTest::mouseClick(&wheel(), Qt::LeftButton, {}, place);
    const auto taken = pigment::parse_hex_colour(paint()[0].pigment);
    ASSERT_TRUE(taken.has_value());
    // The click is at a pixel's corner, the colour at its middle: half a pixel of the field.
    EXPECT_NEAR((*taken)[0], seen.red(), 3);
    EXPECT_NEAR((*taken)[1], seen.green(), 3);
    EXPECT_NEAR((*taken)[2], seen.blue(), 3);
}

TEST_F(Wheel, AMarkTakesAHueOfTheHarmonyWhichStays) {
    find<QComboBox>("harmony").setCurrentIndex(static_cast<int>(tools::Harmony::Triad));
    Q_EMIT find<QComboBox>("harmony").activated(0);
    type(QStringLiteral("#a06040"));
    drag(wheel().ring_position(100.0), wheel().ring_position(40.0));
    const double hue_deg = wheel().oklch()[2], lightness = wheel().oklch()[0];
    EXPECT_NEAR(hue_deg, 40.0, 1.0);
    const auto click_at = [this](double at_deg) {
        QTest::mouseClick(&wheel(), Qt::LeftButton, {}, wheel().ring_position(at_deg).toPoint());
    };
    click_at(hue_deg + 121.0);
    EXPECT_NEAR(wheel().oklch()[2], hue_deg + 120.0, 1e-9) << "the mark's own hue";
    EXPECT_EQ(wheel().oklch()[0], lightness);
    EXPECT_EQ(paint()[0].pigment.front(), '#') << "it is painted with";
    click_at(hue_deg + 239.0);
    EXPECT_NEAR(wheel().oklch()[2], hue_deg + 240.0, 1e-9);
    click_at(hue_deg + 1.0);
    EXPECT_NEAR(wheel().oklch()[2], hue_deg, 1e-9) << "and back to the first";
    click_at(hue_deg + 60.0);
    click_at(hue_deg + 181.0);
    EXPECT_NEAR(wheel().oklch()[2], hue_deg + 180.0, 1.5) << "the harmony has turned with the ring";
}

TEST_F(Wheel, AGamutMaskHoldsWhatIsChosen) {
    auto& shape = find<QComboBox>("mask_shape");
    shape.setCurrentIndex(static_cast<int>(tools::MaskShape::Triad));
    Q_EMIT shape.activated(shape.currentIndex());
    type(QStringLiteral("#a06040"));
    const double lightness = wheel().oklch()[0];
    const auto click_disc = [this](const glm::dvec2& place) {
        QTest::mouseClick(&wheel(), Qt::LeftButton, {}, wheel().disc_position(place).toPoint());
        return tools::disc_place(wheel().oklch());
    };
    glm::dvec2 place = click_disc({0.3, 0.1});
    EXPECT_NEAR(place.x, 0.3, 0.02);  // a pixel of the disc
    EXPECT_NEAR(place.y, 0.1, 0.02);
    place = click_disc({-0.9, 0.0});
    EXPECT_NEAR(place.x, -0.5, 1e-6) << "the side opposite the first corner";
    EXPECT_NEAR(place.y, 0.0, 0.02);
    EXPECT_EQ(wheel().oklch()[0], lightness);
    find<QSpinBox>("mask_turn").setValue(180);
    place = click_disc({-0.9, 0.0});
    EXPECT_NEAR(place.x, -0.9, 0.02) << "there is a corner now";
}

TEST_F(Wheel, ACornerOfTheMaskIsDraggedAndFoundAgain) {
    auto& shape = find<QComboBox>("mask_shape");
    const auto choose = [&](tools::MaskShape chosen) {
        shape.setCurrentIndex(static_cast<int>(chosen));
        Q_EMIT shape.activated(shape.currentIndex());
    };
    choose(tools::MaskShape::Triad);
    type(QStringLiteral("#a06040"));
    const tools::Channels colour = wheel().oklch();
    const auto before = paint();
    drag(wheel().disc_position({1.0, 0.0}), wheel().disc_position({0.4, 0.2}));
    EXPECT_EQ(wheel().oklch(), colour);
    EXPECT_EQ(paint()[0].pigment, before[0].pigment) << "no colour is taken by it";
    start_again();
    const auto outline =
        tools::mask_outline(window().findChild<panels::ColourPanel*>()->shelf().aids.mask);
    ASSERT_EQ(outline.size(), 3U);
    EXPECT_NEAR(outline[0].x, 0.4, 0.03);  // two pixels of the disc
    EXPECT_NEAR(outline[0].y, 0.2, 0.03);
    auto& again = find<QComboBox>("mask_shape");
    for (const auto chosen : {tools::MaskShape::Complementary, tools::MaskShape::Triad}) {
        again.setCurrentIndex(static_cast<int>(chosen));
        Q_EMIT again.activated(again.currentIndex());
    }
    EXPECT_NEAR(tools::mask_outline(window().findChild<panels::ColourPanel*>()->shelf().aids.mask)[0].x,
                1.0, 1e-9)
        << "another shape has its own corners";
}

TEST_F(Wheel, TheAidsAreThereAtTheNextStart) {
    auto& harmony = find<QComboBox>("harmony");
    harmony.setCurrentIndex(static_cast<int>(tools::Harmony::Tetrad));
    Q_EMIT harmony.activated(harmony.currentIndex());
    start_again();
    EXPECT_EQ(find<QComboBox>("harmony").currentIndex(), static_cast<int>(tools::Harmony::Tetrad));
}

}  // namespace
}  // namespace pastoso::tests
