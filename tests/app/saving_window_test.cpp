// What becomes of a painting whose file cannot be written, or that others have changed.
#include "app/window_fixture.hpp"
#include "commands/recent_paintings.hpp"
#include "core/file_size_limit.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "journal/recovery.hpp"
#include "main/window_parts.hpp"
#include "panels/messages/message_bar.hpp"

#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

namespace fs = std::filesystem;
using commands::Command;
using panels::Matter;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

class SavingWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (!HasFatalFailure()) action(Command::Pause)->trigger();
    }

    fs::path path(const char* name) const { return folder_.path() / name; }
    void paint(double y_mm = 20.0) {
        mouse_stroke(line_mm({12.0, y_mm}, {48.0, y_mm + 4.0}));
        settle();
    }
    void begin_saving(const fs::path& file) {
        parts().files.save_painting(QString::fromStdString(file.string()));
    }
    std::string wait() { return parts().files.saver().wait().toStdString(); }
    std::string title() { return window().windowTitle().toStdString(); }
    std::string standing(Matter matter) {
        for (const auto& message : studio().messages().standing())
            if (message.matter == matter) return message.sentence.toStdString();
        return {};
    }
    std::vector<journal::Unfinished> unfinished() {
        return journal::unfinished_paintings(journal::journals_path());
    }

    /// Answers the message box that comes by the button with these words, and a file dialog after it by
    /// leaving it; keeps what was asked.
    void answer(const char* words) {
        asked_.clear();
        auto* poll = new QTimer(&window());
        poll_ = poll;
        QObject::connect(poll, &QTimer::timeout, &window(), [this, words] {
            if (auto* files = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
                asked_ += " file dialog";
                return files->reject();
            }
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (box == nullptr) return;
            asked_ += box->text().toStdString();
            for (QAbstractButton* button : box->buttons())
                if (button->text().remove(QLatin1Char('&')) == QLatin1String(words))
                    return button->click();
            ADD_FAILURE() << "no button " << words << " on " << asked_;
            box->reject();
        });
        poll->start(10);
    }
    void stop_answering() { delete poll_; }
    std::string asked_when_saving(const char* answered_by) {
        answer(answered_by);
        parts().files.save();
        wait();
        stop_answering();
        return asked_;
    }

    TemporaryFolder folder_;
    std::string asked_;
    QTimer* poll_ = nullptr;
};

TEST_F(SavingWindow, WhatCannotBeSavedElsewhereKeepsItsFile) {
    paint();
    begin_saving(path("a.pastoso"));
    EXPECT_EQ(wait(), "");
    EXPECT_FALSE(window().isWindowModified());
    paint(28.0);
    begin_saving(path("missing") / "b.pastoso");
    EXPECT_THAT(wait(), HasSubstr("b.pastoso"));
    QApplication::processEvents();
    EXPECT_EQ(parts().files.path().toStdString(), path("a.pastoso").string());
    EXPECT_THAT(title(), StartsWith("a.pastoso[*] "));
    EXPECT_TRUE(window().isWindowModified());
    EXPECT_THAT(commands::recent_paintings(), ElementsAre(path("a.pastoso")));
    EXPECT_THAT(standing(Matter::Saving), HasSubstr("b.pastoso"));

    begin_saving(path("a.pastoso"));
    EXPECT_EQ(wait(), "") << "an error is told once";
    EXPECT_EQ(standing(Matter::Saving), "") << "it is saved after all";
    EXPECT_FALSE(window().isWindowModified());
}

TEST_F(SavingWindow, AnErrorOfOnePaintingDoesNotBlameTheNext) {
    paint();
    begin_saving(path("missing") / "b.pastoso");
    parts().files.new_canvas(session().canvas());
    loaded();
    settle();
    answer("Cancel");
    EXPECT_TRUE(parts().files.may_discard()) << asked_;
    stop_answering();
    EXPECT_EQ(asked_, "");
    EXPECT_FALSE(window().isWindowModified());
    EXPECT_EQ(standing(Matter::Saving), "");
}

TEST_F(SavingWindow, TheJournalKnowsWhichSavingHasEnded) {
    paint();
    begin_saving(path("a.pastoso"));
    // No event has its turn until the second saving is under way.
    mouse_stroke(line_mm({12.0, 28.0}, {48.0, 32.0}));
    begin_saving(path("missing") / "b.pastoso");
    wait();
    QApplication::processEvents();
    open_another();
    ASSERT_THAT(unfinished(), SizeIs(1)) << "the second stroke is in no file";
    EXPECT_GE(unfinished()[0].changes, 1U);
    EXPECT_EQ(unfinished()[0].painting, path("a.pastoso").string());
}

TEST_F(SavingWindow, AFileThatAnotherProgramHasChangedIsNotReplacedUnasked) {
    paint();
    begin_saving(path("a.pastoso"));
    wait();
    paint(28.0);
    begin_saving(path("b.pastoso"));
    wait();
    const std::string others = core::read_text_file(path("a.pastoso"));
    core::write_text_file(path("b.pastoso"), others);
    paint(32.0);

    EXPECT_THAT(asked_when_saving("Cancel"), HasSubstr("Another program has changed"));
    EXPECT_EQ(core::read_text_file(path("b.pastoso")), others);
    EXPECT_TRUE(window().isWindowModified());
    EXPECT_THAT(asked_when_saving("Save as..."), HasSubstr(" file dialog"));
    EXPECT_EQ(core::read_text_file(path("b.pastoso")), others);
    parts().files.save_by_itself();
    EXPECT_THAT(standing(Matter::Saving), HasSubstr("Another program has changed"));
    EXPECT_EQ(core::read_text_file(path("b.pastoso")), others) << "who paints is not asked";
    EXPECT_THAT(asked_when_saving("Replace"), HasSubstr("Another program has changed"));
    EXPECT_NE(core::read_text_file(path("b.pastoso")), others);
    EXPECT_FALSE(window().isWindowModified());
    EXPECT_EQ(standing(Matter::Saving), "");
}

