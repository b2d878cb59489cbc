// What the window tells: the line in which it passes, the list that keeps it, and the bar that stays.
#include "app/window_fixture.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "main/window_parts.hpp"
#include "panels/messages/message_bar.hpp"
#include "panels/messages/message_panel.hpp"
#include "panels/messages/wrapped_text.hpp"
#include "panels/parts/status_readings.hpp"
#include "start/start_page.hpp"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QPushButton>
#include <QStatusBar>
#include <QTest>
#include <QToolButton>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using panels::Matter;
using testing::HasSubstr;
using testing::Not;

class MessageWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (!HasFatalFailure()) action(Command::Pause)->trigger();
    }

    panels::MessageLog& log() { return studio().messages(); }
    panels::MessageBar& bar() { return *window().findChild<panels::MessageBar*>(); }
    QDockWidget& dock() { return *window().findChild<QDockWidget*>(QStringLiteral("messages_panel")); }
    std::string listed() { return window().findChild<panels::MessagePanel*>()->text().toStdString(); }
    template <class Button>
    void click(const char* name) {
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        auto* button = window().findChild<Button*>(QLatin1String(name));
        ASSERT_NE(button, nullptr) << name;
        QTest::mouseClick(button, Qt::LeftButton);
    }
};

TEST_F(MessageWindow, ReadingsGiveWayToASentenceThatTheyWouldCut) {
    const auto* readings = window().findChild<panels::StatusReadings*>();
    window().resize(1280, 700);
    wait_for([this] { return window().width() == 1280; });
    studio().report(QStringLiteral("Short."));
    EXPECT_TRUE(readings->isVisible());
    studio().report(QStringLiteral("A sentence of many words. ").repeated(6));
    EXPECT_FALSE(readings->isVisible());
    window().statusBar()->clearMessage();
    EXPECT_TRUE(readings->isVisible());
}

TEST_F(MessageWindow, TheListKeepsWhatPassedInTheStatusLine) {
    studio().report(QStringLiteral("First."));
    studio().report(QStringLiteral("Second."));
    EXPECT_EQ(told(), "Second.");
    EXPECT_THAT(listed(), HasSubstr("First."));
    EXPECT_THAT(listed(), HasSubstr("Second."));
    EXPECT_FALSE(bar().isVisible());

    EXPECT_FALSE(dock().isVisible());
    click<QToolButton>("show_messages");
    EXPECT_TRUE(dock().isVisible());
    click<QPushButton>("copy_messages");
    EXPECT_EQ(QApplication::clipboard()->text().toStdString(), listed());
    click<QPushButton>("clear_messages");
    EXPECT_EQ(listed(), "");
}

TEST_F(MessageWindow, AllNotesOfAFileCanBeRead) {
    studio().report_notes(
        QStringLiteral("a.ora"),
        {core::message("one is missing."), core::message("two are flat."), core::message("three.")});
    for (const char* note : {"One is missing.", "Two are flat.", "Three."})
        EXPECT_THAT(listed(), HasSubstr(note));
    EXPECT_TRUE(bar().isVisible());
    ASSERT_EQ(log().standing().size(), 1U);
    EXPECT_THAT(log().standing()[0].sentence.toStdString(), HasSubstr("a.ora"));
    click<QPushButton>("remedy");
    EXPECT_TRUE(dock().isVisible());
    EXPECT_TRUE(dock().isAncestorOf(QApplication::focusWidget()));

    studio().report_notes(QStringLiteral("b.ora"), {core::message("only one.")});
    ASSERT_EQ(log().standing().size(), 1U);
    EXPECT_EQ(log().standing()[0].sentence.toStdString(), "Only one.");
}

TEST_F(MessageWindow, TheBarStaysUntilItsMatterIsSolvedOrItIsPutAway) {
    log().raise({Matter::Journal, QStringLiteral("The disk is full.")});
    log().raise({Matter::Saving, QStringLiteral("Not saved.")});
    EXPECT_EQ(told().find("disk"), std::string::npos) << "the line would cut it off";
    studio().report(QStringLiteral("Something else."));
    EXPECT_TRUE(bar().isVisible());
    log().solve(Matter::Saving);
    EXPECT_TRUE(bar().isVisible());
    click<QPushButton>("put_away");
    EXPECT_FALSE(bar().isVisible());
    EXPECT_THAT(listed(), HasSubstr("The disk is full."));
    EXPECT_THAT(listed(), HasSubstr("Not saved."));
}

