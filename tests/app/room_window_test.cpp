// The window on a small screen, in every language: nothing is cut, nothing lies on something else.
#include "app/window_fixture.hpp"
#include "appearance/shown_time.hpp"
#include "appearance/theme.hpp"
#include "main/panel_set.hpp"
#include "main/program/language.hpp"
#include "main/window_parts.hpp"
#include "panels/paint/paint_panel.hpp"
#include "panels/parts/fold.hpp"
#include "panels/parts/gallery.hpp"
#include "panels/parts/tool_bar.hpp"
#include "panels/pen/brush_list.hpp"
#include "panels/pen/pen_dialog.hpp"
#include "start/start_page.hpp"

#include <set>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QImage>
#include <QLabel>
#include <QLayout>
#include <QMenuBar>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QStatusBar>
#include <QTabBar>
#include <QToolBar>
#include <QToolButton>

namespace pastoso::tests {
namespace {

using commands::Command;

/// 1280 x 800 pixels at 125 percent; a bar of the desktop and the window's title take some of the height.
constexpr QSize kSmallScreen(1024, 640);
constexpr int kBars = 60;

class RoomWindow : public WindowTest {
  protected:
    void TearDown() override {
        main::speak(QStringLiteral("en"));
        WindowTest::TearDown();
    }

    void open_small(const char* language) {
        main::speak(QString::fromLatin1(language));
        open_another();
        action(Command::Pause)->trigger();
        window().resize(kSmallScreen);
        wait_for([this] { return window().size() == kSmallScreen; });
        QApplication::processEvents();
    }

    static std::string words_for(const QWidget& widget) {
        return std::string(widget.metaObject()->className()) + " " + widget.objectName().toStdString();
    }

    /// What is laid out in it lies within it and beside one another.
    static void expect_nothing_cut(const QWidget& content) {
        QList<QWidget*> parents = content.findChildren<QWidget*>();
        parents.push_back(const_cast<QWidget*>(&content));
        for (const QWidget* parent : parents) {
            if (parent->layout() == nullptr || !parent->isVisible()) continue;
            QList<const QWidget*> seen;
            for (const QWidget* one :
                 parent->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
                if (!one->isVisible() || one->isWindow() || one->size().isEmpty()) continue;
                EXPECT_TRUE(parent->rect().contains(one->geometry()))
                    << words_for(*one) << " in " << words_for(*parent);
                for (const QWidget* other : seen)
                    EXPECT_FALSE(other->geometry().intersects(one->geometry()))
                        << words_for(*one) << " on " << words_for(*other);
                seen.push_back(one);
            }
        }
    }
};

constexpr const char* kLanguages[] = {"en", "ja", "sv", "zh_TW"};

/// Counts what asks its widget for a layout.
class LayoutRequests : public QObject {
  public:
    using QObject::QObject;
    int count = 0;

