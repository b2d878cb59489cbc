// Paintings that were left unfinished, offered and brought back by the window.
#include "app/window_fixture.hpp"
#include "core/temporary_folder.hpp"
#include "dialogs/recovery_dialog.hpp"
#include "dialogs/unfinished_words.hpp"
#include "journal/recovery.hpp"
#include "main/program/language.hpp"
#include "main/window_parts.hpp"

#include <QAction>
#include <QCoreApplication>
#include <QListWidget>
#include <QPushButton>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class RecoveryWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (!HasFatalFailure()) pause();
    }
    void pause() { studio().commands().action(commands::Command::Pause)->trigger(); }

    std::vector<journal::Unfinished> unfinished() {
        return journal::unfinished_paintings(journal::journals_path());
    }
    std::uint64_t state() { return document::state_hash(session().capture().painting); }
    void paint() {
        mouse_stroke(line_mm({12.0, 12.0}, {48.0, 30.0}));
        settle();
    }
};

TEST_F(RecoveryWindow, APaintingThatWasNotClosedComesBack) {
    paint();
    const std::uint64_t painted = state();
    open_another();
    pause();
    ASSERT_THAT(unfinished(), SizeIs(1));
    parts().files.recover_painting(unfinished()[0].folder);
    loaded();
    settle();
    EXPECT_EQ(state(), painted);
    EXPECT_TRUE(window().isWindowModified());
    EXPECT_THAT(unfinished(), IsEmpty());

    open_another();
    ASSERT_THAT(unfinished(), SizeIs(1)) << "it is kept until it is saved";
    EXPECT_THAT(unfinished()[0].thumbnail, testing::StartsWith("\x89PNG"));
}

TEST_F(RecoveryWindow, ASavedPaintingIsNotOffered) {
    const TemporaryFolder folder;
    paint();
    parts().files.save_painting(QString::fromStdString((folder.path() / "a.pastoso").string()));
    ASSERT_EQ(parts().files.saver().wait().toStdString(), "");
    QCoreApplication::processEvents();
    window().close();
    open_another();
    EXPECT_THAT(unfinished(), IsEmpty());
}

TEST_F(RecoveryWindow, APaintingWithoutACheckpointIsShownTooAsItWasLeft) {
    paint();
    open_another();
    ASSERT_THAT(unfinished(), SizeIs(1));
    ASSERT_EQ(unfinished()[0].thumbnail, "");
    dialogs::RecoveryDialog dialog(unfinished(), &window());
    auto* list = dialog.findChild<QListWidget*>();
    const auto shown = [&] { return list->item(0)->icon().pixmap(96, 96).toImage(); };
    const QImage none = shown();
    wait_for([&] { return shown() != none; });
    EXPECT_EQ(dialog.chosen().thumbnail.substr(0, 4), "\x89PNG");
}

TEST_F(RecoveryWindow, ChangesAreCountedAsTheLanguageCountsThem) {
    journal::Unfinished painting;
    const auto words = [&](const char* language, std::size_t changes) {
        main::speak(QString::fromLatin1(language));
        painting.changes = changes;
        const std::string text = dialogs::unfinished_words(painting).toStdString();
        return text.substr(text.rfind(", ") + 2);
    };
    // Of a language that the program does not speak, English is spoken.
    for (const char* language : {"en", "en_GB", "de", "C"}) {
        EXPECT_EQ(words(language, 1), "1 change not saved") << language;
        EXPECT_EQ(words(language, 6), "6 changes not saved") << language;
    }
    EXPECT_NE(words("sv", 1).substr(2), words("sv", 6).substr(2));
    for (const char* language : {"ja", "zh_TW"})
        EXPECT_THAT(words(language, 6), HasSubstr("6"));
    main::speak(QStringLiteral("C"));
}

TEST_F(RecoveryWindow, TheDialogShowsAndDiscards) {
    paint();
    open_another();
    int asked = 0;
    bool agreed = false;
    dialogs::RecoveryDialog dialog(unfinished(), &window(), [&](const QString&) {
        ++asked;
        return agreed;
    });
    EXPECT_TRUE(dialog.recover_button()->isEnabled());
    dialog.discard_button()->click();
    EXPECT_EQ(dialog.count(), 1);
    agreed = true;
    dialog.discard_button()->click();
    EXPECT_EQ(dialog.count(), 0);
    EXPECT_EQ(asked, 2);
    EXPECT_THAT(unfinished(), IsEmpty());
}

}  // namespace
}  // namespace pastoso::tests
