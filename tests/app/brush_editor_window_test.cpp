// The brush editor: every number of the tool in hand, its stroke, what is saved beside it.
#include "app/window_fixture.hpp"
#include "brush/preset_fields.hpp"
#include "document/actions/actions.hpp"
#include "panels/pen/brush_editor.hpp"
#include "panels/pen/brush_list.hpp"
#include "panels/pen/curves_panel.hpp"
#include "panels/pen/preset_page.hpp"
#include "panels/pen/preset_rows.hpp"
#include "panels/pen/stroke_strip.hpp"

#include <algorithm>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;

class BrushEditorWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        action(Command::Pause)->trigger();
        action(Command::BrushEditor)->trigger();
        wait_until_shown(editor());
    }

    panels::BrushEditor& editor() { return *window().findChild<panels::BrushEditor*>(); }
    const tools::Hand& hand() { return studio().easel().hand(); }
    QDoubleSpinBox& number(const char* name) {
        return *editor().findChild<QDoubleSpinBox*>(QLatin1String(name));
    }
    panels::StrokeStrip& strip(const char* name) {
        return *editor().findChild<panels::StrokeStrip*>(QLatin1String(name));
    }
    QPushButton& revert() { return *editor().findChild<QPushButton*>(QStringLiteral("revert_brush")); }
    QImage painted(const char* name) {
        QImage before;
        wait_for([&] {
            const QImage now = strip(name).picture();
            const bool rests = !now.isNull() && now == before;
            before = now;
            QTest::qWait(400);
            return rests;
        });
        return before;
    }
    void take(const char* name) {
        const auto& preset = brush::find_preset(name);
        studio().easel().take_brush(preset, preset.tip.width_mm);
        studio().show_hand();
    }
    void stroke() { mouse_stroke(line_mm({15.0, 20.0}, {45.0, 20.0})); }
    document::TakeBrush last_taken() {
        session().wait_until_applied();
        document::TakeBrush taken;
        for (const document::Event& event : session().recording().events)
            if (const auto* take = std::get_if<document::TakeBrush>(&event.action)) taken = *take;
        return taken;
    }
};

TEST_F(BrushEditorWindow, ShowsEveryNumberOfEveryKindOfTool) {
    for (const char* name : {"Flat bristle 20", "Palette knife 17", "Spray can 35", "Straw 8"}) {
        take(name);
        const brush::Preset tool = tools::sized_preset_in_hand(hand());
        for (const panels::PresetPage& page : panels::preset_pages())
            for (const panels::PresetRow& row : page.rows) {
                const brush::PresetField& field = panels::field_of(page, row);
                const std::string key = std::string(page.section) + "_" + row.key;
                EXPECT_EQ(number(key.c_str()).isHidden(), !brush::applies_to(field, tool.kind)) << key;
                if (!brush::applies_to(field, tool.kind)) continue;
                EXPECT_NEAR(number(key.c_str()).value(), row.scale * field.get(tool),
                            0.5 * std::pow(10.0, -row.decimals) + 1e-9)
                    << name << ' ' << key;
            }
    }
}

TEST_F(BrushEditorWindow, ANumberIsPaintedWithFromTheNextStrokeOnAndRecorded) {
    const auto before = last_taken();
    number("paint_film").setValue(0.4);
    EXPECT_EQ(last_taken(), before) << "not before the next stroke";
    stroke();
    const brush::Preset painted = brush::parse_preset(last_taken().definition, "recorded");
    EXPECT_EQ(painted.paint.film_mm, 0.4);
    EXPECT_EQ(painted.name, "Flat bristle 20");
    const document::Recording recording = session().recording();
    take("Filbert 14");
    window().replay(recording);
    EXPECT_EQ(tools::preset_in_hand(hand()).paint.film_mm, 0.4);
    EXPECT_EQ(number("paint_film").value(), 0.4);
    EXPECT_TRUE(session().take_errors().empty());
}