TEST_F(SavingWindow, AFileThatIsAsItWasIsReplacedUnasked) {
    paint();
    begin_saving(path("a.pastoso"));
    wait();
    // Copied back: another inode, another time.
    core::write_text_file(path("a.pastoso"), core::read_text_file(path("a.pastoso")));
    paint(28.0);
    EXPECT_EQ(asked_when_saving("Cancel"), "");
    EXPECT_FALSE(window().isWindowModified());
    fs::remove(path("a.pastoso"));
    paint(32.0);
    EXPECT_EQ(asked_when_saving("Cancel"), "") << "nothing is lost where nothing is";
    EXPECT_TRUE(fs::exists(path("a.pastoso")));
}

TEST_F(SavingWindow, AWriteProtectedFileIsAskedFor) {
    paint();
    begin_saving(path("a.pastoso"));
    wait();
    fs::permissions(path("a.pastoso"), fs::perms::owner_read);
    paint(28.0);
    EXPECT_THAT(asked_when_saving("Cancel"), HasSubstr("protected"));
    EXPECT_TRUE(window().isWindowModified());
    EXPECT_THAT(asked_when_saving("Replace"), HasSubstr("protected"));
    EXPECT_FALSE(window().isWindowModified());
    EXPECT_EQ(fs::status(path("a.pastoso")).permissions(), fs::perms::owner_read) << "it stays protected";
}

TEST_F(SavingWindow, AFullDiskLeavesTheOldFileAndThePaintingGoesOn) {
    paint();
    begin_saving(path("a.pastoso"));
    wait();
    const std::string old = core::read_text_file(path("a.pastoso"));
    paint(28.0);
    {
        const FileSizeLimit limit(old.size() / 2);
        begin_saving(path("a.pastoso"));
        EXPECT_THAT(wait(), HasSubstr("a.pastoso: cannot be written"));
    }
    QApplication::processEvents();
    EXPECT_THAT(standing(Matter::Saving), HasSubstr("make room or choose another place"));
    EXPECT_EQ(core::read_text_file(path("a.pastoso")), old);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1) << "nothing else is left";
    const double before_mm3 = volume_mm3();
    paint(12.0);
    EXPECT_GT(volume_mm3(), before_mm3);
    begin_saving(path("a.pastoso"));
    EXPECT_EQ(wait(), "");
    EXPECT_EQ(standing(Matter::Saving), "");
}

TEST_F(SavingWindow, AJournalThatCannotBeWrittenIsSaidUntilItCan) {
    const auto strokes_file = [&] {
        for (const auto& entry : fs::directory_iterator(journal::journals_path()))
            return entry.path() / journal::kStrokesFile;
        return fs::path();
    };
    auto& bar = *window().findChild<panels::MessageBar*>();
    const double before_mm3 = volume_mm3();
    {
        const FileSizeLimit limit(fs::file_size(strokes_file()));
        paint();
        wait_for([&] { return bar.isVisible(); });
        EXPECT_THAT(standing(Matter::Journal), HasSubstr("would be lost"));
        EXPECT_GT(volume_mm3(), before_mm3) << "the painting goes on";
    }
    wait_for([&] { return !bar.isVisible(); });
    open_another();
    ASSERT_THAT(unfinished(), SizeIs(1));
    EXPECT_GE(unfinished()[0].changes, 1U) << "what was painted meanwhile is kept";
}

TEST_F(SavingWindow, AJournalThatCannotBeginBeginsOnceItCan) {
    begin_saving(path("a.pastoso"));
    wait();
    const fs::path root = journal::journals_path();
    fs::rename(root, path("kept"));
    core::write_text_file(root, "in the way");
    parts().files.open_painting(QString::fromStdString(path("a.pastoso").string()));
    loaded();
    settle();
    EXPECT_FALSE(session().has_journal());
    EXPECT_THAT(standing(Matter::Journal), HasSubstr("would be lost"));
    paint();
    fs::remove(root);
    action(Command::Pause)->trigger();  // time passes
    wait_for([&] { return standing(Matter::Journal).empty(); });
    EXPECT_TRUE(session().has_journal());
    action(Command::Pause)->trigger();
    settle();
    const std::uint64_t painted = document::state_hash(session().capture().painting);
    open_another();
    ASSERT_THAT(unfinished(), SizeIs(1));
    core::ThreadPool pool(1);
    const journal::Recovered recovered = journal::recover(unfinished()[0].folder, pool);
    EXPECT_EQ(document::state_hash(recovered.painting), painted)
        << "what was painted before the journal began is in it";
    EXPECT_THAT(recovered.notes, IsEmpty());
}

}  // namespace
}  // namespace pastoso::tests
