// What the window finds again at the next start: paints, the pen's settings, and how the panels stand.
#include "app/window_fixture.hpp"
#include "core/text_file.hpp"
#include "main/window_parts.hpp"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QStatusBar>
#include <QTest>
#include <QTimer>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using testing::HasSubstr;

class MemoryWindow : public WindowTest {
  protected:
    void give(Command command) { studio().commands().action(command)->trigger(); }
    template <class Widget>
    Widget& find(const char* name) {
        auto* found = window().findChild<Widget*>(QString::fromLatin1(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    void type(const QString& colour) {
        find<QLineEdit>("hex").setText(colour);
        QTest::keyClick(&find<QLineEdit>("hex"), Qt::Key_Return);
    }
    std::vector<QPushButton*> patches(const char* grid) {
        std::vector<QPushButton*> seen;
        for (QPushButton* patch : find<QWidget>(grid).findChildren<QPushButton*>())
            if (!patch->isHidden()) seen.push_back(patch);
        return seen;
    }
    QDockWidget& dock(const char* name) { return find<QDockWidget>(name); }
};

TEST_F(MemoryWindow, PaintsUsedAndKeptAreThereAgain) {
    give(Command::ColourPanel);
    type(QStringLiteral("#113355"));
    QTest::mouseClick(&find<QPushButton>("keep_paint"), Qt::LeftButton);
    type(QStringLiteral("#dd9900"));
    start_again();
    const auto kept = patches("kept_paints");
    ASSERT_EQ(kept.size(), 1U);
    const auto recent = patches("recent_paints");
    ASSERT_GE(recent.size(), 3U);
    EXPECT_THAT(recent[1]->toolTip().toStdString(), HasSubstr("#dd9900"));
    give(Command::ColourPanel);
    QTest::mouseClick(kept[0], Qt::LeftButton);
    EXPECT_EQ(studio().easel().hand().paint.ingredients[0].pigment, "#113355");
    QTest::mouseClick(kept[0], Qt::RightButton);
    EXPECT_TRUE(patches("kept_paints").empty());
    start_again();
    EXPECT_TRUE(patches("kept_paints").empty());
}

TEST_F(MemoryWindow, AnOpenedPaletteIsThereAgain) {
    const std::filesystem::path file = data_file("earths.gpl");
    std::filesystem::create_directories(file.parent_path());
    core::write_text_file(file, "GIMP Palette\nName: Earths\n120 60 20 Umber\n");
    parts().paints.open_palette(QString::fromStdString(file.string()));
    std::filesystem::remove(file);
    start_again();
    EXPECT_EQ(patches("palette").size(), 1U);
}

TEST_F(MemoryWindow, ThePaintsAreWrittenSoonAndNotOnlyAtTheEnd) {
    type(QStringLiteral("#113355"));
    wait_for([this] {
        return std::filesystem::exists(data_file("paints.json")) &&
               core::read_text_file(data_file("paints.json")).find("#113355") != std::string::npos;
    });
}

TEST_F(MemoryWindow, DamagedFilesAreToldAndLeftAlone) {
    const std::string no_json = "{\"version\": 1,\n\"recent\": [",
                      no_pen = "{\"version\": 1, \"pen\": 3}";
    window().close();
    core::write_text_file(data_file("paints.json"), no_json);
    open_another();
    EXPECT_THAT(told(), HasSubstr("paints.json, line 2: this is not valid JSON"));
    window().close();
    EXPECT_EQ(core::read_text_file(data_file("paints.json")), no_json);
    std::filesystem::remove(data_file("paints.json"));
    core::write_text_file(settings_file(), no_pen);
    open_another();
    EXPECT_THAT(told(), HasSubstr("settings.json: the entry \"window\" is missing."));
    type(QStringLiteral("#113355"));
    EXPECT_EQ(studio().easel().hand().paint.ingredients[0].pigment, "#113355");
    window().close();
    EXPECT_EQ(core::read_text_file(settings_file()), no_pen);
    EXPECT_TRUE(std::filesystem::exists(data_file("paints.json")));
}

TEST_F(MemoryWindow, ThePensSettingsAreThereAgain) {
    auto& mode = find<QComboBox>("steady_mode");
    mode.setCurrentIndex(2);
    Q_EMIT mode.activated(2);
    find<QSlider>("steady_strength").setValue(14);
    give(Command::ReloadEachStroke);
    start_again();
    EXPECT_EQ(studio().easel().hand().stabiliser, (brush::Stabiliser{0.0, 7.0}));
    EXPECT_FALSE(studio().easel().hand().reload_each_stroke);
    EXPECT_TRUE(studio().easel().hand().turn_with_stroke);
    EXPECT_FALSE(studio().commands().action(Command::ReloadEachStroke)->isChecked());
    EXPECT_EQ(find<QComboBox>("steady_mode").currentIndex(), 2);
    session().wait_until_applied();
    bool posted = false;
    for (const document::Event& event : session().recording().events)
        if (const auto* set = std::get_if<document::SetStabiliser>(&event.action))
            posted = set->stabiliser == brush::Stabiliser{0.0, 7.0};
    EXPECT_TRUE(posted);
}

TEST_F(MemoryWindow, ThePanelsStandAsTheyWereLeftUntilTheyAreReset) {
    ASSERT_TRUE(dock("well_panel").isHidden());
    give(Command::MixingWell);
    window().addDockWidget(Qt::LeftDockWidgetArea, &dock("well_panel"));
    dock("physics_panel").close();
    give(Command::ColourPanel);
    start_again();
    EXPECT_TRUE(dock("well_panel").isVisible());
    EXPECT_TRUE(studio().commands().action(Command::MixingWell)->isChecked());
    EXPECT_EQ(window().dockWidgetArea(&dock("well_panel")), Qt::LeftDockWidgetArea);
    EXPECT_TRUE(dock("physics_panel").isHidden());
    EXPECT_FALSE(dock("colour_panel").visibleRegion().isEmpty());
    give(Command::ResetPanels);
    QApplication::processEvents();
    EXPECT_TRUE(dock("well_panel").isHidden());
    EXPECT_FALSE(studio().commands().action(Command::MixingWell)->isChecked());
    EXPECT_FALSE(dock("physics_panel").isHidden());
    EXPECT_EQ(window().dockWidgetArea(&dock("physics_panel")), Qt::RightDockWidgetArea);
    EXPECT_FALSE(dock("tool_panel").visibleRegion().isEmpty());
}

TEST_F(MemoryWindow, AFloatingWellComesBackWhereItFloated) {
    give(Command::MixingWell);
    dock("well_panel").setFloating(true);
    dock("well_panel").setGeometry(300, 200, 380, 420);
    wait_until_shown(dock("well_panel"));
    const QSize size = dock("well_panel").size();
    start_again();
    EXPECT_TRUE(dock("well_panel").isFloating());
    EXPECT_EQ(dock("well_panel").size(), size);
}

}  // namespace
}  // namespace pastoso::tests
