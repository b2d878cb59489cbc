// The manual beside the painting, in the real window.
#include "help/help_window.hpp"

#include "app/window_fixture.hpp"
#include "help/about_dialog.hpp"
#include "help/topic.hpp"
#include "main/panel_set.hpp"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTabWidget>
#include <QTest>
#include <QTextBlock>
#include <QTimer>
#include <QTreeWidget>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using testing::HasSubstr;

class HelpWindowTest : public WindowTest {
  protected:
    /// The key, with the pointer over the middle of a widget.
    help::HelpWindow* help_at(QWidget& widget) {
        if (auto* help = window().findChild<help::HelpWindow*>())
            help->hide();  // it lies over the panels
        QCursor::setPos(widget.mapToGlobal(widget.rect().center()));
        QApplication::setActiveWindow(&window());
        QTest::keyClick(&window(), Qt::Key_F1);
        return opened();
    }
    help::HelpWindow* opened() {
        auto* help = window().findChild<help::HelpWindow*>();
        if (help != nullptr) wait_until_shown(*help);
        return help;
    }
    QWidget& part(const char* type) {
        for (QWidget* widget : window().findChildren<QWidget*>())
            if (widget->inherits(type) && widget->isVisible()) return *widget;
        throw std::runtime_error(type);
    }
    /// The heading that was gone to, which is seen.
    static std::string heading(const help::HelpView& view) {
        EXPECT_TRUE(view.viewport()->rect().contains(view.cursorRect().center()));
        return view.textCursor().block().text().toStdString();
    }
};

TEST_F(HelpWindowTest, OpensAtWhatThePointerIsOver) {
    help::HelpWindow* help = help_at(canvas());
    ASSERT_NE(help, nullptr);
    EXPECT_EQ(help->view().page_name(), QStringLiteral("brushes"));
    EXPECT_EQ(heading(help->view()), "Brushes");
    help_at(part("pastoso::panels::EaselPanel"));
    EXPECT_EQ(help->view().page_name(), QStringLiteral("paint"));
    EXPECT_EQ(heading(help->view()), "Tilt and drying");
    help_at(part("pastoso::panels::ThinningSlider"));
    EXPECT_EQ(heading(help->view()), "From paste to stain");
    action(Command::MixingWell)->trigger();
    wait_until_shown(studio().well());
    help_at(studio().well());
    EXPECT_EQ(heading(help->view()), "The mixing well");
    help_at(*window().menuWidget());
    EXPECT_FALSE(help->view().page_name().isEmpty());
}

TEST_F(HelpWindowTest, HasATopicForEveryPanelThatIsSeen) {
    const auto panels = window().findChildren<QWidget*>();
    for (const QWidget* panel : panels)
        if (QByteArray(panel->metaObject()->className()).endsWith("Panel")) {
            EXPECT_FALSE(help::topic_of(panel).isEmpty()) << panel->metaObject()->className();
        }
}

TEST_F(HelpWindowTest, FindsAndFollows) {
    help::HelpWindow* help = help_at(canvas());
    auto& words = *help->findChild<QLineEdit*>(QStringLiteral("help_words"));
    auto& found = *help->findChild<QListWidget*>(QStringLiteral("help_found"));
    QTest::keyClick(help, Qt::Key_F, Qt::ControlModifier);
    QTest::keyClicks(&words, QStringLiteral("mixing well"));
    ASSERT_GE(found.count(), 2);
    EXPECT_TRUE(found.isVisible());
    found.setCurrentRow(0);
    EXPECT_EQ(help->view().page_name(), QStringLiteral("paint"));
    EXPECT_EQ(heading(help->view()), "The mixing well");
    QTest::keyClick(&words, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&words, QStringLiteral("gouache nowhere"));
    ASSERT_EQ(found.count(), 1);
    EXPECT_EQ(found.item(0)->flags(), Qt::NoItemFlags);
    words.clear();
    EXPECT_FALSE(found.isVisible());
    help->view().setSource(QUrl(QStringLiteral("layers.md#guides")));
    EXPECT_EQ(heading(help->view()), "Guides");
    auto& contents = *help->findChild<QTreeWidget*>(QStringLiteral("help_contents"));
    EXPECT_EQ(contents.currentItem()->text(0), QStringLiteral("Layers, guides and selections"));
    help->view().backward();
    EXPECT_EQ(help->view().page_name(), QStringLiteral("paint"));
    QTest::keyClick(&help->view(), Qt::Key_Escape);
    EXPECT_FALSE(help->isVisible());
}

/// In points; those of the page are as wide as it at most, and another width makes them anew.
TEST_F(HelpWindowTest, PicturesFitThePage) {
    action(Command::Manual)->trigger();
    help::HelpWindow* help = opened();
    help->view().show_topic(QStringLiteral("window"));
    for (const int width : {900, 600, 1100}) {
        help->resize(width, 700);
        QApplication::processEvents();
        EXPECT_EQ(help->view().horizontalScrollBar()->maximum(), 0) << width;
        EXPECT_EQ(help->view().page_name(), QStringLiteral("window"));
    }
}

TEST_F(HelpWindowTest, IsReadBesideADialog) {
    bool done = false;
    QTimer::singleShot(0, [&] {
        QWidget* dialog = QApplication::activeModalWidget();
        ASSERT_NE(dialog, nullptr);
        QTest::keyClick(dialog, Qt::Key_F1);
        auto* help = dialog->findChild<help::HelpWindow*>();
        ASSERT_NE(help, nullptr);
        EXPECT_TRUE(help->isVisible());
        EXPECT_EQ(help->view().page_name(), QStringLiteral("settings"));
        done = true;
        dialog->close();
    });
    QCursor::setPos(QPoint(0, 0));
    action(Command::EditSettings)->trigger();
    EXPECT_TRUE(done);
    EXPECT_NE(help_at(canvas()), nullptr) << "and beside the painting again";
}

TEST_F(HelpWindowTest, TellsWhatIsNew) {
    action(Command::WhatIsNew)->trigger();
    EXPECT_THAT(opened()->view().toPlainText().toStdString(),
                HasSubstr("What painters notice, newest first"));
}

TEST_F(HelpWindowTest, TellsWhatTheProgramIs) {
    std::string licence, copied;
    QStringList pages;
    QTimer::singleShot(0, [&] {
        auto* dialog = qobject_cast<help::AboutDialog*>(QApplication::activeModalWidget());
        ASSERT_NE(dialog, nullptr);
        auto* tabs = dialog->findChild<QTabWidget*>();
        for (int i = 0; i < tabs->count(); ++i)
            pages << tabs->tabText(i);
        licence =
            dialog->findChild<QPlainTextEdit*>(QStringLiteral("licence"))->toPlainText().toStdString();
        for (QPushButton* copy : dialog->findChildren<QPushButton*>(QStringLiteral("copy_facts"))) {
            copy->click();
            copied += QApplication::clipboard()->text().toStdString();
        }
        EXPECT_THAT(dialog->findChild<help::HelpView*>()->toPlainText().toStdString(),
                    HasSubstr("OpenImageIO"));
        dialog->close();
    });
    action(Command::About)->trigger();
    EXPECT_EQ(pages.size(), 5);
    EXPECT_THAT(licence, HasSubstr("GNU GENERAL PUBLIC LICENSE"));
    EXPECT_THAT(copied, HasSubstr("Qt " QT_VERSION_STR));
    EXPECT_THAT(copied, HasSubstr(settings_file().parent_path().string()));
}

}  // namespace
}  // namespace pastoso::tests