TEST_F(BrushEditorWindow, AChoiceIsPaintedWithAsWell) {
    auto& shape = *editor().findChild<QComboBox*>(QStringLiteral("tip_shape"));
    EXPECT_EQ(shape.currentText(), QStringLiteral("flat"));
    shape.setCurrentIndex(shape.findText(QStringLiteral("comb")));
    Q_EMIT shape.activated(shape.currentIndex());
    auto& dips = *editor().findChild<QComboBox*>(QStringLiteral("paint_dips"));
    dips.setCurrentIndex(0);
    Q_EMIT dips.activated(0);
    stroke();
    const brush::Preset painted = brush::parse_preset(last_taken().definition, "recorded");
    EXPECT_EQ(painted.tip.shape, brush::TipShape::Comb);
    EXPECT_FALSE(painted.dips);
    EXPECT_FALSE(action(Command::ReloadBrush)->isEnabled());
    EXPECT_TRUE(session().take_errors().empty());
    take("Spray can 35");
    EXPECT_TRUE(shape.isHidden());
    EXPECT_FALSE(editor().findChild<QComboBox*>(QStringLiteral("stroke_jitter_seed"))->isHidden());
}

TEST_F(BrushEditorWindow, TheWidthIsTheOneThatTheToolIsHeldWith) {
    number("tip_width").setValue(31.0);
    EXPECT_EQ(hand().brush_width_mm, 31.0);
    const brush::Preset wide = brush::resized(brush::find_preset("flat"), 31.0);
    EXPECT_EQ(tools::sized_preset_in_hand(hand()), wide) << "all of the tip goes with it";
    EXPECT_NEAR(number("tip_thickness").value(), wide.tip.thickness_mm, 0.051);
    EXPECT_FALSE(hand().own_preset.has_value()) << "it is the same tool";
    action(Command::SmallerBrush)->trigger();
    EXPECT_LT(hand().brush_width_mm, 31.0);
    EXPECT_NEAR(number("tip_width").value(), hand().brush_width_mm, 0.05);
}

TEST_F(BrushEditorWindow, RevertMakesTheToolAgainWhatIsSaved) {
    EXPECT_FALSE(revert().isEnabled());
    number("tip_width").setValue(31.0);
    number("flex_bend").setValue(90.0);
    ASSERT_TRUE(revert().isEnabled());
    QTest::mouseClick(&revert(), Qt::LeftButton);
    EXPECT_FALSE(hand().own_preset.has_value());
    EXPECT_EQ(hand().brush_width_mm, 20.0);
    EXPECT_NEAR(number("flex_bend").value(), 100.0 * brush::find_preset("flat").flex.bend, 0.5);
    EXPECT_FALSE(revert().isEnabled());
}

TEST_F(BrushEditorWindow, OneNumberIsResetForItself) {
    auto& film = *editor().findChild<QToolButton*>(QStringLiteral("paint_film_reset"));
    auto& thickness = *editor().findChild<QToolButton*>(QStringLiteral("tip_thickness_reset"));
    EXPECT_FALSE(film.isEnabled());
    number("paint_film").setValue(0.4);
    number("flex_bend").setValue(90.0);
    ASSERT_TRUE(film.isEnabled());
    film.click();
    EXPECT_EQ(number("paint_film").value(), brush::find_preset("flat").paint.film_mm);
    EXPECT_NEAR(number("flex_bend").value(), 90.0, 1e-9) << "the others stay as they are";
    EXPECT_FALSE(film.isEnabled());
    action(Command::SmallerBrush)->trigger();
    EXPECT_FALSE(thickness.isEnabled()) << "it goes with the width";
}

TEST_F(BrushEditorWindow, AWidthThatIsTypedLightsNoOtherArrow) {
    const auto lit = [this] {
        std::vector<std::string> names;
        for (const auto* page : editor().findChildren<panels::PresetPageView*>())
            for (const auto* reset : page->findChildren<QToolButton*>())
                if (reset->isEnabled()) names.push_back(reset->objectName().toStdString());
        return names;
    };
    EXPECT_THAT(lit(), testing::IsEmpty());
    number("tip_width").setValue(31.0);
    EXPECT_THAT(lit(), testing::ElementsAre("tip_width_reset"));
    auto& as_saved = *editor().findChild<QToolButton*>(QStringLiteral("tip_width_reset"));
    as_saved.click();
    EXPECT_THAT(lit(), testing::IsEmpty());
    number("paint_film").setValue(0.4);
    number("tip_width").setValue(15.0);
    EXPECT_THAT(lit(), testing::UnorderedElementsAre("tip_width_reset", "paint_film_reset"));
    as_saved.click();
    EXPECT_EQ(hand().brush_width_mm, 20.0);
    EXPECT_EQ(number("tip_width").value(), 20.0);
    EXPECT_THAT(lit(), testing::ElementsAre("paint_film_reset"));
    stroke();
    EXPECT_EQ(last_taken().size_mm, 20.0);
}

