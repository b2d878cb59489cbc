// Swatches of paint show what a flat spot of it looks like on the canvas.
#include "app/window_fixture.hpp"
#include "appearance/theme.hpp"
#include "document/actions/actions.hpp"
#include "main/window_parts.hpp"
#include "panels/paint/paint_swatch.hpp"
#include "panels/popup/round_button.hpp"

#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>

namespace pastoso::tests {
namespace {

using commands::Command;

class SwatchesWindow : public WindowTest {
  protected:
    /// What a flat spot of the paint in hand is on this canvas.
    QColor spot() {
        const tools::Hand& hand = studio().easel().hand();
        tools::SwatchView view;
        view.medium = document::medium_of(hand.medium);
        view.spot = {tools::film_in_hand_mm(hand), session().snapshot()->ground, canvas().lighting(),
                     canvas().viewing()};
        const pigment::Srgb8 rgb = tools::swatch_colour(hand.paint, view);
        return {rgb[0], rgb[1], rgb[2]};
    }
    QColor in_hand() {
        return window().findChild<panels::PaintSwatch*>(QStringLiteral("first_paint"))->colour();
    }
    /// The first swatch of a grid.
    QColor first_of(const char* grid) {
        return window()
            .findChild<QWidget*>(QString::fromLatin1(grid))
            ->findChild<panels::PaintSwatch*>()
            ->colour();
    }
    /// Of the icon of the tube in hand.
    QColor pixel_of_tube(int x, int y) {
        const auto* tubes = window().findChild<QListWidget*>(QStringLiteral("paints"));
        return tubes->currentItem()->icon().pixmap(tubes->iconSize()).toImage().pixelColor(x, y);
    }
    QColor tube_in_hand() { return pixel_of_tube(8, 9); }
    void expect_all_as_painted() {
        EXPECT_EQ(in_hand(), spot());
        EXPECT_EQ(tube_in_hand(), spot());
        EXPECT_EQ(first_of("recent_paints"), spot());
    }
    void take(const char* tool) {
        const brush::Preset& preset = brush::find_preset(tool);
        studio().easel().take_brush(preset.name, preset.tip.width_mm);
        studio().show_hand();
    }
};

TEST_F(SwatchesWindow, FollowToolFillMediumAndLight) {
    studio().choose_paint({{{"PB29", 1.0}}, 1.0});
    expect_all_as_painted();
    const QColor thick = in_hand();
    take("mop");
    expect_all_as_painted();
    const QColor thin = in_hand();
    EXPECT_GT(thin.lightness(), thick.lightness());
    auto* fill = window().findChild<QDoubleSpinBox*>(QStringLiteral("dip_fill"));
    fill->setValue(20.0);
    expect_all_as_painted();
    EXPECT_GT(in_hand().lightness(), thin.lightness());
    const QColor daylight = in_hand();
    action(Command::LightA)->trigger();
    expect_all_as_painted();
    EXPECT_NE(in_hand(), daylight);
}

TEST_F(SwatchesWindow, ThePopUpPaletteShowsTheSame) {
    studio().choose_paint({{{"PG36", 1.0}}, 1.0});
    take("mop");
    action(Command::PopupPalette)->trigger();
    auto* paint = window().findChild<panels::RoundButton*>(QStringLiteral("popup_first_paint"));
    ASSERT_NE(paint, nullptr);
    EXPECT_EQ(paint->colour(), spot());
}

TEST_F(SwatchesWindow, SayHowWellPaintHides) {
    const auto tube_words = [this](const char* name) {
        const auto* tubes = window().findChild<QListWidget*>(QStringLiteral("paints"));
        return tubes->findItems(QLatin1String(name), Qt::MatchExactly).front()->toolTip();
    };
    EXPECT_TRUE(tube_words("Ultramarine blue").contains(QStringLiteral("(PB29), transparent")));
    EXPECT_TRUE(tube_words("Alizarin crimson").contains(QStringLiteral(", semi-transparent")));
    EXPECT_TRUE(tube_words("Cadmium red light").contains(QStringLiteral("(PR108), opaque")));
    studio().choose_paint({{{"PR108", 1.0}}, 1.0});
    const auto* first = window().findChild<panels::PaintSwatch*>(QStringLiteral("first_paint"));
    const auto* recipe = window().findChild<QLabel*>(QStringLiteral("recipe"));
    EXPECT_EQ(first->toolTip(), "In hand: Cadmium red light, opaque");
    EXPECT_TRUE(recipe->text().endsWith(QStringLiteral("; opaque"))) << recipe->text().toStdString();
    take("Dry scumbler 22");
    EXPECT_EQ(first->toolTip(), "In hand: Cadmium red light, semi-transparent");
    EXPECT_TRUE(recipe->text().endsWith(QStringLiteral("; semi-transparent")));
    EXPECT_TRUE(tube_words("Cadmium red light").contains(QStringLiteral("(PR108), semi-transparent")));
}

TEST_F(SwatchesWindow, MarkTubesInTheInkOfTheTheme) {
    const appearance::Theme before = appearance::theme().value_or(appearance::Theme::Dark);
    studio().choose_paint({{{"PR108", 1.0}}, 1.0});
    for (const auto theme : {appearance::Theme::Light, appearance::Theme::Dark}) {
        appearance::apply_theme(*qApp, theme);
        EXPECT_EQ(pixel_of_tube(40, 9), appearance::colours().text);
    }
    appearance::apply_theme(*qApp, before);
}

}  // namespace
}  // namespace pastoso::tests
