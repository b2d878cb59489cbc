// A picked colour becomes paint, and the recipe from the tubes may take its place.
#include "app/window_fixture.hpp"

#include <QColorDialog>
#include <QLabel>
#include <QPushButton>
#include <QTest>

namespace pastoso::tests {
namespace {

class MixingWindow : public WindowTest {
  protected:
    QPushButton& button(const char* name) {
        auto* found = window().findChild<QPushButton*>(QString::fromLatin1(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    QString recipe() { return window().findChild<QLabel*>(QStringLiteral("recipe"))->text(); }
    const std::vector<document::Ingredient>& paint() {
        return window().easel().hand().paint.ingredients;
    }

    /// Clicks on the button, then chooses in the dialog.
    void pick(const QColor& colour) {
        QTest::mouseClick(&button("mix_colour"), Qt::LeftButton);
        auto* dialog = window().findChild<QColorDialog*>();
        ASSERT_NE(dialog, nullptr);
        ASSERT_TRUE(dialog->isVisible());
        dialog->setCurrentColor(colour);
        dialog->accept();
    }
};

TEST_F(MixingWindow, NoRecipeIsShownBeforeAColourIsPicked) {
    EXPECT_FALSE(button("use_recipe").isVisible());
}

TEST_F(MixingWindow, APickedColourIsWhatTheBrushPaints) {
    window().commands().action(commands::Command::Pause)->trigger();
    pick(QColor(0xe0, 0x50, 0x20));
    ASSERT_EQ(paint().size(), 1U);
    EXPECT_EQ(paint()[0].pigment, "#e05020");
    EXPECT_TRUE(button("use_recipe").isVisible());
    EXPECT_TRUE(recipe().contains(QStringLiteral("#e05020")));
    EXPECT_TRUE(recipe().contains(QStringLiteral("ΔE")));
    for (int i = 0; i < 3; ++i)
        mouse_stroke(line_mm({15.0, 20.0}, {45.0, 20.0}));
    const QImage after = picture();
    const double ratio = canvas().devicePixelRatioF();
    const QColor painted = after.pixelColor((ratio * canvas().widget_position({30.0, 20.0})).toPoint());
    EXPECT_GT(painted.red(), painted.green() + 60);
    EXPECT_GT(painted.red(), painted.blue() + 60);
    EXPECT_TRUE(session().take_errors().empty());
}

TEST_F(MixingWindow, TheRecipeTakesTheColoursPlace) {
    pick(QColor(0x7a, 0x5c, 0x3e));
    QTest::mouseClick(&button("use_recipe"), Qt::LeftButton);
    ASSERT_GE(paint().size(), 2U);
    for (const document::Ingredient& ingredient : paint())
        EXPECT_EQ(ingredient.pigment.front(), 'P');
    EXPECT_FALSE(button("use_recipe").isEnabled());
    session().wait_until_applied();
    EXPECT_TRUE(session().take_errors().empty());
    pick(QColor(0x7a, 0x5c, 0x3e));
    EXPECT_TRUE(button("use_recipe").isEnabled());
}

}  // namespace
}  // namespace pastoso::tests