TEST_F(BrushEditorWindow, CurvesStandInOnePlaceAtATime) {
    const auto all = window().findChildren<panels::CurvesPanel*>();
    ASSERT_EQ(all.size(), 2);
    const auto hidden = [&] {
        return std::count_if(all.begin(), all.end(), [&](const panels::CurvesPanel* curves) {
            return !editor().isAncestorOf(curves) && curves->isHidden();
        });
    };
    EXPECT_EQ(hidden(), 1);
    QTest::keyClick(&editor(), Qt::Key_F5);
    EXPECT_EQ(hidden(), 0);
}

TEST_F(BrushEditorWindow, TheWidestToolCanBeEdited) {
    take("Rigger 2");
    studio().easel().set_brush_width(200.0);
    studio().show_hand();
    EXPECT_NEAR(number("tip_width").value(), 200.0, 1e-9);
    number("paint_film").setValue(0.2);
    stroke();
    const brush::Preset painted = brush::parse_preset(last_taken().definition, "recorded");
    EXPECT_EQ(painted.paint.film_mm, 0.2);
    EXPECT_EQ(last_taken().size_mm, 200.0);
    EXPECT_TRUE(session().take_errors().empty());
}

TEST_F(BrushEditorWindow, TheStripIsPaintedAnewAndTheSavedOneStaysBesideIt) {
    editor().findChild<QToolButton*>(QStringLiteral("compare_brush"))->setChecked(true);
    const QImage before = painted("stroke_in_hand"), saved = painted("stroke_saved");
    EXPECT_EQ(before, saved);
    number("paint_film").setValue(1.5);
    const QImage after = painted("stroke_in_hand");
    EXPECT_NE(after, before);
    EXPECT_EQ(painted("stroke_saved"), saved);
    QTest::mouseClick(&revert(), Qt::LeftButton);
    EXPECT_EQ(painted("stroke_in_hand"), before);
}

TEST_F(BrushEditorWindow, BothStripsHaveTheScaleOfTheWiderTool) {
    editor().findChild<QToolButton*>(QStringLiteral("compare_brush"))->setChecked(true);
    const QImage saved = painted("stroke_saved");
    number("tip_width").setValue(10.0);
    EXPECT_EQ(painted("stroke_saved"), saved) << "the narrower one is seen as such";
    number("tip_width").setValue(40.0);
    EXPECT_NE(painted("stroke_saved"), saved);
}

TEST_F(BrushEditorWindow, HidesPagesWithoutNumbersAndComesAndGoesWithItsKey) {
    auto& pages = *editor().findChild<QListWidget*>(QStringLiteral("brush_pages"));
    EXPECT_TRUE(pages.findItems(QStringLiteral("Drops"), Qt::MatchExactly).front()->isHidden());
    pages.setCurrentItem(pages.findItems(QStringLiteral("Hairs"), Qt::MatchExactly).front());
    take("Spray can 35");
    EXPECT_FALSE(pages.findItems(QStringLiteral("Drops"), Qt::MatchExactly).front()->isHidden());
    EXPECT_TRUE(pages.findItems(QStringLiteral("Hairs"), Qt::MatchExactly).front()->isHidden());
    EXPECT_EQ(pages.currentItem()->text(), QStringLiteral("Tip"));
    take("Filbert 14");
    EXPECT_EQ(pages.currentItem()->text(), QStringLiteral("Hairs")) << "where it was left";
    QTest::keyClick(&editor(), Qt::Key_F5);
    EXPECT_FALSE(editor().isVisible());
    action(Command::BrushEditor)->trigger();
    EXPECT_TRUE(editor().isVisible());
}

}  // namespace
}  // namespace pastoso::tests
