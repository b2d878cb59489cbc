// Paintings saved from the window and opened in it.
#include "app/window_fixture.hpp"
#include "commands/recent_paintings.hpp"
#include "core/error.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "main/window_parts.hpp"

#include <cstdlib>

#include <QAction>
#include <QCoreApplication>
#include <QMenu>
#include <QMenuBar>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;

class ProjectWindow : public WindowTest {
  protected:
    void SetUp() override {
        ::setenv("XDG_DATA_HOME", data.path().c_str(), 1);
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        studio().commands().action(Command::Pause)->trigger();
    }
    void TearDown() override {
        WindowTest::TearDown();
        ::unsetenv("XDG_DATA_HOME");
    }

    std::string path(const char* name) const { return (folder.path() / name).string(); }

    /// Saves and waits for it.
    void save(const char* name) {
        parts().files.save_painting(QString::fromStdString(path(name)));
        EXPECT_EQ(parts().files.saver().wait().toStdString(), "");
        QCoreApplication::processEvents();
    }
    std::uint64_t state() { return document::state_hash(session().capture().painting); }

    TemporaryFolder data, folder;
};

TEST_F(ProjectWindow, APaintingIsSavedAndOpenedAsItWas) {
    mouse_stroke(line_mm({12.0, 12.0}, {48.0, 30.0}));
    settle();
    EXPECT_TRUE(window().isWindowModified());
    save("a.pastoso");
    EXPECT_FALSE(window().isWindowModified());
    EXPECT_THAT(window().windowTitle().toStdString(), testing::StartsWith("a.pastoso[*] "));
    const std::uint64_t saved = state();

    mouse_stroke(line_mm({12.0, 20.0}, {40.0, 10.0}));
    settle();
    EXPECT_TRUE(window().isWindowModified());
    EXPECT_NE(state(), saved);

    parts().files.open_painting(QString::fromStdString(path("a.pastoso")));
    loaded();
    settle();
    EXPECT_EQ(state(), saved);
    EXPECT_FALSE(window().isWindowModified());
    mouse_stroke(line_mm({12.0, 20.0}, {40.0, 10.0}));
    settle();
    EXPECT_TRUE(window().isWindowModified());
}

TEST_F(ProjectWindow, AFileThatIsNoneLeavesThePaintingOnTheEasel) {
    mouse_stroke(line_mm({12.0, 12.0}, {48.0, 30.0}));
    settle();
    const std::uint64_t before = state();
    core::write_text_file(path("bad.pastoso"), "nothing");
    parts().files.open_painting(QString::fromStdString(path("bad.pastoso")));
    loaded();
    ASSERT_THAT(studio().messages().standing(), testing::SizeIs(1));
    EXPECT_THAT(studio().messages().standing()[0].sentence.toStdString(),
                testing::HasSubstr("bad.pastoso"));
    EXPECT_EQ(state(), before);
    EXPECT_TRUE(window().isWindowModified());
    EXPECT_THAT(window().windowTitle().toStdString(), testing::StartsWith("Canvas[*] "));
}

TEST_F(ProjectWindow, AnotherCanvasIsNotThatFileAnyMore) {
    save("a.pastoso");
    parts().files.new_canvas(session().canvas());
    loaded();
    EXPECT_THAT(window().windowTitle().toStdString(), testing::StartsWith("Canvas[*] "));
}

TEST_F(ProjectWindow, TheLatestPaintingsStandInTheMenu) {
    EXPECT_TRUE(commands::recent_paintings().empty());
    save("a.pastoso");
    save("b.pastoso");
    save("a.pastoso");
    EXPECT_THAT(commands::recent_paintings(),
                testing::ElementsAre(path("a.pastoso"), path("b.pastoso")));
    std::filesystem::remove(path("a.pastoso"));
    EXPECT_THAT(commands::recent_paintings(), testing::ElementsAre(path("b.pastoso")));
    QMenu* file = window().menuBar()->actions().front()->menu();
    QMenu* recent = nullptr;
    for (const QAction* action : file->actions())
        if (action->menu() != nullptr) recent = action->menu();
    ASSERT_NE(recent, nullptr);
    Q_EMIT recent->aboutToShow();
    ASSERT_EQ(recent->actions().size(), 1);
    EXPECT_EQ(recent->actions().front()->text().toStdString(), path("b.pastoso"));
}

}  // namespace
}  // namespace pastoso::tests