TEST_F(MessageWindow, TheBarShowsTheWholeSentenceHoweverNarrowTheWindow) {
    const QString path = QStringLiteral("/home/") + QString(300, QLatin1Char('x'));
    log().raise({Matter::Journal, path + QStringLiteral(": cannot be written.")});
    for (const int width : {1180, 900}) {
        window().resize(width, 640);
        QApplication::processEvents();
        const auto* text = bar().findChild<panels::WrappedText*>();
        ASSERT_NE(text, nullptr);
        EXPECT_GE(text->height(), text->heightForWidth(text->width()));
        EXPECT_TRUE(window().rect().contains(bar().geometry()));
        EXPECT_GT(text->heightForWidth(text->width()), 2 * text->fontMetrics().height());
    }
}

TEST_F(MessageWindow, TheCanvasStaysWhereItIsUnderTheBar) {
    const QRect before = canvas().geometry();
    log().raise({Matter::Journal, QStringLiteral("The disk is full.")});
    QApplication::processEvents();
    EXPECT_EQ(canvas().geometry(), before);
    action(Command::CanvasOnly)->trigger();
    QApplication::processEvents();
    EXPECT_TRUE(bar().isVisible()) << "nothing but the canvas, and what cannot wait";
    action(Command::CanvasOnly)->trigger();
}

TEST_F(MessageWindow, WhatIsRaisedDoesNotHideTheBar) {
    log().raise({Matter::Journal, QStringLiteral("The disk is full.")});
    QApplication::processEvents();
    for (QWidget* widget : {canvas().parentWidget(), window().centralWidget()}) {
        widget->raise();
        QApplication::processEvents();
        const QPoint middle = bar().geometry().center();
        QWidget* seen = window().childAt(middle);
        EXPECT_TRUE(seen == &bar() || bar().isAncestorOf(seen));
    }
}

TEST_F(MessageWindow, TheStartPageLeavesTheBarFree) {
    parts().start.show_page();
    auto* page = window().findChild<start::StartPage*>();
    log().raise({Matter::Opening, QStringLiteral("It cannot be opened.")});
    QApplication::processEvents();
    const auto place = [](const QWidget& widget) {
        return QRect(widget.mapToGlobal(QPoint(0, 0)), widget.size());
    };
    EXPECT_TRUE(page->isVisible());
    EXPECT_FALSE(place(*page).intersects(place(bar())));
}

TEST_F(MessageWindow, AFileThatCannotBeReadIsToldInTheWindow) {
    const TemporaryFolder folder;
    const auto loop = folder.path() / "loop.pastoso";
    std::filesystem::create_symlink(loop, loop);
    core::write_text_file(folder.path() / "bad.json", "{\"version\": 1, ");
    const auto under_file = folder.path() / "bad.json" / "a.pastoso";
    for (const std::filesystem::path& file :
         {loop, folder.path() / "missing.pastoso", folder.path() / "bad.json", under_file,
          folder.path() / (std::string(300, 'n') + ".pastoso"), folder.path() / "missing.png",
          folder.path() / "loop.pastoso" / "a.json"}) {
        SCOPED_TRACE(file.string());
        log().solve(Matter::Opening);
        const auto painting = session().snapshot();
        std::string fault;
        const auto telling =
            QObject::connect(&parts().loading, &main::Loading::failed, &window(),
                             [&](const QString& sentence) { fault = sentence.toStdString(); });
        window().open_file(file);
        loaded();
        QObject::disconnect(telling);
        EXPECT_THAT(fault, HasSubstr(file.filename().string().substr(0, 20)));
        EXPECT_THAT(fault, Not(HasSubstr("filesystem error")));
        EXPECT_THAT(listed(), HasSubstr(fault));
        EXPECT_TRUE(bar().isVisible());
        EXPECT_FALSE(parts().files.begun());
    }
}

}  // namespace
}  // namespace pastoso::tests