  protected:
    bool eventFilter(QObject* object, QEvent* event) override {
        if (event->type() == QEvent::LayoutRequest) ++count;
        return QObject::eventFilter(object, event);
    }
};

TEST_F(RoomWindow, AtRestTheToolBarAsksForNoLayout) {
    auto* bar = window().findChild<panels::ToolBar*>();
    ASSERT_NE(bar, nullptr);
    for (const int width : {1280, 1100, 900}) {
        window().resize(width, 800);
        constexpr int kRounds = 20;
        for (int round = 0; round < kRounds; ++round)
            QApplication::processEvents();
        LayoutRequests requests;
        bar->installEventFilter(&requests);
        for (int round = 0; round < kRounds; ++round)
            QApplication::processEvents();
        EXPECT_EQ(requests.count, 0) << width << " wide";
    }
}

TEST_F(RoomWindow, OpensOnMostOfALargeScreen) {
    EXPECT_EQ(main::first_window_size({1024, 600}), QSize(1024, 600));
    EXPECT_EQ(main::first_window_size({1440, 900}), QSize(1280, 800));
    EXPECT_EQ(main::first_window_size({1600, 1000}), QSize(1360, 850));
    EXPECT_EQ(main::first_window_size({3840, 1080}), QSize(1920, 918));
    EXPECT_EQ(main::first_window_size({3840, 2160}), QSize(1920, 1200));
}

TEST_F(RoomWindow, FitsASmallScreenInEveryLanguage) {
    for (const char* language : kLanguages) {
        SCOPED_TRACE(language);
        open_small(language);
        EXPECT_LE(window().minimumSizeHint().width(), kSmallScreen.width());
        EXPECT_LE(window().minimumSizeHint().height(), kSmallScreen.height() - kBars);
        EXPECT_TRUE(window().rect().contains(window().statusBar()->geometry()));
        const auto* layers = window().findChild<QWidget*>(QStringLiteral("layer_list"))->parentWidget();
        EXPECT_FALSE(layers->visibleRegion().isEmpty());
        EXPECT_EQ(layers->visibleRegion().boundingRect(), layers->rect()) << "its buttons are seen";
        const auto* paints = window().findChild<QListWidget*>(QStringLiteral("paints"));
        ASSERT_NE(paints->currentItem(), nullptr);
        EXPECT_TRUE(paints->viewport()->rect().contains(paints->visualItemRect(paints->currentItem())))
            << "the paint in hand is in view";
        for (const QScrollArea* area : window().findChildren<QScrollArea*>()) {
            const bool is_seen = area->isVisible() && !area->visibleRegion().isEmpty();
            if (!is_seen) continue;
            EXPECT_LE(area->widget()->width(), area->viewport()->width());
            expect_nothing_cut(*area->widget());
        }
    }
}

TEST_F(RoomWindow, WhatIsUnfoldedFitsItsPanel) {
    for (const char* language : kLanguages) {
        SCOPED_TRACE(language);
        open_small(language);
        action(Command::ColourPanel)->trigger();
        const auto folds = window().findChildren<panels::Fold*>();
        ASSERT_FALSE(folds.isEmpty());
        for (panels::Fold* fold : folds)
            fold->open(true);
        QApplication::processEvents();
        for (const QScrollArea* area : window().findChildren<QScrollArea*>())
            if (area->isVisible() && !area->visibleRegion().isEmpty()) {
                EXPECT_LE(area->widget()->width(), area->viewport()->width());
            }
    }
}

/// 1920 x 1080 pixels at 200 percent, below the window's title.
TEST_F(RoomWindow, ALowScreenShowsTheStatusBarAndTheLayersButtons) {
    const QSize low(960, 510);
    for (const char* language : kLanguages) {
        SCOPED_TRACE(language);
        open_small(language);
        window().resize(low);
        wait_for([&] { return window().size() == low; });
        QApplication::processEvents();
        EXPECT_EQ(window().size(), low);
        EXPECT_TRUE(window().rect().contains(window().statusBar()->geometry()));
        const auto* layers = window().findChild<QWidget*>(QStringLiteral("layer_list"))->parentWidget();
        EXPECT_EQ(layers->visibleRegion().boundingRect(), layers->rect());
        expect_nothing_cut(*layers);
    }
}

TEST_F(RoomWindow, EveryButtonOfTheToolBarIsThereAndSaysMoreWhereThereIsRoom) {
    for (const char* language : kLanguages) {
        SCOPED_TRACE(language);
        open_small(language);
        const auto* bar = window().findChild<QToolBar*>(QStringLiteral("tool_bar"));
        const QAction* toggle = action(Command::TurnWithStroke);
        const QToolButton* shown = nullptr;
        for (const auto* button : bar->findChildren<QToolButton*>()) {
            if (button->defaultAction() == nullptr) continue;
            EXPECT_TRUE(button->isVisible()) << button->text().toStdString();
            if (button->defaultAction() == toggle) shown = button;
        }
        ASSERT_NE(shown, nullptr);
        window().resize(1600, 800);
        wait_for([this] { return window().width() == 1600; });
        QApplication::processEvents();
        EXPECT_EQ(shown->toolButtonStyle(), Qt::ToolButtonTextBesideIcon);
    }
}

TEST_F(RoomWindow, UprightTheToolBarIsNarrowAndLosesNoButton) {
    constexpr int kNarrow = 100;
    for (const char* language : kLanguages) {
        SCOPED_TRACE(language);
        open_small(language);
        auto* bar = window().findChild<QToolBar*>(QStringLiteral("tool_bar"));
        const int lying = bar->height();
        for (const Qt::ToolBarArea area : {Qt::LeftToolBarArea, Qt::RightToolBarArea}) {
            window().addToolBar(area, bar);
            wait_for([&] { return bar->height() > bar->width(); });
            QApplication::processEvents();
            EXPECT_EQ(window().size(), kSmallScreen);
            EXPECT_LE(bar->width(), kNarrow);
            EXPECT_GT(bar->width(), 0);
            EXPECT_TRUE(window().rect().contains(bar->geometry()));
            bool all_seen = true;
            for (const auto* button : bar->findChildren<QToolButton*>()) {
                if (button->defaultAction() == nullptr) continue;
                EXPECT_EQ(button->toolButtonStyle(), Qt::ToolButtonIconOnly);
                all_seen = all_seen && button->isVisible();
            }
            const auto* rest = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
            ASSERT_NE(rest, nullptr);
            EXPECT_TRUE(all_seen || rest->isVisible());
        }
        window().addToolBar(Qt::TopToolBarArea, bar);
        wait_for([&] { return bar->width() > bar->height(); });
        QApplication::processEvents();
        EXPECT_EQ(bar->height(), lying) << "all lies again as it did";
    }
}

TEST_F(RoomWindow, TheStartPageShowsAllItsCanvases) {
    for (const char* language : kLanguages) {
        SCOPED_TRACE(language);
        open_small(language);
        for (const QSize& size : {kSmallScreen, QSize(1280, 800), QSize(1500, 900)}) {
            window().resize(size);
            wait_for([&] { return window().size() == size; });
            parts().start.show_page();
            QApplication::processEvents();
            const auto* page = window().findChild<start::StartPage*>();
            const auto* area = page->findChild<QScrollArea*>();
            EXPECT_LE(area->widget()->width(), area->viewport()->width());
            expect_nothing_cut(*area->widget());
            auto* sizes = page->findChild<panels::Gallery*>(QStringLiteral("canvas_sizes"));
            for (int row = 0; row < sizes->count(); ++row)
                EXPECT_TRUE(sizes->viewport()->rect().contains(
                    sizes->visualRect(sizes->model()->index(row, 0))))
                    << row;
        }
    }
}

/// A dialog comes up with two thirds of a screen's height at most, 533 pixels of 800.
TEST_F(RoomWindow, PensHaveRoomForAllTheirBoxesOnALowScreen) {
    constexpr QSize kScreen(1280, 800);
    for (const char* language : kLanguages) {
        SCOPED_TRACE(language);
        main::speak(QString::fromLatin1(language));
        panels::PenDialog dialog({}, &window());
        dialog.resize(dialog.sizeHint().width(), 2 * kScreen.height() / 3);
        dialog.show();
        wait_until_shown(dialog);
        QApplication::processEvents();
        const auto boxes = dialog.findChildren<QComboBox*>();
        EXPECT_EQ(boxes.size(), 6);
        for (const QComboBox* box : boxes)
            EXPECT_GE(box->height(), box->sizeHint().height()) << box->objectName().toStdString();
        EXPECT_LE(dialog.width(), kScreen.width());
        EXPECT_LE(dialog.height(), kScreen.height() - kBars);
    }
}

TEST_F(RoomWindow, NoNameOfAToolIsCut) {
    for (const char* language : kLanguages) {
        SCOPED_TRACE(language);
        open_small(language);
        auto* list = window().findChild<panels::BrushList*>();
        list->doItemsLayout();
        for (int row = 0; row < list->count(); ++row) {
            const QListWidgetItem* item = list->item(row);
            if (item->icon().isNull()) continue;  // the heading of a family has the whole row
            const QRect place = list->visualItemRect(item);
            constexpr int kEdges = 20;
            const int width = place.width() - list->iconSize().width() - kEdges;
            const QRect words =
                QFontMetrics(list->font())
                    .boundingRect(QRect(0, 0, width, 1000), Qt::TextWordWrap, item->text());
            EXPECT_LE(words.height(), place.height()) << item->text().toStdString();
            EXPECT_LE(place.right(), list->viewport()->width()) << item->text().toStdString();
        }
    }
}

TEST_F(RoomWindow, NoNameOfATubeIsCut) {
    for (const char* language : kLanguages) {
        SCOPED_TRACE(language);
        open_small(language);
        auto* panel = window().findChild<panels::PaintPanel*>();
        const auto* name = window().findChild<QLabel*>(QStringLiteral("tube_name"));
        for (const QString& tube : panel->tubes()) {
            panel->choose(tube);
            ASSERT_FALSE(name->text().isEmpty());
            const QRect words = name->fontMetrics().boundingRect(QRect(0, 0, name->width(), 1000),
                                                                 Qt::TextWordWrap, name->text());
            EXPECT_LE(words.height(), name->height()) << name->text().toStdString();
            EXPECT_LE(words.width(), name->width()) << name->text().toStdString();
        }
    }
}

/// Rows or cells of a list that are seen whole.
int seen_whole(const QListWidget& list) {
    int seen = 0;
    for (int row = 0; row < list.count(); ++row)
        seen += static_cast<int>(!list.item(row)->icon().isNull() &&
                                 list.viewport()->rect().contains(list.visualItemRect(list.item(row))));
    return seen;
}

TEST_F(RoomWindow, ShowsSixToolsAndTwelveTubesWithoutABarInABar) {
    constexpr int kTools = 6, kTubes = 12;
    for (const QSize& size : {QSize(1280, 800), kSmallScreen}) {
        open_another();
        window().resize(size);
        wait_for([&] { return window().size() == size; });
        QApplication::processEvents();
        auto& tools = *window().findChild<panels::BrushList*>();
        auto& tubes = *window().findChild<QListWidget*>(QStringLiteral("paints"));
        tools.scrollToTop();
        tubes.scrollToTop();
        if (size != kSmallScreen) {
            EXPECT_GE(seen_whole(tools), kTools);
            EXPECT_GE(seen_whole(tubes), kTubes);
        }
        for (const char* name : {"brushes_panel", "paints_panel"}) {
            const auto* dock = window().findChild<QDockWidget*>(QString::fromLatin1(name));
            const auto* area = qobject_cast<const QScrollArea*>(dock->widget());
            ASSERT_NE(area, nullptr);
            EXPECT_FALSE(area->verticalScrollBar()->isVisible()) << name << ", " << size.width();
        }
    }
}

TEST_F(RoomWindow, TheTabsOfAllPanelsKeepTheirNames) {
    for (QDockWidget* dock : window().findChildren<QDockWidget*>())
        dock->show();
    QApplication::processEvents();
    int bars = 0;
    for (const QTabBar* bar : window().findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (bar->count() == 0) continue;
        ++bars;
        for (int tab = 0; tab < bar->count(); ++tab)
            EXPECT_GT(bar->tabRect(tab).width(),
                      bar->fontMetrics().horizontalAdvance(bar->tabText(tab)))
                << bar->tabText(tab).toStdString();
    }
    EXPECT_GT(bars, 0);
}

/// Inside of its edges.
int colours_in(QWidget& button) {
    constexpr int kEdge = 3;
    const QImage seen = button.grab().toImage();
    std::set<QRgb> colours;
    for (int y = kEdge; y < seen.height() - kEdge; ++y)
        for (int x = kEdge; x < seen.width() - kEdge; ++x)
            colours.insert(seen.pixel(x, y));
    return static_cast<int>(colours.size());
}

TEST_F(RoomWindow, ArrowsLeadToTabsThatHaveNoRoom) {
    for (const appearance::Theme theme : {appearance::Theme::Dark, appearance::Theme::Light}) {
        SCOPED_TRACE(appearance::name_of(theme));
        appearance::apply_theme(*qApp, theme);
        QTabBar bar;
        bar.setUsesScrollButtons(true);
        for (int tab = 0; tab < 12; ++tab)
            bar.addTab(QStringLiteral("Navigator"));
        bar.setCurrentIndex(6);  // with tabs to either side
        bar.resize(240, bar.sizeHint().height());
        bar.show();
        wait_until_shown(bar);
        int arrows = 0;
        for (auto* button : bar.findChildren<QToolButton*>()) {
            if (!button->isVisible()) continue;
            ++arrows;
            EXPECT_GT(colours_in(*button), 1) << "arrow " << button->arrowType();
        }
        EXPECT_EQ(arrows, 2);
    }
    appearance::apply_theme(*qApp, appearance::Theme::Dark);
}

TEST_F(RoomWindow, TheMenuBarHasRoomForAllItsMenus) {
    for (const char* language : kLanguages) {
        open_small(language);
        const QMenuBar* bar = window().menuBar();
        for (QAction* menu : bar->actions()) {
            if (!menu->isVisible()) continue;
            EXPECT_TRUE(bar->rect().contains(bar->actionGeometry(menu)))
                << language << ": " << menu->text().toStdString();
        }
    }
}

/// In scripts without letters for mnemonics, menus have a letter in brackets behind their words.
TEST_F(RoomWindow, ButtonsHaveNoLettersOfMenus) {
    const QRegularExpression letter(QStringLiteral("\\([A-Z]\\)$"));
    for (const char* language : {"ja", "zh_TW"}) {
        open_small(language);
        EXPECT_TRUE(action(Command::GuideHandles)->text().remove(QLatin1Char('&')).contains(letter));
        for (const QToolButton* button : window().findChildren<QToolButton*>())
            EXPECT_FALSE(button->text().contains(letter)) << button->text().toStdString();
    }
}

TEST_F(RoomWindow, TimesHaveNoLettersOfOtherLanguages) {
    for (const char* language : kLanguages) {
        main::speak(QString::fromLatin1(language));
        const QString words = appearance::shown_time(QTime(23, 37));
        EXPECT_FALSE(words.contains(QLatin1Char('B'))) << words.toStdString();
        EXPECT_TRUE(words.contains(QStringLiteral("37"))) << words.toStdString();
    }
}

}  // namespace
}  // namespace pastoso::tests
